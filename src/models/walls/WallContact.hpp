/// Nothing passes through a wall: what a step has carried into one, or nearer than d_0, is put there and loses what velocity it has into it, at the
/// end of the step and where its forces are taken.
///
///   d < d_0:   x += (d_0 - d) n,   v -= min(n.v, 0) n;    v = v_w of soil at a wall that holds it
///
/// n unit normal into the fluid of each foot of x, at distance d [m]; d_0 the distance at which the leak guard too holds particles off walls [m].
/// Pressure alone cannot do it: a particle and its image push each other less the nearer they are, and one on the wall is one with its image. Particles
/// come there in gaps below two thirds of a spacing, where more of them are than fit, and thrown against a wall. The contact is inelastic. Soil that is thrown
/// ahead of a flow has no neighbours to rub at and no stress: without the last rule it slides on for good.
///
/// v_w velocity of the wall [m/s].
#pragma once
#include "Particles.hpp"
#include <vector>

namespace sph
{

template<int dim> class WallContact final : public Part<dim>
{
    /// A particle that may come to a wall before lists are built anew. Until it has moved by `clear` [m] from x it cannot be nearer than d_0.
    struct Near
    {
        std::size_t particle;
        Vector<dim> x;
        double clear;
    };
    std::vector<Near> near_;
    bool ofSoil_;

    double holdOff(Particles<dim>&, Near&) const;

public:
    /// `ofSoil`: what touches a wall without slip stays there.
    WallContact(Particles<dim>&, const Numbers&, bool ofSoil) : ofSoil_(ofSoil) {}
    std::vector<Stage<dim>> stages(Place) override;
    void sorted(Particles<dim>&) override;
};

}
