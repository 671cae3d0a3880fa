/// Contact of particles with walls: nothing passes through. A particle that a step has carried into a wall, or nearer than d_0, is put there and loses its
/// velocity into it, at the end of the step and where its forces are taken.
///
///   d < d_0:   x += (d_0 - d) n,   v -= min(n.(v - v_w), 0) n;    of soil v = v_w at a wall that holds it,
///              v_t -= min(1, mu |dv_n|/|v_t - v_w|) (v_t - v_w) at one of friction mu = tan(delta)
///
/// Between two walls at an acute angle either would turn v into the other: there v keeps what it has along their edge.
///
/// n unit normal into the fluid of each foot of x, at distance d [m]; d_0 the distance at which the leak guard too holds particles off walls [m].
/// Pressure alone cannot do it: a particle and its image push each other less the nearer they are, and one on the wall is one with its image. Particles
/// come there in gaps below two thirds of a spacing, where more of them are than fit, and thrown against a wall. Out of crevices narrower than half a spacing, where grains touch,
/// they are held likewise, as by a wall across them (geometry/crevice.hpp). The contact is inelastic. Soil that is thrown
/// ahead of a flow has no neighbours to rub at and no stress: without the last rule it slides on for good.
///
/// v_w velocity of the wall [m/s], t the part along it, dv_n what v has lost across it [m/s].
#pragma once
#include "scene/Particles.hpp"
#include <array>
#include <vector>

namespace sph
{

template<int dim> class WallContact final : public RunningModel<dim>
{
    /// A particle that may come to a wall before lists are built anew. Until it has moved by `clear` [m] from x, or walls beyond `walls` [m], it cannot be nearer than d_0.
    struct Near
    {
        std::size_t particle;
        Vector<dim> x;
        double clear, walls;
    };
    /// Columns of positions or velocities.
    using Columns = std::array<double*, dim>;
    std::vector<Near> near_;
    bool rubs_, slips_;

    static std::vector<std::pair<std::size_t, double>> nearFeet(const Particles<dim>&, double distance);
    /// Finds the particles near walls.
    void find(const Particles<dim>&);
    double holdOff(const Particles<dim>&, const Columns& x, const Columns& v, Near&) const;
    Vector<dim> rubbed(Vector<dim> v, Vector<dim> before, const WallProperties&, Vector<dim> v_w) const;

public:
    /// `rubs`: what touches a wall without slip stays there, as soil does; `slips`: walls do that say nothing of it.
    WallContact(Particles<dim>&, const Numbers&, bool rubs, bool slips) : rubs_(rubs), slips_(slips) {}
    std::vector<Stage<dim>> stages(JoinPoint) override;
};

}
