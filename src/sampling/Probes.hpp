/// Function object `probes`: values of fields and expressions at fixed points.
#pragma once
#include "sampling/FunctionContext.hpp"
#include "sampling/SampledValues.hpp"
#include <map>

namespace sph
{

/// Values at fixed points, by the linear form of Interpolator: exact for linear fields.
///
///     type probes;  fields (U p);  expressions { speed "mag($U)"; }  probeLocations ((0 0 0) (1e-3 0 0));
///
/// One file per field or expression, postProcessing/<name>/<startTime>/<field>, in OpenFOAM's format: a header line per probe, then a row per
/// time. A probe with no particle within reach gets nan.
class Probes : public FunctionObject
{
    FunctionContext context_;
    SampledValues sampled_;
    std::vector<Vector<3>> locations_;
    std::map<std::string, OutputTable> files_;

public:
    static EntryList entries();
    static TableInfo table();
    Probes(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
};

}
