#include "ParticleSystem.hpp"
#include "CaseError.hpp"
#include "continuityTerms.hpp"
#include "ghostVelocities.hpp"
#include "interfacesTerms.hpp"
#include "materialsTerms.hpp"
#include "momentumTerms.hpp"
#include "operatorTerms.hpp"
#include "transportTerms.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// Lists reach this much beyond the kernel's support [spacings]. Measured (test/benchmark/README.md): 0.2 and 0.3 cost the same, 0.12 and
/// 0.45 more.
constexpr double skinInSpacings = 0.3;

template<int dim> Catalogue<dim> allTerms()
{
    Catalogue<dim> all;
    for (const auto& terms : {operatorTerms<dim>(), continuityTerms<dim>(), momentumTerms<dim>(), interfacesTerms<dim>(), transportTerms<dim>(),
                              materialsTerms<dim>()})
        all.insert(all.end(), terms.begin(), terms.end());
    return all;
}

std::set<std::string> stateOf(const Settings& settings)
{
    std::set<std::string> state{Position::info.name, Velocity::info.name, Mass::info.name};
    if (settings.multiphase()) state.insert({Phase::info.name, DynamicViscosity::info.name});
    if (settings.integratedDensity) state.insert(Density::info.name);
    if (settings.coefficients.transportVelocity > 0) state.insert(TransportVelocity::info.name);
    if (settings.suspension()) state.insert(PowderFraction::info.name);
    if (!settings.openings.empty()) state.insert({Holder::info.name, HeldPressure::info.name});
    state.insert(WallStress::info.name); // by WallTension, before an evaluation
    state.insert({WallNormal::info.name, WallCosine::info.name}); // by WallAdhesion, likewise
    state.insert(GhostWall::info.name);  // by the images
    return state;
}

std::string at(Vector<3> x) { return fmt::format("({:.6g} {:.6g} {:.6g})", x.x, x.y, x.z); }
}

