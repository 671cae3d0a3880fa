#include "models/soil/StressUpdate.hpp"
#include "models/soil/ContinuedStress.hpp"
#include "models/soil/SoilFields.hpp"
#include "operators/BalancedGradient.hpp"
#include "parallel/reduce.hpp"
#include "scene/DensityOfModel.hpp"
#include "soilLaws/soilLaws.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// sqrt(M/rho) [m/s], and with it the speed of what pushes compacted soil apart.
struct SoundSpeed
{
    double ofLaw, all;
    template<class Law> SoundSpeed(const Law& law, const StateOf<Law>& state, double rho, const SoilNumbers& numbers)
    {
        const double square = law.stiffness(state) / rho;
        ofLaw = std::sqrt(square);
        all = rho > numbers.compactFrom ? std::sqrt(square + sqr(numbers.compactionSpeed)) : ofLaw;
    }
};

/// Arrays of the state variables of a law, by component.
template<class Law, int dim> auto variablesOf(auto& store)
{
    std::vector<decltype(store.component("", 0))> arrays;
    typename StateOf<Law>::Variables variables;
    forEachVariable(variables,
                    [&]<class Part>(const StateVariable& variable, const Part&)
                    {
                        for (int c = 0; c < components<VariableIn<dim, Part>>; ++c) arrays.push_back(store.component(variable.name, c));
                    });
    return arrays;
}
}

template<int dim>
StressUpdate<dim>::StressUpdate(Particles<dim>& particles, const Numbers& restored) : particles_(particles), fresh_(restored.empty())
{
    const auto walls = particles.settings().facts.template get<WallConditions>();
    if (particles.coefficients().template has<TwoLevels>())
    {
        levels_ = particles.coefficients().template of<TwoLevels>();
        levels_->restore(restored);
    }
    particles.images().rules().set(ActingStress{},
                                   std::make_unique<ContinuedStress<dim>>(particles.geometry(), particles.store(), particles.coefficients(),
                                                                          walls.slip, walls.pressure));
    if (walls.interpolated) particles.images().rules().interpolateInLayers(ActingStress{});
}

template<int dim> typename StressUpdate<dim>::Counts& StressUpdate<dim>::Counts::operator+=(const Counts& more)
{
    if (inadmissible + unresolved == 0) place = more.place;
    stressFree += more.stressFree;
    inadmissible += more.inadmissible;
    unresolved += more.unresolved;
    Larger{}(fastest, more.fastest);
    Larger{}(ofLaw, more.ofLaw);
    power += more.power;
    return *this;
}

template<int dim> std::vector<Stage<dim>> StressUpdate<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::sorted)
        return {{"first sound", "c = sqrt(M/rho), once",
                 [this](Particles<dim>& p, const Substep&)
                 {
                     if (std::exchange(measured_, true)) return;
                     if (fresh_) checkVariables(p);
                     measure(p);
                 }}};
    if (levels_ && place == JoinPoint::afterKick)
        return {{"sound", "c = sqrt(M/rho)", [this](Particles<dim>& p, const Substep&) { measure(p); }}};
    if (place != (levels_ ? JoinPoint::beforeDrift : JoinPoint::afterKick)) return {};
    const auto& law = particles_.coefficients().template of<Soil>().law;
    std::vector<std::string> groups{ofStrain};
    if (particles_.store().has(GradientOffset{})) groups.emplace_back(ofBalance);
    const bool hasDensity = particles_.settings().facts.template get<DensityOfModel>().exists;
    return {{"stress",
             hasDensity          ? "sigma += dt (sigma^ + W.sigma - sigma.W), the law's state variables and rho with it, in substeps"
             : hasVariables(law) ? "sigma += dt (sigma^ + W.sigma - sigma.W), the law's state variables with it, in substeps"
             : levels_           ? "sigma, sigma_0 = sigma_0 + (dt_0 + dt) (sigma^(sigma, D) + W.sigma - sigma.W), sigma; in substeps"
                                 : "sigma += dt (sigma^(sigma, D) + W.sigma - sigma.W), in substeps",
             [this](Particles<dim>& p, const Substep& s) { advance(p, s.deltaT); }, groups}};
}

template<int dim> void StressUpdate<dim>::checkVariables(const Particles<dim>& particles) const
{
    const auto& store = particles.store();
    const auto sigma = store.pointers(SoilStress{});
    const auto places = store.pointers(Position{});
    std::visit(
        [&]<class Law>(const Law& law)
        {
            if constexpr (LawOfState<Law>)
            {
                const auto variables = variablesOf<Law, dim>(store);
                for (std::size_t i = 0; i < particles.size(); ++i)
                {
                    const StateOf<Law> state(in3D(valueAt<StressTensor<dim>>(sigma, i)),
                                             variablesAt<dim, typename Law::Variables>(variables, i));
                    const auto why = norm(state.stress) > 0 ? law.objection(state) : "";
                    if (why.empty()) continue;
                    const auto x = in3D(valueAt<Vector<dim>>(places, i));
                    throw CaseError({soilProperties, 0}, fmt::format("soil at ({:.6g} {:.6g} {:.6g}) m: {}", x.x, x.y, x.z, why));
                }
            }
        },
        particles.coefficients().template of<Soil>().law);
}

