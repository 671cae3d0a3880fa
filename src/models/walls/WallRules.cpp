#include "models/walls/WallRules.hpp"
#include "models/walls/ghostRules.hpp"
#include "parallel/reduce.hpp"
#include <numeric>

namespace sph
{

template<int dim>
WallRules<dim>::WallRules(Particles<dim>& particles, const Numbers&, const std::string& velocity, const std::string& pressure, bool varies,
                          bool interpolates)
    : filters_(velocity == "secondOrder")
{
    auto& images = particles.images();
    auto& store = particles.store();
    const auto& geometry = particles.geometry();
    const auto& c = particles.coefficients();
    std::unique_ptr<GhostVelocity<dim>> rule;
    if (filters_) rule = std::make_unique<SecondOrderVelocity<dim>>(geometry, store, c, varies);
    else if (velocity == "freeSlip") rule = std::make_unique<SlippingVelocity<dim>>(geometry);
    else if (velocity == "morris") rule = std::make_unique<LimitedVelocity<dim>>(geometry);
    else rule = std::make_unique<ReflectedVelocity<dim>>(geometry);
    if (geometry.slips() || geometry.withFriction()) rule = std::make_unique<VelocityByWall<dim>>(geometry, std::move(rule));
    images.rules().set(Velocity{}, std::move(rule));
    if (interpolates) images.rules().interpolateInLayers(Velocity{});
    if (pressure == "detaching") images.rules().set(Pressure{}, std::make_unique<DetachingPressure<dim>>(store, c));
    else if (pressure == "hydrostatic") images.rules().set(Pressure{}, std::make_unique<HydrostaticPressure<dim>>(store, c));
}

template<int dim> std::vector<Stage<dim>> WallRules<dim>::stages(JoinPoint place)
{
    if (!filters_ || place != JoinPoint::atEnd) return {};
    return {{"filter", "a_w += (a_p - a_w)/10", [](Particles<dim>& p, const Substep&) { p.images().rules().filter(); }}};
}

template<int dim> double WallRules<dim>::supply(const Particles<dim>& particles, const std::vector<double>& mass) const
{
    const auto& geometry = particles.geometry();
    const double spacing = particles.coefficients().spacing;
    const Larger larger;
    const auto x = particles.store().pointers(Position{});
    const double fastest = reduce(
        particles.size(), 0.0,
        [&](std::size_t i)
        {
            const auto x_i = valueAt<Vector<dim>>(x, i);
            double speed = 0;
            particles.nearWalls().forEachFoot(in3D(x_i), spacing, // the row at the wall
                                              [&](const Foot& foot, const Patch& patch) {
                                                  larger(speed, mag(geometry.wallVelocity(patch.wallAt(foot.region),
                                                                                          in3D(x_i) - foot.distance * foot.normal)));
                                              });
            return speed;
        },
        larger);
    return 0.5 * std::accumulate(mass.begin(), mass.end(), 0.0) * sqr(fastest);
}

template class WallRules<2>;
template class WallRules<3>;

}
