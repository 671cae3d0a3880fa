#include "reference.hpp"
#include "FunctionObject.hpp"
#include "Opening.hpp"
#include "Packing.hpp"
#include "RunTime.hpp"
#include "SweepPlan.hpp"
#include "readPhases.hpp"
#include "readTransport.hpp"
#include "resolutionEntries.hpp"
#include "surfaceEntries.hpp"
#include "wallLayers.hpp"

namespace sph
{

namespace
{

EntryRegistry collect()
{
    EntryRegistry all;
    all.add("constant/g", gravityEntries(), "gravity; without the file there is none");
    all.add("constant/geometry", geometryEntries(), "space, its periodic directions, and the walls in it");
    all.add("constant/openings", openingEntries(), "inlets and outlets; without the file there are none");
    all.add("constant/phaseProperties", phaseEntries(), "the liquids and gases");
    all.add("constant/transportProperties", transportEntries(), "what moves relative to the flow; without the file there is nothing of it");
    all.add("system/controlDict", RunTime::entries(), "times, output and function objects");
    all.add("system/controlDict", {{SubDictionary{"functions", notGiven, ""}, functionEntries()}});
    all.add("system/packParticlesDict", packingEntries(), "how packParticles fills the space between the walls; the file may be missing");
    all.add("system/reconstructSurfaceDict", surfaceEntries(), "the surfaces that reconstructSurface makes; the file may be missing");
    all.add("system/sphSchemes", entry::resolution::entries(), "resolution, models and integration");
    all.add("system/sphSchemes", wallLayersEntries());
    all.add("system/workPrecisionDict", sweepEntries(), "the runs that workPrecision makes and what it compares");
    return all;
}

}

const EntryRegistry& reference()
{
    static const auto all = collect();
    return all;
}

}