template<int dim>
ParticleSystem<dim>::ParticleSystem(const Settings& settings, const Geometry& geometry, const Cloud& cloud, const StateNumbers& restored)
    : settings_(settings), geometry_(geometry), coefficients_(settings.coefficients), catalogue_(allTerms<dim>()),
      plan_(catalogue_, settings.terms, stateOf(settings)),
      images_(geometry, settings.resolution.H() + skinInSpacings*settings.resolution.spacing, settings.resolution.spacing,
              skinInSpacings*settings.resolution.spacing),
      leakGuard_(geometry, settings.resolution.spacing, settings.resolution.H(), settings.leaked),
      kernel_(settings.resolution.kernel, settings.resolution.H()), owned_(cloud.size()), skin_(skinInSpacings*settings.resolution.spacing)
{
    plan_.allocate(store_);
    if (!settings.slowTerms.empty())
    {
        // What the other plan has evaluated at the same state is there, and so are its images.
        auto given = stateOf(settings), current = plan_.readAtNeighbours();
        for (const auto& [name, _] : store_.fields()) given.insert(name);
        given.erase(Acceleration::info.name);
        std::erase_if(current, [&](const auto& name) { return !given.contains(name); });
        slow_.emplace(catalogue_, settings.slowTerms, given, current);
        slow_->allocate(store_);
        store_.allocate(SlowAcceleration{});
    }
    store_.allocateState(Position{});
    store_.allocateState(Velocity{});
    store_.allocateState(Mass{});
    if (settings.multiphase())
    {
        store_.allocateState(Phase{});
        if (plans("harmonicViscosity") || plans("clearyViscosity")) store_.allocateState(DynamicViscosity{});
    }
    if (settings.integratedDensity)
    {
        store_.allocateState(Density{});
        store_.allocateState(StartDensity{});
    }
    if (settings.coefficients.transportVelocity > 0) store_.allocateState(TransportVelocity{});
    if (settings.suspension()) store_.allocateState(PowderFraction{});
    if (!settings.openings.empty())
    {
        store_.allocateState(Holder{});
        store_.allocate(HeldPressure{});
        openings_.emplace(settings.openings, geometry_, coefficients_, restored);
    }
    if (settings.predicts()) store_.allocateState(StartVelocity{});
    if (settings.solvesForVelocity()) implicit_.emplace(settings, catalogue_, store_);
    if (settings.suspension()) migration_.emplace(settings, catalogue_, store_);
    if (settings.integrator == Integrator::leapfrog)
    {
        store_.allocateState(Acceleration{});
        if (settings.integratedDensity) store_.allocateState(DensityRate{});
    }
    if (!geometry.layers.empty())
        images_.setLayers({geometry, kernel_, settings.resolution.H() + skin_, settings.resolution.spacing});
    if (images_.layers() ? images_.layers()->weighted() : settings.weighted) store_.allocate(ImageWeight{});
    if (settings.wallVelocity == WallVelocity::secondOrder)
    {
        store_.allocateState(WallAcceleration{});
        images_.setGhostVelocity(std::make_unique<SecondOrderVelocity<dim>>(geometry, store_, coefficients_));
    }
    else if (settings.wallVelocity == WallVelocity::freeSlip) images_.setGhostVelocity(std::make_unique<SlippingVelocity<dim>>(geometry));
    else images_.setGhostVelocity(std::make_unique<ReflectedVelocity<dim>>(geometry));

    if (settings.detachingGhosts) images_.setGhostPressure(std::make_unique<DetachingPressure<dim>>(store_, coefficients_));
    else if (settings.hydrostaticGhosts) images_.setGhostPressure(std::make_unique<HydrostaticPressure<dim>>(store_, coefficients_));

    if (plans("wallTension")) wallTension_.emplace(coefficients_, kernel_);
    if (plans("adheringColourGradient"))
    {
        wallAdhesion_.emplace(geometry_, coefficients_.support);
        images_.continueInterfaces();
    }
    if (settings.wallPotential) wallPotential_.emplace(coefficients_);

    auto imaged = plan_.readAtNeighbours();
    if (slow_) imaged.merge(slow_->readAtNeighbours());
    if (implicit_) imaged.merge(implicit_->readAtNeighbours());
    if (migration_) imaged.merge(migration_->readAtNeighbours());
    store_.keepImagesOf(imaged);
    load(cloud, !restored.empty());
    const auto scale = restored.find("densityScale");
    if (scale != restored.end()) coefficients_.densityScale = scale->second;
    rebuild();
    checkApart();
    evaluate();
    if (settings.normaliseDensity && scale == restored.end()) normaliseDensity();
    evaluateSlow();
}

