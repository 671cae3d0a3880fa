/// Elastic, perfectly plastic soil with the criterion of Drucker and Prager: Bui, Fukagawa, Sako & Ohno (2008), Int. J. Numer. Anal. Meth. Geomech. 32:1537.
///
///   f = sqrt(J2) + alpha_phi I1 - k_c <= 0,   I1 = tr(sigma), J2 = s:s/2, s the deviator
///   alpha_phi = tan(phi)/sqrt(9 + 12 tan^2(phi)),  k_c = 3 c/sqrt(9 + 12 tan^2(phi))      (the criterion of Mohr and Coulomb in plane strain)
///   sigma^ = C:D - lambda' [ 3 K alpha_psi I + G/sqrt(J2) s ]
///   lambda' = [ 3 K alpha_phi tr(D) + G/sqrt(J2) s:D ]/(9 K alpha_phi alpha_psi + G),  at f = 0 and where it is positive; else 0
///
/// sigma^ [Pa/s] Jaumann rate, D [1/s] strain rate, C, G, K [Pa] those of ElasticLaw, phi friction angle, c [Pa] cohesion. alpha_psi is alpha_phi of the
/// dilatancy angle psi: psi = phi is the associated flow rule, psi = 0 flow at constant volume. (The paper's potential sqrt(J2) + 3 I1 sin(psi) is the same at
/// psi = 0, which is what it computes with.)
///
/// What truncation leaves outside is put back as in the paper: tension cracking, I1 > k_c/alpha_phi to I1 = k_c/alpha_phi, then sqrt(J2) to k_c - alpha_phi I1.
/// Verified by test/unit/soilLaws (strength in triaxial compression and extension, and in plane strain).
#pragma once
#include "ElasticLaw.hpp"
#include <fmt/format.h>
#include <numbers>

namespace sph
{

namespace entry::druckerPrager
{
inline const Scalar phi{"frictionAngle", degrees, required, Range{0, 90, true, false}, "phi, as in plane strain"},
    psi{"dilatancyAngle", degrees, byScene("0"), Range{0, 90, true, false}, "psi, at most phi; equal to it: the associated flow rule"},
    cohesion{"cohesion", units::pressure, 0, nonNegative, "c"};
}

struct DruckerPrager
{
    static constexpr auto name = "druckerPrager", meaning = "elastic and perfectly plastic, Bui et al. (2008)";
    static constexpr bool tensionless = false;
    ElasticLaw elastic;
    double alpha_phi = 0, alpha_psi = 0; ///< [1]
    double k_c = 0;                      ///< [Pa]

    /// alpha of an angle in degrees.
    static double alphaOf(double angle)
    {
        const double t = std::tan(angle * std::numbers::pi / 180);
        return t / std::sqrt(9 + 12 * t * t);
    }
    static DruckerPrager of(ElasticLaw elastic, double frictionAngle, double dilatancyAngle, double cohesion)
    {
        const double t = std::tan(frictionAngle * std::numbers::pi / 180);
        return {elastic, alphaOf(frictionAngle), alphaOf(dilatancyAngle), 3 * cohesion / std::sqrt(9 + 12 * t * t)};
    }

    /// f [Pa], and the width of what counts as f = 0, by rounding.
    double yield(SymmTensor<3> sigma) const { return rootJ2(sigma) + alpha_phi * trace(sigma) - k_c; }
    double width(SymmTensor<3> sigma) const { return 1e-9 * (norm(sigma) + k_c); }

    bool yields(SymmTensor<3> sigma) const { return yield(sigma) >= -width(sigma); }

    SymmTensor<3> rate(SymmTensor<3> sigma, SymmTensor<3> D) const
    {
        const auto trial = elastic.rate(sigma, D);
        if (!yields(sigma)) return trial;
        const double J = rootJ2(sigma), G = elastic.G, K = elastic.K;
        const auto n = J > width(sigma) ? 1 / J * deviator(sigma) : SymmTensor<3>{};
        const double lambda = (3 * K * alpha_phi * trace(D) + G * doubleDot(n, D)) / (9 * K * alpha_phi * alpha_psi + G);
        return lambda > 0 ? trial - lambda * (3 * K * alpha_psi * identity(D) + G * n) : trial;
    }
    double stiffness(SymmTensor<3> = {}) const { return elastic.stiffness(); }
    bool admits(SymmTensor<3> sigma) const { return yield(sigma) <= width(sigma); }
    SymmTensor<3> returned(SymmTensor<3> sigma) const
    {
        if (yield(sigma) <= 0) return sigma;
        const auto I = identity(sigma);
        const auto s = deviator(sigma);
        const double I1 = alpha_phi * trace(sigma) > k_c ? k_c / alpha_phi : trace(sigma), J = rootJ2(sigma);
        const double allowed = std::fmax(0.0, k_c - alpha_phi * I1);
        return I1 / 3 * I + (J > allowed ? allowed / J : 1.0) * s;
    }

    static EntryList entries()
    {
        return ElasticLaw::entries() + EntryList{entry::druckerPrager::phi, entry::druckerPrager::psi, entry::druckerPrager::cohesion};
    }
    static DruckerPrager read(const Dictionary& d)
    {
        namespace e = entry::druckerPrager;
        const auto elastic = ElasticLaw::read(d);
        const double phi = e::phi(d), psi = e::psi(d, 0), c = e::cohesion(d);
        if (psi > phi)
            e::psi.error(d, fmt::format("dilatancyAngle {:.6g} is above frictionAngle {:.6g}: such soil would make work of nothing", psi,
                                        phi));
        if (e::phi.given(d) && phi == 0 && c == 0) e::phi.error(d, "frictionAngle and cohesion are both 0: such soil has no strength");
        return of(elastic, phi, psi, c);
    }

private:
    static double rootJ2(SymmTensor<3> sigma) { return norm(deviator(sigma)) / std::numbers::sqrt2; }
};

}
