/// Modified Cam Clay: Roscoe & Burland (1968), in: Engineering Plasticity, Cambridge, 535, with the void ratio e and the preconsolidation pressure p_c as
/// state:
///
///   f = q^2/M^2 + p (p - p_c) <= 0,    associated flow: D_p = Lambda df/dsigma
///   sigma^ = 2 G dev(D - D_p) + K tr(D - D_p) I,    K = (1 + e) p/kappa,    G = 3 K (1 - 2 nu)/(2 (1 + nu)), or constant
///   de/dt = (1 + e) tr(D),    dp_c/dt = -p_c (1 + e)/(lambda - kappa) tr(D_p)
///   Lambda = max(0, N:C:D)/( N:C:N + p p_c (1 + e)/(lambda - kappa) (2 p - p_c) ),    N = df/dsigma = 3 s/M^2 - (2 p - p_c)/3 I
///
/// sigma^ [Pa/s] Jaumann rate, sigma [Pa] effective stress, tension positive, p = -tr(sigma)/3, q^2 = 3/2 s:s, s the deviator, D [1/s] strain rate, extension
/// positive, lambda and kappa [1] the slopes of loading and unloading in e over ln(p), M [1] = q/p at the critical state, the same in compression and
/// extension; M = 6 sin(phi)/(3 - sin(phi)) of a friction angle phi in triaxial compression.
///
/// What is known in closed form: e = e_1 - lambda ln(p/p_1) of isotropic loading, e = e_1 - kappa ln(p/p_1) of unloading; the critical state at q = M p, p = p_c/2;
/// without drainage, from the yield surface on, with Lambda_v = 1 - kappa/lambda and eta = q/p,
///
///   p/p_1 = [ (M^2 + eta_1^2)/(M^2 + eta^2) ]^Lambda_v
///
/// Flow on the side of p < p_c/2 softens. The law holds for p > 0: the ellipse passes through the origin, beside which a principal stress may be
/// tensile; below floorPressure the soil is free of stress.
///
/// | clay (Schofield & Wroth 1968, Critical State Soil Mechanics, chapter 6) | M | lambda | kappa | e on the critical line at 1 kPa |
/// |---|---|---|---|---|
/// | London Clay | 0.888 | 0.161 | 0.062 | 1.759 |
/// | Weald Clay | 0.95 | 0.093 | 0.035 | 1.06 |
///
/// The substeps find the yield surface by their control of the error (substepError of integrateStress.hpp); what truncation leaves outside of it raises p_c. Verified by test/unit/soilLaws and
/// test/unit/elementTests (the closed forms, and drained, undrained, oedometer and shear tests against an independent integrator).
#pragma once
#include "soilLaws/ConstitutiveLaw.hpp"
#include <fmt/format.h>
#include <numbers>

namespace sph
{

namespace entry::modifiedCamClay
{
inline const Scalar M{"M", units::none, byScene("of criticalFrictionAngle"), positiveBelow(3), "q/p at the critical state"},
    phi{"criticalFrictionAngle", degrees, byScene("of M"), Range{0, 90, false, false}, "in triaxial compression, in place of M"},
    lambda{"lambda", units::none, required, positive, "slope of loading, -de/d(ln p)"},
    kappa{"kappa", units::none, required, positive, "slope of unloading, below lambda"},
    nu{"nu", units::none, byScene("needed without shearModulus"), Range{-1, 0.5, false, false}, "Poisson's ratio"},
    G{"shearModulus", units::pressure, byScene("of nu"), positive, "constant, in place of nu"};
/// Entries of the soil at the start, beside its stress and void ratio.
inline const Scalar p_c{"preconsolidationPressure", units::pressure, byScene("of OCR"), positive,
                        "largest isotropic pressure of the past, p_c"},
    OCR{"OCR", units::none, byScene("of preconsolidationPressure"), atLeast(1),
        "p_c over that of which the stress would yield, p + q^2/(M^2 p)"};
}

/// The void ratio and p_c.
struct ClayState
{
    VoidRatio voidRatio;
    double p_c = 0; ///< [Pa]
    static constexpr std::array<StateVariable, 2> names{{VoidRatio::names[0], {"preconsolidationPressure", "Pa"}}};
    static constexpr auto parts(auto& q, const auto& f) { return f(q.voidRatio.e, q.p_c); }
    constexpr ClayState& operator+=(const ClayState& b)
    {
        voidRatio += b.voidRatio;
        p_c += b.p_c;
        return *this;
    }
    friend constexpr ClayState operator*(double s, const ClayState& a) { return {s * a.voidRatio, s * a.p_c}; }
};
constexpr ClayState rotated(const ClayState& a, Tensor<3>) { return a; }
constexpr ClayState turning(const ClayState&, Tensor<3>) { return {}; }

struct ModifiedCamClay
{
    static constexpr auto name = "modifiedCamClay",
                          meaning = "clay with void ratio and preconsolidation pressure, Roscoe and Burland (1968)";
    static constexpr bool tensionless = true;
    using Variables = ClayState;
    using State = SoilState<ClayState>;
    double M = 1, lambda = 1, kappa = 0.5; ///< [1]
    double nu = 0;                         ///< [1]
    double constantG = 0;                  ///< [Pa], 0: of nu