template<int dim> void ParticleSystem<dim>::load(const Cloud& cloud, bool restarted)
{
    store_.resize(owned_ + 1, owned_);
    const auto& phases = coefficients_.phases;
    const auto copy = [&](auto tag, const char* name)
    {
        const auto found = cloud.fields.find(name);
        if (found == cloud.fields.end()) return false;
        const auto to = store_.pointers(tag);
        for (std::size_t c = 0; c < to.size(); ++c) std::copy(found->second.component[c].begin(), found->second.component[c].end(), to[c]);
        return true;
    };
    const auto x = store_.pointers(Position{});
    std::copy(cloud.x.begin(), cloud.x.end(), x[0]);
    std::copy(cloud.y.begin(), cloud.y.end(), x[1]);
    if constexpr (dim == 3) std::copy(cloud.z.begin(), cloud.z.end(), x[2]);
    copy(Velocity{}, "U");

    const auto phaseField = cloud.fields.find("phase");
    const auto phaseOf = [&](std::size_t i) { return phaseField == cloud.fields.end() ? 0 : int(phaseField->second.component[0][i]); };
    for (std::size_t i = 0; i < owned_; ++i)
        if (const int k = phaseOf(i); k < 0 || k >= int(phases.size()))
            throw CaseError(fmt::format("particle {} at {} has phase {}, but constant/phaseProperties lists {} phase{}", i,
                                        at({cloud.x[i], cloud.y[i], cloud.z[i]}), k, phases.size(), phases.size() == 1 ? "" : "s"));
    if (settings_.multiphase()) copy(Phase{}, "phase");
    if (settings_.multiphase() && store_.has(DynamicViscosity{}))
        for (std::size_t i = 0; i < owned_; ++i) store_.component("mu", 0)[i] = coefficients_.viscosity[phaseOf(i)];
    if (settings_.suspension())
    {
        double* const phi = store_.component(PowderFraction::info.name, 0);
        const auto& suspension = *coefficients_.suspension;
        if (!copy(PowderFraction{}, PowderFraction::info.name))
        {
            if (restarted) throw CaseError("the time folder that the run goes on from has no field phi: where the powder is, is lost");
            if (!suspension.phi)
                throw CaseError({"constant/transportProperties", 0}, "has no `phi`, the powder's volume fraction, and nor has the time folder");
            std::fill_n(phi, owned_, *suspension.phi);
        }
        for (std::size_t i = 0; i < owned_; ++i)
            if (!(phi[i] >= 0 && (phi[i] < suspension.phiMax || restarted)))
                throw CaseError(fmt::format("particle {} at {} has the volume fraction of powder phi = {:.6g}: it lies from 0 to below phiMax, {:.6g}", i,
                                            at({cloud.x[i], cloud.y[i], cloud.z[i]}), phi[i], suspension.phiMax));
    }
    if (settings_.integratedDensity && !copy(Density{}, "rho"))
        for (std::size_t i = 0; i < owned_; ++i)
        {
            const int k = phaseOf(i);
            const auto given = cloud.fields.find("p");
            const double p = given != cloud.fields.end() ? given->second.component[0][i] - coefficients_.backgroundPressure : 0;
            const double ratio = 1 + p/coefficients_.stiffness[k]; // Tait, the other way round
            if (ratio <= 0)
                throw CaseError(fmt::format("particle {} at {} has the pressure {:.4g} Pa, and no density gives it in the state equation of {}",
                                            i, at({cloud.x[i], cloud.y[i], cloud.z[i]}), p, phases[k]));
            store_.component("rho", 0)[i] = coefficients_.restDensity[k]*std::pow(ratio, 1/coefficients_.exponent[k]);
        }
    if (store_.has(TransportVelocity{})) copy(TransportVelocity{}, TransportVelocity::info.name);
    if (store_.has(WallAcceleration{})) copy(WallAcceleration{}, WallAcceleration::info.name);
    if (!copy(Mass{}, "m"))
        for (std::size_t i = 0; i < owned_; ++i)
            store_.component("m", 0)[i] = coefficients_.restDensity[phaseOf(i)]*std::pow(coefficients_.spacing, dim);
}

template<int dim> void ParticleSystem<dim>::rebuild()
{
    if (openings_) owned_ = openings_->exchange(store_, owned_);
    leakGuard_(store_, owned_, images_);
    const auto pointers = [&] { const auto p = store_.pointers(Position{}); std::array<const double*, dim> x; std::copy(p.begin(), p.end(), x.begin()); return x; };
    cells_.build(pointers(), owned_, 0.5*(settings_.resolution.H() + skin_));
    store_.sortState(cells_.order());
    images_.build(store_, owned_);
    lists_.build(pointers(), owned_, images_.nullParticle(), settings_.resolution.H() + skin_);
    images_.listLayers(lists_);
    images_.bindRules();
    bindPlans();
    if (openings_) openings_->locate(store_, owned_);
    travelled_ = 0;
    ++rebuilds_;
}

