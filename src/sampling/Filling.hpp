/// Function object `filling`: the filled share of a cavity.
#pragma once
#include "sampling/FunctionContext.hpp"
#include <limits>
#include <optional>

namespace sph
{

/// Filled share of a cavity, and the powder in it.
///
///     type filling;  min (0 -1e-3 0);  max (1e-3 1e-3 2e-4);  level 0.99;      // the box: all of the domain unless given
///
/// The cavity is what walls leave of the box, sampled on a lattice of cells of about the particles' spacing h. `filled` is the volume of the
/// fluid in it, sum m/rho_0, over that of the cavity, sum over the cells of their volume times min(max(1/2 + d/h, 0), 1), d the distance of the
/// middle from the walls: exact for walls along the lattice, and to 0.5 % for a ball of 6 spacings to its radius
/// (test Filling.hasTheVolumeOfTheCavity). `reached` is the share of the cells with their middle in the cavity that have a particle within a
/// spacing of it. Where a part has stopped short `reached` stays below 1. The fill time is the first time at which it was `level`; a run that
/// ends before has made a short shot. Columns of filling.dat: filled, reached, and of a suspension the least and largest phi in the box.
class Filling : public FunctionObject
{
    FunctionContext context_;
    Box box_;
    double level_;
    std::vector<bool> cavity_; ///< of the lattice's cells, x fastest
    std::array<int, 3> n_{1, 1, 1};
    Vector<3> step_{1, 1, 1};         ///< edges of a cell [m]
    double samples_ = 0, volume_ = 0; ///< cells whose middle is in the cavity; volume of the cavity [m^3, in 2-D m^2]
    std::optional<double> fillTime_;
    double filled_ = 0, reached_ = 0, leastPhi_ = 0, mostPhi_ = 0;
    std::optional<OutputTable> table_;

    void findCavity(double spacing);
    Vector<3> centre(int i, int k, int l) const;
    double shareReached(const ParticleView&) const;

public:
    static EntryList entries();
    static TableInfo table();
    Filling(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override;
    Histories histories() const override { return fillTime_ ? Histories{{"fillTime", {*fillTime_}}} : Histories{}; }
    void restore(const Histories& stored) override
    {
        if (const auto found = stored.find("fillTime"); found != stored.end() && !found->second.empty()) fillTime_ = found->second[0];
    }
};

}