template<int dim> void StressUpdate<dim>::measure(Particles<dim>& particles)
{
    const auto sigma = std::as_const(particles.store()).pointers(SoilStress{});
    const double* const rho = particles.store().component(Density::info.name, 0);
    double* const c = particles.store().component(SoilSound::info.name, 0);
    const auto& numbers = particles.coefficients().template of<SoilNumbers>();
    std::visit(
        [&]<class Law>(const Law& law)
        {
            const auto variables = variablesOf<Law, dim>(particles.store());
            const auto sound = reduce(
                particles.size(), Counts{},
                [&](std::size_t i)
                {
                    const StateOf<Law> state(in3D(valueAt<StressTensor<dim>>(sigma, i)),
                                             variablesAt<dim, typename StateOf<Law>::Variables>(variables, i));
                    const SoundSpeed of(law, state, rho[i], numbers);
                    c[i] = of.all;
                    return Counts{.fastest = of.all, .ofLaw = of.ofLaw};
                },
                Add{});
            summary_.fastest = sound.fastest;
            summary_.ofLaw = sound.ofLaw;
        },
        particles.coefficients().template of<Soil>().law);
}

template<int dim> void StressUpdate<dim>::advance(Particles<dim>& particles, double deltaT)
{
    particles.evaluate(ofStrain);
    auto& store = particles.store();
    const auto& soil = particles.coefficients().template of<Soil>();
    const auto sigma = store.pointers(SoilStress{});
    const double lastDeltaT = levels_ ? levels_->next(deltaT) : 0, span = lastDeltaT + deltaT;
    const auto older = levels_ ? store.pointers(OlderStress{}) : decltype(store.pointers(OlderStress{})){};
    const auto L = std::as_const(store).pointers(VelocityGradient{});
    const auto places = std::as_const(store).pointers(Position{});
    double* const rho = store.component(Density::info.name, 0);
    const double* const V = store.component(Volume::info.name, 0);
    double* const c = store.component(SoilSound::info.name, 0);
    const auto& numbers = particles.coefficients().template of<SoilNumbers>();
    const auto noise = numbers.smoothing > 0 ? std::as_const(store).pointers(StressNoise{})
                                             : std::array<const double*, fieldComponents<StressNoise, dim>>{};
    const double h = 0.5 * particles.coefficients().support;
    double* const strain = store.has(ShearStrain{}) ? store.component(ShearStrain::info.name, 0) : nullptr;
    double* const plastic = store.has(PlasticShearStrain{}) ? store.component(PlasticShearStrain::info.name, 0) : nullptr;
    double* const work = store.has(StressWork{}) ? store.component(StressWork::info.name, 0) : nullptr;
    const auto advanced = [&]<ConstitutiveLaw Law>(const Law& law)
    {
        using Variables = typename StateOf<Law>::Variables;
        return [&, variables = variablesOf<Law, dim>(store)](std::size_t i)
        {
            const auto variablesBefore = variablesAt<dim, Variables>(variables, i);
            const auto gradient = in3D(valueAt<Tensor<dim>>(L, i));
            const auto before = in3D(valueAt<StressTensor<dim>>(sigma, i));
            auto start = lastDeltaT > 0 ? in3D(valueAt<StressTensor<dim>>(older, i)) : before;
            if (levels_) sph::store(stressIn<dim>(before), [&](int k, double q) { older[std::size_t(k)][i] = q; });
            const auto D = symm(gradient);
            if (numbers.smoothing > 0)
            {
                const double fastest = c[i] / h, byStrain = strainsOfNoise * norm(D);
                const double rate = numbers.smoothing * (numbers.smoothsAtRest ? fastest : std::fmin(fastest, byStrain));
                const auto smoothed = start - std::expm1(-rate * span) * in3D(valueAt<StressTensor<dim>>(noise, i));
                if (law.admits(StateOf<Law>(smoothed, variablesBefore))) start = smoothed;
            }
            const auto step = integrateStress(law, StateOf<Law>(start, variablesBefore), span * gradient, soil.integration);
            sph::store(stressIn<dim>(step.stress), [&](int k, double q) { sigma[std::size_t(k)][i] = q; });
            storeVariables<dim>(step.variables, variables, i);
            if constexpr (LawOfVoidRatio<Law>) rho[i] *= law.solidShare(step.variables) / law.solidShare(variablesBefore);
            const SoundSpeed sound(law, step, rho[i], numbers);
            c[i] = sound.all;
            const auto mean = levels_ ? before : 0.5 * (start + step.stress);
            if (strain) strain[i] += deltaT * std::sqrt(2.0) * norm(deviator(D));
            if constexpr (ElastoPlasticLaw<Law>)
                if (plastic)
                    plastic[i] += deltaT / span * std::sqrt(2.0) * norm(deviator(plasticStrain(law, start, step.stress, span * gradient)));
            if (work) work[i] += deltaT * doubleDot(mean, D);
            const bool bad = step.state == StressState::inadmissible || step.state == StressState::unresolved;
            const auto onNeighbours = mean + (numbers.surfacePressure - numbers.compactionPressure(rho[i])) * identity(mean);
            return Counts{step.state == StressState::stressFree,
                          step.state == StressState::inadmissible,
                          step.state == StressState::unresolved,
                          sound.all,
                          sound.ofLaw,
                          -V[i] * doubleDot(onNeighbours, D),
                          bad ? in3D(valueAt<Vector<dim>>(places, i)) : Vector<3>{}};
        };
    };
    summary_ = std::visit([&](const auto& law) { return reduce(particles.size(), Counts{}, advanced(law), Add{}); }, soil.law);
    if (particles.movingWalls().any()) summary_.power += powerOfWalls(particles);
    if (store.has(GradientOffset{})) particles.evaluate(ofBalance, deltaT);
}

