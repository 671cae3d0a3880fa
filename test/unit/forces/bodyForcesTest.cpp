/// Gravity and body forces against plain loops.
#include "PlainSums.hpp"

namespace sph::test
{
namespace
{

template<int dim> void bodyForces()
{
    Scene<dim> s(periodicBox(dim), coefficients<dim>(3), with(summed, {"gravity", "bodyForce"}));
    const Plain<dim> plain(s);
    const auto& c = s.coefficients;
    expectEqual(s, Acceleration{}, [&](std::size_t i) { return in<dim>(c.g) + 1 / plain.rho[i] * in<dim>(c.bodyForce); });
}
TEST(BodyForces, BodyForcesIn2D) { bodyForces<2>(); }
TEST(BodyForces, BodyForcesIn3D) { bodyForces<3>(); }

}
}
