/// Elastic, perfectly plastic soil with the criterion of Drucker and Prager: Bui, Fukagawa, Sako & Ohno (2008), Int. J. Numer. Anal. Meth. Geomech. 32:1537.
///
///   f = sqrt(J2) + alpha_phi I1 - k_c <= 0,   I1 = tr(sigma), J2 = s:s/2, s the deviator
///   sigma^ = C:D - lambda' [ 3 K alpha_psi I + G n ],   n = s/sqrt(J2)
///   lambda' = [ 3 K alpha_phi tr(D) + G n:D ]/(9 K alpha_phi alpha_psi + G),  at f = 0 and where it is positive; else 0
///
/// sigma^ [Pa/s] Jaumann rate, D [1/s] strain rate, C, G, K [Pa] those of ElasticLaw, lambda' [1/s] rate of the plastic multiplier: plastic
/// strain grows by lambda' (alpha_psi I + n/2).
///
/// The constants are those of the criterion of Mohr and Coulomb in plane strain, with friction angle phi, cohesion c [Pa] and dilatancy
/// angle psi:
///
///   alpha_psi = sin(psi)/q,   alpha_phi = q sin(phi)/(3 (3 + sin(phi) sin(psi))),   k_c = q c cos(phi)/(3 + sin(phi) sin(psi)),   q = sqrt(9 + 3 sin^2(psi))
///
/// At the limit stresses stay, so that all strain is plastic, and none is across the plane: n_yy = -2 alpha_psi, and with it, for the half
/// difference t and the half sum m of the two principal stresses in the plane, t = sqrt(J2) sqrt(1 - 3 alpha_psi^2) and I1 = 3 m - 3
/// alpha_psi sqrt(J2). f = 0 is then
///
///   t = sqrt(1 - 3 alpha_psi^2)/(1 - 3 alpha_phi alpha_psi) (k_c - 3 alpha_phi m),   of Mohr and Coulomb: t = c cos(phi) - m sin(phi)
///
/// and the ratio of the plastic strain rates there, 3 alpha_psi/sqrt(1 - 3 alpha_psi^2), is the sine of the dilatancy angle in the plane
/// (the plane strain match of the Abaqus Analysis User's Guide, section on extended Drucker-Prager models, in the letters above). For psi =
/// phi, the associated flow rule, these are the constants of Drucker & Prager (1952) that Bui et al. take, alpha_phi = tan(phi)/sqrt(9 + 12
/// tan^2(phi)); with psi = 0, flow at constant volume, alpha_phi = sin(phi)/3, k_c = c cos(phi), for which the constants of psi = phi would
/// act as 28.7 degrees where 30 are asked for.
///
/// At the vertex of the cone, s = 0, n has the direction of the strain rate's deviator, in which the stress leaves it; soil that is pulled
/// apart stays there. What truncation leaves outside is put back as in the paper: tension cracking, I1 > k_c/alpha_phi to I1 =
/// k_c/alpha_phi, then sqrt(J2) to k_c - alpha_phi I1. Verified by test/unit/elementTests (strength in triaxial compression and extension,
/// and in plane strain at any psi) and test/unit/soilLaws (the yield surface, its vertex, and the way to it).
#pragma once
#include "soilLaws/ConeFlow.hpp"
#include "soilLaws/ElasticLaw.hpp"
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

    static DruckerPrager of(ElasticLaw elastic, double frictionAngle, double dilatancyAngle, double cohesion)
    {
        constexpr double degree = std::numbers::pi / 180;
        const double sinPhi = std::sin(frictionAngle * degree);
        return of(elastic, sinPhi, std::cos(frictionAngle * degree), std::sin(dilatancyAngle * degree), cohesion);
    }
    static DruckerPrager of(ElasticLaw elastic, double sinPhi, double cosPhi, double sinPsi, double cohesion)
    {
        const double q = std::sqrt(9 + 3 * sqr(sinPsi)), d = 3 + sinPhi * sinPsi;
        return {elastic, q * sinPhi / (3 * d), sinPsi / q, q * cohesion * cosPhi / d};
    }
    double sinPhi() const { return 3 * alpha_phi * std::sqrt(1 - 3 * sqr(alpha_psi)) / (1 - 3 * alpha_phi * alpha_psi); }
    double sinPsi() const { return 3 * alpha_psi / std::sqrt(1 - 3 * sqr(alpha_psi)); }
    double cohesion() const { return k_c * (3 + sinPhi() * sinPsi()) / std::sqrt((9 + 3 * sqr(sinPsi())) * (1 - sqr(sinPhi()))); }
    /// c and tan(phi) over F, in plane strain; psi stays, up to phi.
    DruckerPrager reduced(double F) const
    {
        const double weaker = reducedSinPhi(sinPhi(), F);
        return of(elastic, weaker, std::sqrt(1 - sqr(weaker)), std::fmin(sinPsi(), weaker), cohesion() / F);
    }

    /// The friction angles that act [degrees]: what is asked for in plane strain, and that in triaxial compression, sin = 3 sqrt(3)
    /// alpha_phi/(2 + sqrt(3) alpha_phi).
    struct FrictionAngles
    {
        double planeStrain, triaxialCompression;
    };
    FrictionAngles frictionAngles() const
    {
        constexpr double degree = std::numbers::pi / 180, root3 = std::numbers::sqrt3;
        return {std::asin(sinPhi()) / degree, std::asin(3 * root3 * alpha_phi / (2 + root3 * alpha_phi)) / degree};
    }

    /// f [Pa], and the width of what counts as f = 0, by rounding.
    double yield(SymmTensor<3> sigma) const { return rootJ2(sigma) + alpha_phi * trace(sigma) - k_c; }
    double width(SymmTensor<3> sigma) const { return 1e-9 * (norm(sigma) + k_c + smallStress()); }
    bool yields(SymmTensor<3> sigma) const { return yield(sigma) >= -width(sigma); }

    SymmTensor<3> rate(SymmTensor<3> sigma, SymmTensor<3> D) const
    {
        const auto trial = elastic.rate(sigma, D);
        if (!yields(sigma)) return trial;
        const auto n = direction(sigma, D);
        const double G = elastic.G, K = elastic.K, lambda = std::fmax(0.0, loading(n, D)) / hardness();
        if (lambda > 0 && trace(D) >= 3 * alpha_psi * lambda && isVertex(sigma)) return {}; // pulled apart
        return trial - lambda * (3 * K * alpha_psi * identity(D) + G * n);
    }
    /// The stress after a strain at a constant rate [Pa], from one that is admitted: elastic as far as the cone, and from there along it
    /// (ConeFlow.hpp). `tolerance` [1] of the larger of the stress and smallStress.
    SymmTensor<3> strained(SymmTensor<3> sigma, SymmTensor<3> strain, const EmbeddedPair& pair, double tolerance, SubSteps& taken) const
    {
        const double share = elasticShare(sigma, strain);
        const double allowed = tolerance * std::fmax(norm(sigma), smallStress());
        sigma += share * elastic.rate(sigma, strain);
        return share < 1 ? flowed(sigma, (1 - share) * strain, pair, allowed, taken) : sigma;
    }
    /// The share of a strain, from a stress that is admitted, before the stress is on the yield surface and stays there; 1 where it does
    /// not come to that. The elastic path is straight, and crosses the cone where J2 = (k_c - alpha_phi I1)^2.
    double elasticShare(SymmTensor<3> sigma, SymmTensor<3> strain) const
    {
        const bool onSurface = yields(sigma);
        if (onSurface && loading(direction(sigma, strain), strain) > 0) return 0;
        const auto s = deviator(sigma), change = 2 * elastic.G * deviator(strain);
        const double R = k_c - alpha_phi * trace(sigma), approach = 3 * elastic.K * alpha_phi * trace(strain);
        // a t^2 + 2 b t + c = 0
        const double a = 0.5 * doubleDot(change, change) - sqr(approach), b = 0.5 * doubleDot(s, change) + R * approach;
        const double c = onSurface ? 0 : 0.5 * doubleDot(s, s) - sqr(R), root = std::sqrt(std::fmax(0.0, b * b - a * c));
        const double t = b > 0 ? -c / (b + root) : a > 0 ? (root - b) / a : 1;
        return std::fmin(1.0, t);
    }
    double smallStress() const { return smallStrain * elastic.stiffness(); }
    double stiffness(SymmTensor<3> = {}) const { return elastic.stiffness(); }
    bool admits(SymmTensor<3> sigma) const { return yield(sigma) <= width(sigma); }
    SymmTensor<3> returned(SymmTensor<3> sigma) const
    {
        if (!yields(sigma)) return sigma;
        if (isVertex(sigma)) return k_c / (3 * alpha_phi) * identity(sigma);
        if (yield(sigma) <= 0) return sigma;
        const double I1 = alpha_phi * trace(sigma) > k_c ? k_c / alpha_phi : trace(sigma);
        return I1 / 3 * identity(sigma) + std::fmin(1.0, (k_c - alpha_phi * I1) / rootJ2(sigma)) * deviator(sigma);
    }

    double beyond(SymmTensor<3> sigma) const { return norm(returned(sigma) - sigma); }

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
    double hardness() const { return 9 * elastic.K * alpha_phi * alpha_psi + elastic.G; }
    /// Along the cone.
    SymmTensor<3> flowed(SymmTensor<3> sigma, SymmTensor<3> strain, const EmbeddedPair& pair, double allowed, SubSteps& taken) const
    {
        const auto e = deviator(strain), s = deviator(sigma);
        const double G = elastic.G, K = elastic.K, size = norm(e), r = norm(s);
        const ConeFlow flow{2 * G * size * (1 - G / hardness()), -3 * std::numbers::sqrt2 * G * K * alpha_phi * trace(strain) / hardness(),
                            2 * G * size};
        const auto towards = size > 0 ? 1 / size * e : SymmTensor<3>{};
        const auto at = [&](double rNow, SymmTensor<3> unit)
        {
            const double I1 = alpha_phi > 0 ? (k_c - rNow / std::numbers::sqrt2) / alpha_phi : trace(sigma) + 3 * K * trace(strain);
            return I1 / 3 * identity(sigma) + rNow * unit;
        };
        if (isVertex(sigma)) return at(std::fmax(0.0, flow.a + flow.b), towards);
        const double cosine = doubleDot(s, towards) / r;
        const auto aside = 1 / r * s - cosine * towards;
        const double sine = std::fmax(norm(aside), std::numeric_limits<double>::min());
        const auto end = flow.end({std::log(sine / (1 + cosine)), r}, pair, allowed, taken);
        return at(end.r, 1 / std::cosh(end.u) / sine * aside - std::tanh(end.u) * towards);
    }
    bool isVertex(SymmTensor<3> sigma) const { return !(rootJ2(sigma) > width(sigma)); }
    /// n, of |n| = sqrt(2); 0 at the vertex under a change of volume alone.
    SymmTensor<3> direction(SymmTensor<3> sigma, SymmTensor<3> D) const
    {
        const auto along = deviator(isVertex(sigma) ? D : sigma);
        const double J = norm(along) / std::numbers::sqrt2;
        return J > 0 ? 1 / J * along : SymmTensor<3>{};
    }
    /// Positive where the elastic rate leads out of the yield surface.
    double loading(SymmTensor<3> n, SymmTensor<3> D) const { return 3 * elastic.K * alpha_phi * trace(D) + elastic.G * doubleDot(n, D); }
    static double rootJ2(SymmTensor<3> sigma) { return norm(deviator(sigma)) / std::numbers::sqrt2; }
};

}
