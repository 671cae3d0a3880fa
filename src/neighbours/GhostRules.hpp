/// What a wall model says of its ghosts, of one pair of a particle and its ghost.
#pragma once
#include "Vector.hpp"
#include <cstddef>

namespace sph
{

/// Where an image was mirrored, for the velocity rule: `distance` of the source from the wall [m], `normal` into the fluid at the foot
/// point, `weight` the volume factor of this one reflection.
template<int dim> struct Reflection
{
    double distance, weight;
    Vector<dim> normal;
    int wall;
    Vector<3> foot;
    double ratio = 1; ///< distance of the ghost from the wall over that of the source: not 1 where it is no mirror image (WallLayers.hpp)
};

/// How the velocity of a ghost follows from its source's: a wall model.
template<int dim> class GhostVelocity
{
public:
    virtual ~GhostVelocity() = default;
    /// v: velocity of what is mirrored; `once` is true where it is the owned particle `source` itself, not a ghost of it.
    virtual Vector<dim> operator()(Vector<dim> v, std::size_t source, const Reflection<dim>&, bool once) const = 0;
    /// By how much the ghost's velocity changes with that of what is mirrored: the rule's linear part.
    virtual Vector<dim> change(Vector<dim> dv, const Reflection<dim>&) const = 0;
    /// After each change of the arrays that the rule may read; and at the end of each step, for rules that keep a state.
    virtual void bind() {}
    virtual void filter() {}
};

/// How the pressure of a ghost follows from its source's.
template<int dim> class GhostPressure
{
public:
    virtual ~GhostPressure() = default;
    virtual double operator()(double p, std::size_t source, const Reflection<dim>&) const = 0;
    /// After each change of the arrays that the rule may read.
    virtual void bind() = 0;
};

}
