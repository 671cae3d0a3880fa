#include "reference/reference.hpp"
#include "case/RunTime.hpp"
#include "decomposition/readDecomposition.hpp"
#include "elementTests/readElementTests.hpp"
#include "elementTests/writeElementTests.hpp"
#include "figures/FigurePlan.hpp"
#include "kernels/resolutionEntries.hpp"
#include "packing/Packing.hpp"
#include "sampling/FunctionObject.hpp"
#include "schemes/schemeSets.hpp"
#include "solids/entries/SolidsPlan.hpp"
#include "solids/entries/bedTables.hpp"
#include "solver/models.hpp"
#include "solver/readPhases.hpp"
#include "solver/readSettings.hpp"
#include "surfaces/entries/surfaceEntries.hpp"
#include "surfaces/entries/surfaceTable.hpp"
#include "sweeps/ResultTable.hpp"
#include "sweeps/SweepPlan.hpp"
#include "sweeps/cloneCase.hpp"
#include "verification/verification.hpp"

namespace sph
{

namespace
{

EntryRegistry collect()
{
    addVerification();
    EntryRegistry all;
    all.add("constant/g", gravityEntries(), "gravity; without the file there is none");
    all.add("constant/geometry", geometryEntries(), "space, its periodic directions, and the walls in it");
    all.add("constant/phaseProperties", phaseEntries(), "the liquids and gases");
    all.add(soilProperties, soilEntries(), "the law of soil and how its stress is integrated");
    all.add("system/controlDict", RunTime::entries(), "times, output and function objects");
    all.add("system/controlDict", {{SubDictionary{"functions", notGiven, ""}, functionEntries()}});
    all.add(decompositionDictionary, decompositionEntries(),
            "how particles are shared, between ranks (`sphFoamLike -parallel`, for which the file may be missing) and between "
            "folders (`decomposeParticles`)");
    all.add("system/packParticlesDict", packingEntries(), "how packParticles fills the space between the walls; the file may be missing");
    all.add("system/packParticlesDict", solidsEntries());
    all.add("system/reconstructSurfaceDict", surfaceEntries(), "the surfaces that reconstructSurface makes; the file may be missing");
    all.add("system/sphSchemes", entry::resolution::entries(), "resolution, models and integration");
    all.add("system/sphSchemes", schemeEntries());
    for (const auto* model : models())
        for (const auto& each : model->entries) all.add(each.file, each.entries, each.meaning);
    all.add(elementTestDictionary, elementTestEntries(), "what elementTest does to one element of soil");
    all.add("system/workPrecisionDict", sweepEntries(), "the runs that workPrecision makes and what it compares");
    all.add(variantsDictionary, variantEntries(), "runs beside the case itself, as cloneCase makes them: what each changes");
    all.add(figuresDictionary, figureEntries(), "tables of figures that caseFigures makes of what the runs of a case have left");
    for (const auto& table : functionTables()) all.add(table);
    for (const auto& table : {surfaceTable(), bedTable(), heightTable(), radialTable(), sizesTable(), grainsTable(), contactsTable(),
                              resultTable(), elementTestTable()})
        all.add(table);
    return all;
}

}

const EntryRegistry& reference()
{
    static const auto all = collect();
    return all;
}

}
