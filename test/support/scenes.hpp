/// Particles, walls and a rule for ghosts, all made by hand.
#pragma once
#include "images/Images.hpp"
#include "particlesByHand.hpp"
#include "wallsByHand.hpp"

namespace sph::test
{

/// v_g = -v, so that a test needs no wall model.
template<int dim> class Reversed : public GhostVelocity<dim>
{
public:
    Vector<dim> operator()(Vector<dim> v, std::size_t, const Reflection<dim>&) const override { return -1.0 * v; }
    Vector<dim> change(Vector<dim> dv, const Reflection<dim>&) const override { return -1.0 * dv; }
};

}
