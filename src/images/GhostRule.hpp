/// Rules for the values of wall ghosts: an image's value as a function of its source's, where the field's tag says that there is a rule. One for each field,
/// of the field's type, for mirror images and particles of wall layers alike.
#pragma once
#include "base/values.hpp"
#include <cstddef>

namespace sph
{

/// One reflection in a wall: `distance` of the source from the wall [m], `normal` into the fluid at the foot point, `weight` the volume factor of
/// this one reflection.
template<int dim> struct Reflection
{
    double distance, weight;
    Vector<dim> normal;
    int wall;
    Vector<3> foot;
    double ratio = 1; ///< distance of the ghost from the wall over that of the source: not 1 where it is no mirror image (WallLayers.hpp)
    /// An image of an image: -n.m, n and m the normals of this wall and of the one before it, is 1 between parallel plates, 0 at a right angle and less in an open corner.
    /// 1 where the particle itself is mirrored, 0 where a particle of a layer lies behind several walls.
    double facing = 1;
};

/// The interface that all rules share, whatever the type of their field.
class AnyGhostRule
{
public:
    virtual ~AnyGhostRule() = default;
    /// Called after each change of the arrays that the rule may read; and at the end of each step, for rules that keep a state.
    virtual void bind() {}
    virtual void filter() {}
};

template<class Value, int dim> class GhostRule : public AnyGhostRule
{
public:
    /// q: value of the owned particle `source`, or of a ghost of it, that is mirrored.
    virtual Value operator()(Value q, std::size_t source, const Reflection<dim>&) const = 0;
    /// Change of the ghost's value for a change dq of the mirrored value: the rule's linear part.
    virtual Value change(Value dq, const Reflection<dim>&) const = 0;
};
template<int dim> using GhostVelocity = GhostRule<Vector<dim>, dim>;
/// The gradient G_ab = dv_a/dx_b beyond a wall, L G R: the rule's linear part L at a mirror image, of a field that the reflection R has turned.
template<int dim> Tensor<dim> gradientBeyond(const GhostVelocity<dim>& rule, Tensor<dim> G, Reflection<dim> mirror)
{
    mirror.ratio = 1;
    const auto& n = mirror.normal;
    const auto turned = G - 2 * outer(G * n, n);
    Tensor<dim> beyond;
    for (int b = 0; b < dim; ++b)
    {
        Vector<dim> e;
        fetch(e, [&](int c) { return c == b ? 1.0 : 0.0; });
        beyond += outer(rule.change(turned * e, mirror), e);
    }
    return beyond;
}
template<int dim> using GhostPressure = GhostRule<double, dim>;

}
