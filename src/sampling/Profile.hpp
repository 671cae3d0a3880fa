/// Function object `profile`: fields and expressions along a line.
#pragma once
#include "sampling/FunctionContext.hpp"
#include "sampling/SampledValues.hpp"

namespace sph
{

/// Fields and expressions along a straight line, in points or as means over slabs across it.
///
///     type profile;  start (0 0 0);  end (0 1e-3 0);  fields (U p);  nPoints 50;      // or: bins 20;
///     type profile;  start (0 0 0);  end (0 1e-3 0);  expressions { speed "mag($U)"; }  bins 20;
///
/// `nPoints` interpolates at equidistant points from start to end (linear form of Interpolator): `line_U_p.xy`. `bins` divides
/// the line into equal lengths and takes the volume-weighted mean of all particles that project on each, whatever their distance
/// from the line: cell means, `bins_U_p.xy`, with the number of particles in the last column. Written to
/// postProcessing/<name>/<time>/, first column the distance from start [m]; nan where there is no particle.
class Profile : public FunctionObject
{
    FunctionContext context_;
    Vector<3> start_, end_;
    SampledValues sampled_;
    int points_, bins_;

    std::string pointRows(const ParticleView&, const std::vector<SampledValues::Value>&) const;
    std::string binRows(const ParticleView&, const std::vector<SampledValues::Value>&) const;

public:
    static EntryList entries();
    static TableInfo table();
    Profile(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
};

}