    double bulkModulus(const State& s) const { return (1 + s.variables.voidRatio.e) * pressure(s.stress) / kappa; }
    double shearModulus(double K) const { return constantG > 0 ? constantG : 1.5 * K * (1 - 2 * nu) / (1 + nu); }
    static double pressure(SymmTensor<3> sigma) { return -trace(sigma) / 3; }
    /// The p_c whose yield surface the stress is on [Pa]: p + q^2/(M^2 p).
    double surfaceOf(SymmTensor<3> sigma) const
    {
        const double p = pressure(sigma);
        const auto s = deviator(sigma);
        return p + 1.5 * doubleDot(s, s) / (M * M * p);
    }
    bool yields(const State& s) const { return surfaceOf(s.stress) >= (1 - onSurface) * s.variables.p_c; }

    State rate(const State& at, SymmTensor<3> D) const
    {
        const double e = at.variables.voidRatio.e, K = bulkModulus(at), G = shearModulus(K), p = pressure(at.stress);
        const auto s = deviator(at.stress), I = identity(s);
        State rate{2 * G * deviator(D) + K * trace(D) * I, {{(1 + e) * trace(D)}, 0}};
        if (!yields(at)) return rate;
        const double p_c = at.variables.p_c, slope = 2 * p - p_c, hardening = p_c * (1 + e) / (lambda - kappa);
        const auto N = 3 / (M * M) * s - slope / 3 * I;
        const double loading = doubleDot(N, rate.stress),
                     against = 18 * G / sqr(M * M) * doubleDot(s, s) + K * slope * slope + p * hardening * slope;
        if (!(loading > 0)) return rate;
        const double Lambda = loading / against; // softening faster than the stress gives way: no finite rate
        const auto plastic = Lambda * N;
        rate.stress += -1.0 * (2 * G * deviator(plastic) + K * trace(plastic) * I);
        rate.variables.p_c = -hardening * trace(plastic);
        return rate;
    }
    /// K + 4 G/3 of unloading.
    double stiffness(const State& s) const
    {
        if (!(pressure(s.stress) > 0)) return 0;
        const double K = bulkModulus(s);
        return K + 4 * shearModulus(K) / 3;
    }
    /// A substep may end where the law has stiffness.
    bool bears(const State& s) const { return pressure(s.stress) > 0 && s.variables.voidRatio.e > 0 && s.variables.p_c > 0; }
    bool admits(const State& s) const { return bears(s) && surfaceOf(s.stress) <= (1 + ofFiles) * s.variables.p_c; }
    static bool apart(const State&) { return false; }
    /// p_c raised to the stress.
    State returned(const State& s) const
    {
        auto on = s;
        if (pressure(s.stress) > 0) on.variables.p_c = std::fmax(s.variables.p_c, surfaceOf(s.stress));
        return on;
    }
    double beyond(const State& s) const { return std::fmax(0.0, surfaceOf(s.stress) - s.variables.p_c); }
    static double variableError(const ClayState& error, const State& s)
    {
        return std::abs(error.voidRatio.e) + std::abs(error.p_c) / s.variables.p_c;
    }
    /// p_c is left.
    static ClayState strainedFreely(ClayState q, SymmTensor<3> strain) { return {strainedVoidRatio(q.voidRatio, strain), q.p_c}; }
    static double solidShare(const ClayState& q) { return 1 / (1 + q.voidRatio.e); }
    std::string objection(const State& s) const
    {
        const double p = pressure(s.stress), p_c = s.variables.p_c;
        if (!(p > 0)) return fmt::format("the mean pressure -tr(sigma)/3 is {:.6g} Pa: the law needs a positive one", p);
        if (!(s.variables.voidRatio.e > 0)) return fmt::format("void ratio {:.6g} is not positive", s.variables.voidRatio.e);
        if (p_c >= (1 - ofFiles) * surfaceOf(s.stress)) return "";
        return fmt::format(
            "preconsolidation pressure {:.6g} Pa is below the stress: possible at p = {:.6g} Pa and q = {:.6g} Pa are {:.6g} Pa and more",
            p_c, p, std::sqrt(1.5) * norm(deviator(s.stress)), surfaceOf(s.stress));
    }