template<int dim> double StressUpdate<dim>::powerOfWalls(const Particles<dim>& particles) const
{
    const auto& c = particles.coefficients();
    const auto& geometry = particles.geometry();
    const auto x = particles.store().pointers(Position{});
    const auto S = particles.store().pointers(ActingStress{});
    const double* const V = particles.store().component(Volume::info.name, 0);
    return sum(particles.size(),
               [&](std::size_t i)
               {
                   double power = 0;
                   const auto x_i = valueAt<Vector<dim>>(x, i);
                   particles.nearWalls().forEachFoot(in3D(x_i), c.spacing,
                                                     [&](const Foot& foot, const Patch& patch)
                                                     {
                                                         const auto v_w = geometry.wallVelocity(patch.wallAt(foot.region),
                                                                                                in3D(x_i) - foot.distance * foot.normal);
                                                         power -= V[i] / c.spacing *
                                                                  dot(valueAt<SymmTensor<dim>>(S, i) * in<dim>(foot.normal), in<dim>(v_w));
                                                     });
                   return power;
               });
}

template<int dim> std::vector<StepLimit> StressUpdate<dim>::limits() const
{
    const auto& coefficients = particles_.coefficients();
    const double h = 0.5 * coefficients.support, alpha = coefficients.template of<SoilNumbers>().alpha;
    const double c = summary_.fastest, speed = particles_.maxSpeed();
    return {{particles_.settings().integration.factors.sound * h / (c + speed),
             c > summary_.ofLaw ? "sound in soil with compactionSpeed" : "sound in soil", false,
             speed > c ? &Velocity::info : &SoilSound::info},
            {(levels_ ? levels_->stableDecay() : 1) * 0.5 * h / (alpha * c), "artificial viscosity", false, &SoilSound::info}};
}

template<int dim> Numbers StressUpdate<dim>::columns(const Particles<dim>&) const
{
    return {{"maxSoundSpeed", summary_.fastest},
            {"stressFree", double(summary_.stressFree)},
            {"inadmissible", double(summary_.inadmissible)},
            {"unresolved", double(summary_.unresolved)}};
}

template<int dim> std::string StressUpdate<dim>::introduction() const
{
    const auto strength = strengthInWords(particles_.coefficients().template of<Soil>().law);
    return strength.empty() ? "" : fmt::format("Strength  : {}\n", strength);
}

template<int dim> std::string StressUpdate<dim>::report(const Particles<dim>&) const
{
    return fmt::format(
        "soil: sound {:.4g} m/s at most, {} particles stress-free, {} with a stress that the law does not admit, {} not resolved\n",
        summary_.fastest, summary_.stressFree, summary_.inadmissible, summary_.unresolved);
}

template<int dim> void StressUpdate<dim>::save(Numbers& numbers) const
{
    if (levels_) levels_->save(numbers);
}

template<int dim> std::string StressUpdate<dim>::note() const
{
    if (summary_.inadmissible + summary_.unresolved == 0) return "";
    const auto& x = summary_.place;
    return fmt::format("  {} stresses inadmissible, {} not resolved, the first at ({:.4g} {:.4g} {:.4g})", summary_.inadmissible,
                       summary_.unresolved, x.x, x.y, x.z);
}

template class StressUpdate<2>;
template class StressUpdate<3>;

}
