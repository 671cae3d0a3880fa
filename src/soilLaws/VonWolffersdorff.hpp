/// Hypoplastic law of sand with pressure and density: von Wolffersdorff (1996), Mech. Cohes.-Frict. Mater. 1:251, with the limits of the
/// void ratio of Bauer (1996), Soils and Foundations 36(1):13:
///
///   sigma^ = f_b f_e/(r:r) [ F^2 D + a^2 r (r:D) + f_d F a (r + r*) |D| ],      de/dt = (1 + e) tr(D)
///
///   r = sigma/tr(sigma), r* = r - I/3,   a = sqrt(3) (3 - sin(phi_c))/(2 sqrt(2) sin(phi_c))
///   F = sqrt( t^2/8 + (2 - t^2)/(2 + sqrt(2) t c) ) - t/(2 sqrt(2)),   t = sqrt(3) |r*|,   c = cos(3 theta) = -sqrt(6) tr(r*^3)/|r*|^3
///   e_i/e_i0 = e_c/e_c0 = e_d/e_d0 = exp[ -(3 p/h_s)^n ]
///   f_d = [ (e - e_d)/(e_c - e_d) ]^alpha,   f_e = (e_c/e)^beta
///   f_b = h_s/n (e_i0/e_c0)^beta (1 + e_i)/e_i (3 p/h_s)^(1-n)/[ 3 + a^2 - a sqrt(3) ((e_i0 - e_d0)/(e_c0 - e_d0))^alpha ]
///
/// sigma^ [Pa/s] Jaumann rate, sigma [Pa] effective stress, tension positive, p = -tr(sigma)/3, D [1/s] strain rate, extension positive, |D| =
/// sqrt(D:D), e [1] void ratio, phi_c critical friction angle, h_s [Pa] granulate hardness, and n its exponent; e_i, e_c, e_d [1] the void
/// ratios of the loosest, the critical and the densest state at the pressure, of index 0 at none; alpha, beta [1] of the peak strength and
/// of the stiffness. F is 1 in triaxial compression, and makes the critical states the cone of Matsuoka and Nakai. Isotropic compression
/// from e_i stays on e_i. The law holds from e_d to e_i at the pressure of the soil: looser, the grains do not touch, and the soil is
/// free of stress; denser, the step is refused, and the stress stays.
///
/// | sand | phi_c | h_s | n | e_d0 | e_c0 | e_i0 | alpha | beta |
/// |---|---|---|---|---|---|---|---|---|
/// | Karlsruhe, medium (Herle & Gudehus 1999) | 30 | 5.8 GPa | 0.28 | 0.53 | 0.84 | 1.00 | 0.13 | 1.05 |
/// | Hochstetten (von Wolffersdorff 1996) | 33 | 1.0 GPa | 0.25 | 0.55 | 0.95 | 1.05 | 0.25 | 1.5 |
///
/// both as later users of the law repeat them. Verified by test/unit/soilLaws (rates of random states, critical states, isotropic
/// compression) and tutorials/geomechanics/triaxialSands (drained, undrained, oedometer, against independent integrators).
#pragma once
#include "soilLaws/ConstitutiveLaw.hpp"
#include <fmt/format.h>
#include <numbers>

namespace sph
{

namespace entry::vonWolffersdorff
{
inline const Scalar phi_c{"phi_c", degrees, required, Range{0, 90, false, false}, "critical friction angle"},
    h_s{"h_s", units::pressure, required, positive, "granulate hardness"},
    n{"n", units::none, required, positiveBelow(1), "exponent of 3 p/h_s"},
    e_d0{"e_d0", units::none, required, positive, "void ratio of the densest state without pressure"},
    e_c0{"e_c0", units::none, required, positive, "of the critical state, above e_d0"},
    e_i0{"e_i0", units::none, required, positive, "of the loosest state, above e_c0"},
    alpha{"alpha", units::none, required, nonNegative, "exponent of the relative density in f_d: the peak friction angle"},
    beta{"beta", units::none, required, nonNegative, "exponent of e_c/e in f_e: the stiffness of dense soil"};
}

struct VonWolffersdorff
{
    static constexpr auto name = "vonWolffersdorff", meaning = "hypoplastic sand with void ratio, von Wolffersdorff (1996)";
    static constexpr bool tensionless = true;
    using Variables = VoidRatio;
    using State = SoilState<VoidRatio>;
    double h_s = 0, n = 0, e_d0 = 0, e_c0 = 0, e_i0 = 0, alpha = 0, beta = 0;
    double a = 0;   ///< [1], of phi_c
    double b_0 = 0; ///< f_b without its pressure and 1 + 1/e_i [Pa]
    double p_0 = 0; ///< pressure at which e_i is e_c0 [Pa]

