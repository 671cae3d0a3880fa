/// The stress of one particle over one step, of any size: the integral of its law
///
///   dsigma/dt = sigma^(sigma, D) + W.sigma - sigma.W,     D = sym(L), W = skew(L), L = grad v constant over the step
///
/// by substeps with control of the error (EmbeddedPair.hpp). A substep whose end has a tensile principal stress is rejected and quartered: the trace
/// of a tensionless law never changes its sign. The rotation is exact: the stress is turned with Q = exp(W dt), by half the angle before the strain
/// and half after, so that its principal values are those of D alone. Of D, which turns against the material meanwhile, `turning halves` takes the mean
/// direction: second order in the angle of a step, and exact at rest or in rigid rotation. `turning within` turns D at each stage: the integral of the law at steps of any
/// size, for a sine and two products of tensors a stage.
///
/// Verified by test/unit/soilLaws against an independent integrator, with random states, and by rigid rotation.
#pragma once
#include "soilLaws/ConstitutiveLaw.hpp"
#include "soilLaws/EmbeddedPair.hpp"

namespace sph
{

/// Fate of a particle of a tensionless law whose mean pressure falls below floorPressure. Nothing brings a stress of 0 back: it is a fixed point of the law.
enum class StressFree
{
    floor,   ///< the stress is scaled to floorPressure; what acts on its neighbours is sigma + floorPressure I
    detached ///< the stress is 0 and stays 0, until the caller sets it anew
};

enum class Turning
{
    halves,
    within
};

struct StressIntegration
{
    const EmbeddedPair* pair = &dormandPrince;
    double tolerance = 1e-6; ///< error of a substep over |sigma|
    Turning turning = Turning::halves;
    StressFree stressFree = StressFree::floor;
    double floorPressure = 10; ///< [Pa]
};

enum class StressState
{
    regular,
    stressFree, ///< below the floor, at some time of the step
    inadmissible, ///< the law does not hold for the stress at the start (a principal stress is tensile): it is left, or put back, as by `returned`
    unresolved ///< substeps became too short or too many: the stress is that of the last one
};

template<class Variables> struct StressStep : SoilState<Variables>
{
    StressState state = StressState::regular;
    SubSteps subSteps = {};
};

/// exp(W): the rotation by the angle |w|, w the axial vector of the skew W. Rodrigues (1840).
inline Tensor<3> rotationOf(Tensor<3> W)
{
    const double angle = std::sqrt(0.5 * doubleDot(W, W)), half = 0.5 * angle;
    const double sinc = angle > 0 ? std::sin(angle) / angle : 1, versine = angle > 0 ? 0.5 * sqr(std::sin(half) / half) : 0.5;
    return Tensor<3>{1, 0, 0, 0, 1, 0, 0, 0, 1} + sinc * W + versine * (W * W);
}

/// Applies what the law puts back and what happens to the stress-free; true where that has changed the stress.
template<ConstitutiveLaw Law> bool settle(const Law& law, const StressIntegration& how, StateOf<Law>& now, StressState& state)
{
    auto& stress = now.stress;
    bool changed = false;
    if constexpr (!Law::tensionless || LawWithYieldSurface<Law>)
    {
        const StateOf<Law> back = law.returned(now);
        auto difference = back;
        difference += -1.0 * now;
        changed = doubleDot(difference.stress, difference.stress) > 0;
        if constexpr (LawOfState<Law>) changed = changed || law.variableError(difference.variables, now) > 0;
        now = back;
    }
    if constexpr (Law::tensionless)
    {
        const double p = -trace(stress) / 3;
        bool apart = false;
        if constexpr (LawOfState<Law>) apart = law.apart(now);
        if (p >= how.floorPressure && !apart) return changed;
        state = StressState::stressFree;
        const auto isotropic = -how.floorPressure * identity(stress);
        if (how.stressFree == StressFree::detached) stress = {};
        else stress = p > 0 && !apart ? how.floorPressure / p * stress : isotropic;
        return true;
    }
    return changed;
}

/// The error of a substep over what is tolerated: of a law whose stiffness vanishes with the stress relative to the substep's own stresses,
/// of others to that at the start of the step, too, and at least to that of smallStrain, for they pass through 0. A substep that begins
/// within a yield surface counts as an error also how far it has gone beyond: an embedded pair may be blind to the kink of the rate there,
/// and so finds the place. One along a surface that hardens or softens stays on it but for errors, and counts that, too.
template<ConstitutiveLaw Law>
double substepError(const Law& law, const StateOf<Law>& error, SymmTensor<3> start, const StateOf<Law>& from, const StateOf<Law>& to,
                    double tolerance)
{
    double ofVariables = 0, overshoot = 0;
    if constexpr (LawWithYieldSurface<Law>)
        if (LawOfState<Law> || !law.yields(from)) overshoot = law.beyond(to);
    if constexpr (LawOfState<Law>) ofVariables = law.variableError(error.variables, to) / tolerance;
    if constexpr (Law::tensionless)
    {
        const double size = std::fmax(doubleDot(from.stress, from.stress), doubleDot(to.stress, to.stress)),
                     off = doubleDot(error.stress, error.stress);
        // Not a number stays so.
        return ofVariables + (off == 0 ? 0 : std::sqrt(off / size) / tolerance) +
               (overshoot == 0 ? 0 : overshoot / std::sqrt(size) / tolerance);
    }
    const double off = norm(error.stress) + overshoot;
    return ofVariables + off / (tolerance * std::fmax(smallStrain * law.stiffness(to), std::fmax(norm(start), norm(to.stress))));
}

/// `deformation` = L dt [1].
template<ConstitutiveLaw Law>
StressStep<typename StateOf<Law>::Variables> integrateStress(const Law& law, const std::type_identity_t<StateOf<Law>>& start,
                                                             Tensor<3> deformation, const StressIntegration& how)
{
    using Material = StateOf<Law>;
    StressStep<typename Material::Variables> step{start};
    Material& now = step;
    const auto strain = symm(deformation);
    const auto turn = skew(deformation);
    const bool turns = doubleDot(turn, turn) > 0, none = doubleDot(start.stress, start.stress) == 0;
    if (!none && !law.admits(start))
    {
        step.state = StressState::inadmissible;
        if constexpr (LawOfState<Law>) now.variables = law.strainedFreely(now.variables, strain);
        if constexpr (Law::tensionless) return step;
    }
    settle(law, how, now, step.state);
    const auto ends = [&](const Material&) { return step.state == StressState::stressFree && how.stressFree == StressFree::detached; };
    if (ends(now))
    {
        if constexpr (LawOfState<Law>) now.variables = law.strainedFreely(start.variables, strain);
        return step;
    }

    const auto half = rotationOf(0.5 * turn);
    if (turns) now = rotated(now, half);
    const double size = norm(strain);
    const bool varies = turns && how.turning == Turning::within;
    const auto substeps = [&]
    {
        const auto rate = [&](double t, const Material& s) -> Material
        { return law.rate(s, varies ? rotated(strain, rotationOf((0.5 - t) * turn)) : strain); };
        const auto error = [&](const Material& e, const Material& s) { return substepError(law, e, start.stress, now, s, how.tolerance); };
        const auto admits = [&](const Material& s) { return mayEndAt(law, s); };
        const auto settled = [&](Material& s) { return settle(law, how, s, step.state); };
        return integrate(*how.pair, now, how.pair->firstStrain / size, rate, error, admits, settled, ends);
    };
    if (size > 0)
    {
        if constexpr (ElastoPlasticLaw<Law>)
        {
            if (varies) step.subSteps = substeps();
            else now = law.strained(now, strain, *how.pair, how.tolerance, step.subSteps);
        }
        else step.subSteps = substeps();
        if (!step.subSteps.resolved) step.state = StressState::unresolved;
    }
    if (turns) now = rotated(now, half);
    return step;
}

/// The plastic part of a step's strain [1]: what the change of the stress does not need. In axes half-way through the turn of the step.
template<ElastoPlasticLaw Law> SymmTensor<3> plasticStrain(const Law& law, SymmTensor<3> start, SymmTensor<3> end, Tensor<3> deformation)
{
    const auto half = rotationOf(0.5 * skew(deformation));
    return symm(deformation) - law.elastic.strain(rotated(end, transpose(half)) - rotated(start, half));
}

}