template<int dim> void ParticleSystem<dim>::bindPlans()
{
    plan_.bind(store_, coefficients_);
    inPlaceOfAll([&] { if (slow_) slow_->bind(store_, coefficients_); });
    if (implicit_) implicit_->bind(store_, coefficients_);
    if (migration_) migration_->bind(store_, coefficients_);
}

/// Nothing parts two particles at one place: every sum takes x_ij = 0.
template<int dim> void ParticleSystem<dim>::checkApart() const
{
    const double closest = 1e-9*coefficients_.spacing;
    for (std::size_t i = 0; i < owned_; ++i)
        for (const int j : lists_.of(i))
            if (std::size_t(j) > i && std::size_t(j) < owned_ && mag(position(i) - position(j)) < closest)
                throw CaseError(fmt::format("two particles lie at the same place, {}", at(in3D(position(i)))));
}

template<int dim> Vector<dim> ParticleSystem<dim>::position(std::size_t i) const
{
    const auto& x = store_.fields().at(Position::info.name).component;
    Vector<dim> x_i;
    fetch(x_i, [&](int c) { return x[c][i]; });
    return x_i;
}

template<int dim> void ParticleSystem<dim>::evaluate()
{
    if (travelled_ > 0.5*skin_) rebuild();
    else images_.move(store_);
    if (!slow_) evaluateWalls();
    if (implicit_ || slow_ || migration_) plan_.evaluate(store_, images_, lists_, kernel_, Plan<dim>::Candidates::listedAndKept);
    else plan_.evaluate(store_, images_, lists_, kernel_);
    if (wallPotential_ && !slow_) wallPotential_->addAcceleration(images_, store_);
    if (openings_) openings_->hold(store_);
}

template<int dim> void ParticleSystem<dim>::migrate(double deltaT)
{
    const double intoHeld = migration_->advance(store_, images_, lists_, kernel_, deltaT, held());
    if (openings_) openings_->addHeldPowder(intoHeld);
}

template<int dim> void ParticleSystem<dim>::evaluateWalls()
{
    if (wallTension_) wallTension_->evaluate(images_, store_);
    if (wallAdhesion_) wallAdhesion_->evaluate(images_, store_);
}

template<int dim> void ParticleSystem<dim>::evaluateSlow()
{
    if (!slow_) return;
    evaluateWalls();
    slow_->evaluate(store_, images_, lists_, kernel_, Plan<dim>::Candidates::kept);
    if (wallPotential_) inPlaceOfAll([&] { wallPotential_->addAcceleration(images_, store_); });
}

/// Scales the number density so that its mean is exact: the kernel sum over a packing is 0.7 to 1 % off by itself. Where some particles lack
/// neighbours a square or cubic lattice stands for the packing.
template<int dim> void ParticleSystem<dim>::normaliseDensity()
{
    if (settings_.endsInside())
    {
        const double dx = coefficients_.spacing;
        const int n = int(coefficients_.support/dx) + 1;
        double sum = 0;
        for (int i = -n; i <= n; ++i)
            for (int k = -n; k <= n; ++k)
                for (int l = dim == 3 ? -n : 0; l <= (dim == 3 ? n : 0); ++l) sum += kernel_.W(dx*std::sqrt(double(i*i + k*k + l*l)));
        coefficients_.densityScale = 1/(std::pow(dx, dim)*sum);
        bindPlans();
        return evaluate();
    }
    const double *m = store_.component("m", 0), *V = store_.component("V", 0);
    const double* phase = settings_.multiphase() ? store_.component("phase", 0) : nullptr;
    double sum = 0;
    for (std::size_t i = 0; i < owned_; ++i) sum += m[i]/coefficients_.restDensity[phase ? int(phase[i]) : 0]/V[i];
    coefficients_.densityScale *= double(owned_)/sum;
    bindPlans();
    evaluate();
}

template class ParticleSystem<2>;
template class ParticleSystem<3>;

}
