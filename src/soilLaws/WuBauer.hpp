/// Hypoplastic law of sand: Wu & Bauer (1994), as eq. (17) of Peng, Wu & Yu (2014):
///
///   sigma^ = c1 tr(sigma) D + c2 tr(sigma.D)/tr(sigma) sigma + (c3 sigma.sigma + c4 sigma*.sigma*)/tr(sigma) |D|
///          = tr(sigma) [ c1 D + c2 (r:D) r + (c3 r.r + c4 r*.r*) |D| ],       r = sigma/tr(sigma)
///
/// sigma^ [Pa/s] Jaumann rate, sigma [Pa] stress, tension positive (the law is odd in it), D [1/s] strain rate, extension positive, sigma* the
/// deviator, |D| = sqrt(D:D), c1 ... c4 [1]. Constants published for compression-positive strain rates are -c1, -c2, c3, c4 of these. r in place of sigma
/// keeps the squares from underflow. Homogeneous in sigma and, of degree one, in D. Its integral never has a tensile principal stress where
/// c4 > 9 |c1|: at sigma_i = 0, d|sigma_i|/dt >= |tr(sigma)| |D| (c4/9 - |c1|). The constants of loose Karlsruhe sand are -69.4, -673.1, -655.9, 699.6.
/// Erratum of Peng et al. (2014), list of constants: the 699.6 printed as c2 is c4.
/// Verified by test/unit/soilLaws (an independent integrator of order 8; K_0, isotropic exponents and limits by hand).
#pragma once
#include "soilLaws/ConstitutiveLaw.hpp"
#include <fmt/format.h>

namespace sph
{

namespace entry::wuBauer
{
inline const Scalar c1{"c1", units::none, required, "of tr(sigma) D, negative"},
    c2{"c2", units::none, required, "of tr(sigma.D)/tr(sigma) sigma"}, c3{"c3", units::none, required, "of sigma.sigma/tr(sigma) |D|"},
    c4{"c4", units::none, required, "of the deviator's square, sigma*.sigma*/tr(sigma) |D|, positive"};
}

struct WuBauer
{
    static constexpr auto name = "wuBauer", meaning = "hypoplastic, Wu and Bauer (1994)";
    static constexpr bool tensionless = true;
    double c1 = 0, c2 = 0, c3 = 0, c4 = 0;

    SymmTensor<3> rate(SymmTensor<3> sigma, SymmTensor<3> D) const
    {
        const auto r = 1 / trace(sigma) * sigma;
        return trace(sigma) * (c1 * D + c2 * doubleDot(r, D) * r + norm(D) * (c3 * square(r) + c4 * square(deviator(r))));
    }
    /// |c1| |tr(sigma)| + (|c2| + |c3|) sigma_max^2/|tr(sigma)|, above the modulus of unloading: by 5 % at rest, at K_0.
    double stiffness(SymmTensor<3> sigma) const
    {
        const double most = std::abs(leastEigenvalue(sigma)), tr = std::abs(trace(sigma));
        return tr > 0 ? std::abs(c1) * tr + (std::abs(c2) + std::abs(c3)) * sqr(most) / tr : 0;
    }
    bool admits(SymmTensor<3> sigma) const { return isCompressive(sigma); }
    SymmTensor<3> returned(SymmTensor<3> sigma) const { return sigma; }

    /// Earth pressure at rest sigma_xx/sigma_zz of monotonic compression along z, the root in (0, 1) of eq. (21):
    ///
    ///   (36 c1 - 4 c4) K^3 + (36 c1 + 9 c3 + 9 c4) K^2 + (9 c1 - 9 c3 - 6 c4) K + c4 = 0
    ///
    /// It is c4 at K = 0 and 81 c1 at K = 1: there is a root if c1 < 0 < c4. None otherwise.
    std::optional<double> K0() const
    {
        if (!(c1 < 0 && c4 > 0)) return {};
        double low = 0, high = 1;
        for (int bisections = 0; bisections < 60; ++bisections)
        {
            const double K = 0.5 * (low + high);
            const double value = (((36 * c1 - 4 * c4) * K + 36 * c1 + 9 * c3 + 9 * c4) * K + 9 * c1 - 9 * c3 - 6 * c4) * K + c4;
            (value > 0 ? low : high) = K;
        }
        return 0.5 * (low + high);
    }

    static EntryList entries() { return {entry::wuBauer::c1, entry::wuBauer::c2, entry::wuBauer::c3, entry::wuBauer::c4}; }
    static WuBauer read(const Dictionary& d)
    {
        namespace e = entry::wuBauer;
        const WuBauer law{e::c1(d), e::c2(d), e::c3(d), e::c4(d)};
        const bool all = e::c1.given(d) && e::c2.given(d) && e::c3.given(d) && e::c4.given(d);
        if (all && !law.K0())
            (law.c1 < 0 ? e::c4 : e::c1)
                .error(
                    d,
                    fmt::format(
                        "c1 = {:.6g}, c4 = {:.6g} give no earth pressure at rest, K_0, between 0 and 1: that needs c1 < 0 < c4. Constants "
                        "for compression-positive strain rates have c1 and c2 of the other sign",
                        law.c1, law.c4));
        else if (all && !(law.c4 > 9 * std::abs(law.c1)))
            d.diagnostics().warning(e::c4.where(d),
                                    fmt::format("c4 = {:.6g} is not above 9 |c1| = {:.6g}: some strain paths lead to tension, and are not "
                                                "resolved there",
                                                law.c4, 9 * std::abs(law.c1)));
        return law;
    }
};

}