    static constexpr auto startWords = "`voidRatio` and one of `preconsolidationPressure` and `OCR`";
    static const Parameter& startEntry() { return entry::modifiedCamClay::p_c; }
    static bool startGiven(const Dictionary& d)
    {
        return entry::voidRatio.given(d) && (entry::modifiedCamClay::p_c.given(d) || entry::modifiedCamClay::OCR.given(d));
    }
    auto readVariables(const Dictionary& d) const
    {
        namespace e = entry::modifiedCamClay;
        const VoidRatio voidRatio{entry::voidRatio.needed(d)};
        const auto OCR = e::OCR.ifGiven(d);
        if (OCR && e::p_c.given(d)) e::OCR.error(d, "the past is said twice: keep preconsolidationPressure or OCR");
        const double p_c = OCR ? 0 : e::p_c.needed(d);
        return [=, law = *this](SymmTensor<3> stress) { return ClayState{voidRatio, OCR ? *OCR * law.surfaceOf(stress) : p_c}; };
    }
    static EntryList variableEntries() { return {entry::voidRatio, entry::modifiedCamClay::p_c, entry::modifiedCamClay::OCR}; }

    /// The tests that find each constant.
    static constexpr std::pair<const char*, const char*> foundBy[]{
        {"M", "a triaxial test to large strain, where q/p stays"},
        {"criticalFrictionAngle", "a triaxial test to large strain, where q/p stays"},
        {"lambda", "an isotropic or oedometer test loaded far beyond the preconsolidation pressure"},
        {"kappa", "an isotropic or oedometer test with unloading"},
        {"nu", "the start of a triaxial test of overconsolidated clay, or the lateral stress of an oedometer test with unloading"},
        {"shearModulus", "the start of a triaxial test of overconsolidated clay"}};
    static EntryList entries()
    {
        namespace e = entry::modifiedCamClay;
        return {e::M, e::phi, e::lambda, e::kappa, e::nu, e::G};
    }
    static ModifiedCamClay read(const Dictionary& d)
    {
        namespace e = entry::modifiedCamClay;
        ModifiedCamClay law;
        if (e::phi.given(d))
        {
            if (e::M.given(d)) e::phi.error(d, "the critical state is said twice: keep M or criticalFrictionAngle");
            const double sine = std::sin(e::phi(d, 0) * std::numbers::pi / 180);
            law.M = 6 * sine / (3 - sine);
        }
        else law.M = e::M.needed(d);
        law.lambda = e::lambda(d);
        law.kappa = e::kappa(d);
        if (e::lambda.given(d) && e::kappa.given(d) && !(law.kappa < law.lambda))
            e::kappa.error(d, fmt::format("kappa {:.6g} is not below lambda {:.6g}: such clay would not yield", law.kappa, law.lambda));
        if (e::G.given(d))
        {
            if (e::nu.given(d)) e::G.error(d, "the shear stiffness is said twice: keep nu or shearModulus");
            law.constantG = e::G(d, 0);
        }
        else law.nu = e::nu.needed(d);
        return law;
    }

private:
    static constexpr double onSurface = 1e-9; ///< of p_c: counts as on the yield surface
    static constexpr double ofFiles = 1e-6;   ///< of p_c: digits of a field that was written as text
};

}
