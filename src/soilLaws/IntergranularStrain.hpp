/// Intergranular strain: the stiffness of small strains after a change of direction, as an option of a hypoplastic law sigma^ = L:D + N |D|: Niemunis &
/// Herle (1997), Mech. Cohes.-Frict. Mater. 2:279:
///
///   sigma^ = [ rho^chi m_T + (1 - rho^chi) m_R ] L:D
///            + rho^chi (1 - m_T) (L:h') (h':D) + rho^chi N (h':D)      where h':D > 0
///            + rho^chi (m_R - m_T) (L:h') (h':D)                       elsewhere
///   h^     = D - rho^beta_r h' (h':D)  where h':D > 0,   D elsewhere
///
/// h [1] intergranular strain, extension positive, with the Jaumann rate h^ as the stress; rho = |h|/R, h' = h/|h|; R [1] the size of the range of small strains, m_R
/// [1] the stiffness over L after a reversal, m_T [1] after a turn of 90 degrees, beta_r and chi [1] exponents. rho stays at or below 1. At
/// rho = 1 and h along D this is the law itself; at h = 0 it is elastic, m_R L. The rest of the symbols: VonWolffersdorff.hpp.
///
/// | sand | R | m_R | m_T | beta_r | chi |
/// |---|---|---|---|---|---|
/// | Karlsruhe and Hochstetten (Niemunis & Herle 1997) | 1e-4 | 5 | 2 | 0.5 | 6 |
///
/// Verified by test/unit/soilLaws (rates of random states, both limits) and tutorials/geomechanics/triaxialSands.
#pragma once
#include "soilLaws/VonWolffersdorff.hpp"

namespace sph
{

namespace entry::intergranular
{
inline const SubDictionary option{"intergranularStrain", notGiven, "with intergranular strain, Niemunis and Herle (1997)"};
inline const Scalar R{"R", units::none, required, positiveBelow(0.1), "size of the range of small strains"},
    m_R{"m_R", units::none, required, atLeast(1), "stiffness after a reversal, over that of the law"},
    m_T{"m_T", units::none, required, atLeast(1), "stiffness after a turn of 90 degrees"},
    beta_r{"beta_r", units::none, required, positive, "exponent of the evolution of h"},
    chi{"chi", units::none, required, positive, "exponent of the stiffness between the two"};
/// The entry of the soil at the start.
inline const Choice start{"intergranularStrain",
                          {{"none", "h = 0: the past is forgotten, and the soil is stiffest"},
                           {"isotropic", "h = -R/sqrt(3) I: as after isotropic compression"}},
                          "none",
                          "h where no field gives it, with a law that has it"};
}

/// The void ratio and h.
struct GranularState
{
    VoidRatio voidRatio;
    SymmTensor<3> h;
    static constexpr std::array<StateVariable, 2> names{{VoidRatio::names[0], {"intergranularStrain", "1"}}};
    static constexpr auto parts(auto& q, const auto& f) { return f(q.voidRatio.e, q.h); }
    constexpr GranularState& operator+=(const GranularState& b)
    {
        voidRatio += b.voidRatio;
        h += b.h;
        return *this;
    }
    friend constexpr GranularState operator*(double s, const GranularState& a) { return {s * a.voidRatio, s * a.h}; }
};
constexpr GranularState rotated(const GranularState& a, Tensor<3> Q) { return {a.voidRatio, rotated(a.h, Q)}; }
constexpr GranularState turning(const GranularState& a, Tensor<3> W) { return {{}, turning(a.h, W)}; }

template<class Law> struct IntergranularStrain
{
    using Option = Law; ///< the law that it is an option of, whose word it answers to
    static constexpr auto name = Law::name, meaning = Law::meaning;
    static constexpr bool tensionless = true;
    using Variables = GranularState;
    using State = SoilState<GranularState>;
    Law law;
    double R = 1, m_R = 1, m_T = 1, beta_r = 1, chi = 1;

    State rate(const State& s, SymmTensor<3> D) const
    {
        const auto at = law.tangent(base(s));
        const double size = norm(s.variables.h), rho = size / R, rhoChi = std::pow(rho, chi);
        const auto unit = size > 0 ? 1 / size * s.variables.h : SymmTensor<3>{};
        const double along = doubleDot(unit, D);
        auto stressRate = (rhoChi * m_T + (1 - rhoChi) * m_R) * at.linear(D);
        auto h = D;
        if (along > 0)
        {
            stressRate += rhoChi * along * ((1 - m_T) * at.linear(unit) + at.N);
            h = D - std::pow(rho, beta_r) * along * unit;
        }
        else stressRate += rhoChi * (m_R - m_T) * along * at.linear(unit);
        return {stressRate, {{(1 + s.variables.voidRatio.e) * trace(D)}, h}};
    }
    /// The bound is that of the law with L taken m_R times.
    double stiffness(const State& s) const { return -trace(s.stress) > 0 ? law.bound(base(s), std::fmax(m_R, m_T)) : 0; }
    bool admits(const State& s) const { return law.admits(base(s)); }
    bool apart(const State& s) const { return law.apart(base(s)); }
    State returned(const State& s) const { return s; }
    double variableError(const GranularState& error, const State& s) const
    {
        return law.variableError(error.voidRatio, base(s)) + norm(error.h) / R;
    }
    /// h is left: of soil without stress, and of soil that the law does not hold for, it says nothing.
    GranularState strainedFreely(const GranularState& q, SymmTensor<3> strain) const
    {
        return {law.strainedFreely(q.voidRatio, strain), q.h};
    }
    double solidShare(const GranularState& q) const { return law.solidShare(q.voidRatio); }
    std::string objection(const State& s) const
    {
        constexpr double ofRounding = 1e-6;
        const double size = norm(s.variables.h);
        if (size > (1 + ofRounding) * R) return fmt::format("intergranular strain of size {:.6g}: possible are 0 to R = {:.6g}", size, R);
        return law.objection(base(s));
    }

    /// The tests that find the law's own constants; small cycles find those of the option.
    static constexpr auto& foundBy = Law::foundBy;
    static constexpr auto startWords = Law::startWords;
    static const Parameter& startEntry() { return Law::startEntry(); }
    static bool startGiven(const Dictionary& d) { return Law::startGiven(d); }
    auto readVariables(const Dictionary& d) const
    {
        const bool isotropic = entry::intergranular::start(d) == "isotropic";
        const auto h = isotropic ? -R / std::numbers::sqrt3 * SymmTensor<3>{1, 0, 0, 1, 0, 1} : SymmTensor<3>{};
        return [h, ofLaw = law.readVariables(d)](SymmTensor<3> stress) { return GranularState{ofLaw(stress), h}; };
    }
    static EntryList variableEntries() { return Law::variableEntries() + EntryList{entry::intergranular::start}; }
    /// Beside those of the law.
    static EntryList entries()
    {
        namespace e = entry::intergranular;
        return {{e::option, {e::R, e::m_R, e::m_T, e::beta_r, e::chi}}};
    }
    static bool given(const Dictionary& d) { return entry::intergranular::option.given(d); }
    static IntergranularStrain read(const Dictionary& d, const Law& law)
    {
        namespace e = entry::intergranular;
        const auto own = e::option(d);
        return {law, e::R(own), e::m_R(own), e::m_T(own), e::beta_r(own), e::chi(own)};
    }

private:
    static SoilState<VoidRatio> base(const State& s) { return {s.stress, s.variables.voidRatio}; }
};

}