    static VonWolffersdorff of(double phi_c, double h_s, double n, double e_d0, double e_c0, double e_i0, double alpha, double beta)
    {
        const double sine = std::sin(phi_c * std::numbers::pi / 180);
        VonWolffersdorff law{h_s, n, e_d0, e_c0, e_i0, alpha, beta, std::sqrt(0.375) * (3 - sine) / sine};
        law.p_0 = h_s / 3 * std::pow(std::log(e_i0 / e_c0), 1 / n);
        law.b_0 = h_s / n * std::pow(e_i0 / e_c0, beta) / law.bracket();
        return law;
    }
    /// 3 + a^2 - a sqrt(3) f_d of the loosest state: what f_b is divided by, so that e_i is a path of isotropic compression.
    double bracket() const { return 3 + a * a - a * std::numbers::sqrt3 * std::pow((e_i0 - e_d0) / (e_c0 - e_d0), alpha); }

    /// e over e of no pressure, of the three limits alike.
    double compression(double p) const { return std::exp(-std::pow(3 * p / h_s, n)); }

    /// The law at a state: sigma^ = L:D + N |D|, L:D = scale (F^2 D + a^2 r (r:D)).
    struct Tangent
    {
        double scale, F2, a2; ///< scale = f_b f_e/(r:r) [Pa]
        SymmTensor<3> r, N;
        SymmTensor<3> linear(SymmTensor<3> D) const { return scale * (F2 * D + a2 * doubleDot(r, D) * r); }
    };
    Tangent tangent(const State& s) const
    {
        const auto r = 1 / trace(s.stress) * s.stress, r_d = deviator(r);
        // Powers by one logarithm each: they are most of the cost.
        const double x = -trace(s.stress) / h_s, x_n = std::exp(n * std::log(x)), limit = std::exp(-x_n), e = s.variables.e;
        const double e_i = e_i0 * limit, density = (e - e_d0 * limit) / ((e_c0 - e_d0) * limit);
        const double f_d = density > 0 ? std::exp(alpha * std::log(density)) : 0;
        const double f_e = std::exp(beta * (std::log(e_c0 / e) - x_n));
        const double f_b = b_0 * (1 + e_i) / e_i * x / x_n;
        const double F = shape(r_d), scale = f_b * f_e / doubleDot(r, r);
        return {scale, F * F, a * a, r, scale * f_d * F * a * (r + r_d)};
    }
    /// F, from the deviator of r.
    static double shape(SymmTensor<3> r_d)
    {
        constexpr double root2 = std::numbers::sqrt2, isotropic = 1e-40; // below it is round-off, and its cube may vanish where it does not
        const double square_d = doubleDot(r_d, r_d), t = std::sqrt(3 * square_d);
        const double cubes = doubleDot(square(r_d), r_d),
                     c = square_d > isotropic ? -std::sqrt(6.0) * cubes / (square_d * std::sqrt(square_d)) : -1;
        return std::sqrt(t * t / 8 + (2 - t * t) / (2 + root2 * t * std::clamp(c, -1.0, 1.0))) - t / (2 * root2);
    }

