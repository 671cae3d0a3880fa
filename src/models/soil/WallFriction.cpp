#include "models/soil/WallFriction.hpp"
#include "models/soil/SoilFields.hpp"
#include "scene/TwoLevels.hpp"

namespace sph
{

namespace
{
template<int dim> Vector<dim> along(Vector<dim> a, Vector<dim> n) { return a - dot(n, a) * n; }
}

template<int dim>
WallFriction<dim>::WallFriction(Particles<dim>& particles, const Numbers&) : atEnds_(particles.coefficients().template has<TwoLevels>())
{}

template<int dim> std::vector<Stage<dim>> WallFriction<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::sorted)
        return {{"joints", "tau = 0 of particles that have left the walls", [this](Particles<dim>& p, const Substep&) { find(p); }}};
    if (place != (atEnds_ ? JoinPoint::beforeDrift : JoinPoint::afterKick)) return {};
    return {{"wall friction", "tau += dt k v_s, |tau| <= tan(delta) max(0, -n.sigma n - p_f)",
             [this](Particles<dim>& p, const Substep& s)
             {
#pragma omp parallel for schedule(static)
                 for (std::size_t k = 0; k < near_.size(); ++k) slide(p, near_[k], s.deltaT);
             }}};
}

template<int dim> void WallFriction<dim>::find(Particles<dim>& p)
{
    near_.clear();
    for (const auto& [i, d] : p.images().nearFaces(p.coefficients().support + p.skin())) near_.push_back(i);
    // A particle that has left the walls comes back without a joint.
    const auto T = p.store().pointers(WallShear{});
    auto next = near_.begin();
    for (std::size_t i = 0; i < p.size(); ++i)
        if (next != near_.end() && *next == i) ++next;
        else
            for (auto* const q : T) q[i] = 0;
}

template<int dim> void WallFriction<dim>::slide(Particles<dim>& p, std::size_t i, double deltaT) const
{
    auto& store = p.store();
    const auto& geometry = p.geometry();
    const auto& c = p.coefficients();
    const auto ofJoint = store.pointers(WallShear{});
    const auto x = valueAt<Vector<dim>>(store.pointers(Position{}), i), v = valueAt<Vector<dim>>(store.pointers(Velocity{}), i);
    const auto sigma = inPlane(valueAt<StressTensor<dim>>(store.pointers(SoilStress{}), i));
    auto T = valueAt<SymmTensor<dim>>(ofJoint, i);
    const auto& numbers = c.template of<SoilNumbers>();
    const double rho = store.component(Density::info.name, 0)[i], besides = numbers.compactionPressure(rho) - numbers.floorPressure;
    const double stiffness = rho * sqr(store.component(SoilSound::info.name, 0)[i]) / c.spacing;
    p.nearWalls().forEachFoot(in3D(x), c.support,
                              [&](const Foot& foot, const Patch& patch)
                              {
                                  const int index = patch.wallAt(foot.region);
                                  const auto& wall = geometry.walls[std::size_t(index)];
                                  if (!wall.frictionAngle) return;
                                  const auto n = in<dim>(foot.normal);
                                  const auto v_w = in<dim>(geometry.wallVelocity(index, in3D(x) - foot.distance * foot.normal));
                                  const auto joint = along(T * n, n), tau = joint + deltaT * stiffness * along(v - v_w, n);
                                  const double normal =
                                      -dot(n, sigma * n) + besides - foot.distance * dot(n, rho * in<dim>(c.g) + in<dim>(c.bodyForce));
                                  const double strength = wall.frictionCoefficient() * std::fmax(0.0, normal);
                                  const double size = mag(tau);
                                  T = T + 2.0 * symm(outer(n, (size > strength ? strength / size : 1.0) * tau - joint));
                              });
    sph::store(T, [&](int k, double q) { ofJoint[std::size_t(k)][i] = q; });
}

template class WallFriction<2>;
template class WallFriction<3>;

}