    State rate(const State& s, SymmTensor<3> D) const
    {
        const auto at = tangent(s);
        return {at.linear(D) + norm(D) * at.N, {(1 + s.variables.e) * trace(D)}};
    }
    /// Bound of the modulus of unloading along the largest principal stress, L and N of F = 1 together.
    double stiffness(const State& s) const { return -trace(s.stress) > 0 ? bound(s, 1) : 0; }
    /// The same with L taken m times.
    double bound(const State& s, double m) const
    {
        const auto at = tangent(s);
        const double most = leastEigenvalue(s.stress) / trace(s.stress), f_d_F_a = norm(at.N) / (at.scale * norm(at.r + deviator(at.r)));
        return at.scale * (m * (1 + at.a2 * most * norm(at.r)) + f_d_F_a * std::fmax(0.0, 2 * most - 1.0 / 3));
    }
    bool admits(const State& s) const
    {
        if (!isCompressive(s.stress)) return false;
        return s.variables.e >= e_d0 || s.variables.e >= (1 - ofRounding) * e_d0 * compression(-trace(s.stress) / 3);
    }
    bool apart(const State& s) const
    {
        constexpr double beyond = 1e-4; // the integral of a path on e_i stays nearer to it
        const double p = std::fmax(0.0, -trace(s.stress) / 3), e = s.variables.e;
        return !(e < e_c0 && p < p_0) && e > (1 + beyond) * e_i0 * compression(p);
    }
    State returned(const State& s) const { return s; }
    static double variableError(const VoidRatio& error, const State&) { return std::abs(error.e); }
    static VoidRatio strainedFreely(VoidRatio q, SymmTensor<3> strain) { return strainedVoidRatio(q, strain); }
    static double solidShare(VoidRatio q) { return 1 / (1 + q.e); }
    std::string objection(const State& s) const
    {
        const double p = -trace(s.stress) / 3;
        if (!(p > 0)) return fmt::format("the mean pressure -tr(sigma)/3 is {:.6g} Pa: the law needs a positive one", p);
        const double limit = compression(p), e = s.variables.e;
        if (e >= (1 - ofRounding) * e_d0 * limit && e <= (1 + ofRounding) * e_i0 * limit) return "";
        return fmt::format("void ratio {:.6g} is {}: possible at p = {:.6g} Pa are {:.6g} (e_d) to {:.6g} (e_i)", e,
                           e < e_d0 * limit ? "below the densest" : "above the loosest", p, e_d0 * limit, e_i0 * limit);
    }

    static constexpr auto startWords = "`voidRatio`";
    static const Parameter& startEntry() { return entry::voidRatio; }
    static bool startGiven(const Dictionary& d) { return entry::voidRatio.given(d); }
    static auto readVariables(const Dictionary& d)
    {
        return [e = entry::voidRatio.needed(d)](SymmTensor<3>) { return VoidRatio{e}; };
    }
    static EntryList variableEntries() { return {entry::voidRatio}; }
    /// The tests that find each constant (Herle & Gudehus 1999).
    static constexpr std::pair<const char*, const char*> foundBy[]{
        {"phi_c", "a triaxial test of loose sand to large strain, or the angle of repose"},
        {"h_s", "an oedometer or isotropic test of loose sand over a wide range of pressures"},
        {"n", "an oedometer or isotropic test of loose sand over a wide range of pressures"},
        {"e_d0", "a triaxial test of dense sand up to its peak, at another density as well"},
        {"e_c0", "an undrained or drained triaxial test of loose sand to large strain, with its void ratio"},
        {"e_i0", "an oedometer or isotropic test of the loosest sand"},
        {"alpha", "a drained triaxial test of dense sand up to its peak"},
        {"beta", "an oedometer test of dense sand beside that of loose"}};
    static EntryList entries()
    {
        namespace e = entry::vonWolffersdorff;
        return {e::phi_c, e::h_s, e::n, e::e_d0, e::e_c0, e::e_i0, e::alpha, e::beta};
    }
    static VonWolffersdorff read(const Dictionary& d)
    {
        namespace e = entry::vonWolffersdorff;
        const double e_d0 = e::e_d0(d), e_c0 = e::e_c0(d), e_i0 = e::e_i0(d);
        const auto law = of(e::phi_c(d), e::h_s(d), e::n(d), e_d0, e_c0, e_i0, e::alpha(d), e::beta(d));
        const auto all = e::phi_c.given(d) && e::e_d0.given(d) && e::e_c0.given(d) && e::e_i0.given(d);
        if (all && !(e_d0 < e_c0 && e_c0 < e_i0))
            e::e_c0.error(d, fmt::format("void ratios are to grow from e_d0 to e_c0 to e_i0, and are {:.6g}, {:.6g}, {:.6g}", e_d0, e_c0,
                                         e_i0));
        else if (all && !(law.bracket() > 0))
            e::alpha.error(d, fmt::format("3 + a^2 - a sqrt(3) ((e_i0 - e_d0)/(e_c0 - e_d0))^alpha is {:.6g}, and f_b needs it positive: "
                                          "take alpha smaller, or e_i0 nearer to e_c0",
                                          law.bracket()));
        return law;
    }

private:
    static constexpr double ofRounding = 1e-9;
};

}
