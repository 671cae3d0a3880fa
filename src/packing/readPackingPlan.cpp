#include "case/phaseEntries.hpp"
#include "geometry/makeWallLayers.hpp"
#include "models/tension/sigmaEntry.hpp"
#include "packing/Packing.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const DictionaryList fill{"fill", byScene("all of the first phase"),
                          "regions and what is in them; the last that contains a particle decides"};
const Word fillPhase{"phase", required, "phase in the region, or none"};
const Scalar p{"p", units::pressure, byScene("that of pressure"), "pressure in the region, above the background pressure"};
const VectorParameter packedVelocity{"U", units::mPerS, byScene("that of velocity"), "velocity in the region"};
const Word lattice{"lattice", byScene("cubic"), "cubic; hexagonal in 2-D, fcc and bcc in 3-D"};
const Scalar jitter{"jitter", Unit{units::none, "spacings"}, 0,
                    between(0, 0.5).saying("a jitter of {:g} spacings is none of 0 to 0.5: beyond, neighbours change places"),
                    "largest displacement of each component"};
const Count latticeSeed{"seed", 1, anyNumber, "of the jitter"};
const Switch allowEmpty{"allowEmpty", false, "a phase may have no particles"};
const SubDictionary relax{"relax", byScene("no relaxation"), "move particles until their number density is even"},
    saturation{"saturation", notGiven, "give a share of the void space to one phase"},
    velocity{"velocity", byScene("at rest"), "velocity at the start"};

const RelaxationSettings usual;
const Count steps{"steps", usual.steps, nonNegative, "most steps"};
const ListOf<double> bias{"bias", std::vector<double>{usual.bias[0], usual.bias[1]},
                          "pressure that all particles share, at the start and at the end"};
const Scalar tolerance{"tolerance", units::none, usual.tolerance, nonNegative, "scatter of the number density at walls at which to stop"},
    coefficient{"coefficient", units::none, usual.coefficient,
                positiveUpTo(1).saying("coefficient {:g} makes the relaxation unstable; above 0 and at most 1"),
                "of each step; 0.2 to 0.8 do"};
}

namespace
{
/// The neighbour tables of the relaxation reach a little beyond the support.
constexpr double reachPerSupport = 1.1;

std::vector<PhaseToPack> readPhases(const Dictionary& dict)
{
    std::vector<PhaseToPack> phases;
    for (const auto& name : entry::phases(dict))
    {
        const auto phase = dict.subDict(name);
        phases.push_back({name, entry::rho(phase), phase.location()});
    }
    if (phases.empty() && entry::phases.given(dict)) entry::phases.error(dict, "no phase is named: phases (water air);");
    return phases;
}

std::vector<FillRule> readFill(const Dictionary& dict, std::vector<std::string> phaseNames, const Geometry& g)
{
    std::vector<FillRule> rules;
    phaseNames.push_back("none");
    const auto given = entry::fill(dict);
    if (given.empty() && entry::fill.given(dict))
        entry::fill.error(dict, "fill lists no region. Without the entry the first phase fills everything: fill ( { region all; phase " +
                                    phaseNames[0] + "; } );");
    for (const auto& d : given)
    {
        FillRule rule{readRegion(d, g), FillRule::noPhase, entry::packedVelocity.ifGiven(d), entry::p.ifGiven(d)};
        const auto phase = std::find(phaseNames.begin(), phaseNames.end(), entry::fillPhase.among(d, phaseNames)) - phaseNames.begin();
        if (phase < long(phaseNames.size()) - 1) rule.phase = int(phase);
        rules.push_back(std::move(rule));
    }
    return rules;
}

LatticeSpec readLattice(const Dictionary& dict, int dimension, double spacing)
{
    LatticeSpec lattice;
    lattice.type = entry::lattice.among(dict, latticeNames(dimension), latticeNames(dimension).front());
    lattice.spacing = spacing;
    lattice.jitter = entry::jitter(dict);
    lattice.seed = std::uint64_t(entry::latticeSeed(dict));
    if (entry::latticeSeed.given(dict) && !(lattice.jitter > 0))
        entry::latticeSeed.error(dict, "seed does nothing without jitter: leave it out, or give the jitter");
    return lattice;
}

RelaxationSettings readRelaxation(const Dictionary& dict)
{
    RelaxationSettings s;
    s.steps = entry::steps(dict);
    const auto bias = entry::bias(dict);
    if (bias.size() != 2 || bias[0] <= 0 || bias[1] <= 0)
        entry::bias.error(dict, "bias is two positive numbers, at the start and at the end: bias (1 0.01);");
    else s.bias = {bias[0], bias[1]};
    s.tolerance = entry::tolerance(dict);
    s.coefficient = entry::coefficient(dict);
    return s;
}

}

EntryList packingEntries()
{
    return {entry::lattice,
            entry::jitter,
            entry::latticeSeed,
            entry::allowEmpty,
            {entry::fill, regionEntries() + EntryList{entry::fillPhase, entry::packedVelocity, entry::p}},
            {entry::saturation, saturationEntries()},
            {entry::velocity, velocityEntries()},
            entry::pressure,
            {entry::relax, {entry::steps, entry::bias, entry::tolerance, entry::coefficient}}};
}

PackingPlan readPackingPlan(const Case& c)
{
    PackingPlan plan;
    const auto schemes = c.dictionary("system/sphSchemes");
    const auto resolution = readResolution(schemes);
    const double spacing = resolution.spacing;
    plan.kernel = resolution.kernel;
    plan.support = resolution.H();
    plan.spacingAt = resolution.where;

    const auto geometry = c.dictionary("constant/geometry");
    plan.geometry = readGeometry(geometry, resolution, reachPerSupport, c.folder());
    if (wallsAreLayers(schemes)) plan.geometry.layers = makeWallLayers(plan.geometry, plan.support, spacing, c.diagnostics());
    if (c.diagnostics().ok()) plan.bedPeriod = bedPeriod(geometry);
    const auto g = c.dictionaryIfPresent("constant/g");
    const Vector<3> gravity = entry::gravity(g, {});
    entry::gravity.checkPlane(g, gravity, plan.geometry.dimension);
    plan.g = mag(gravity);

    const auto properties = c.dictionary("constant/phaseProperties");
    plan.phases = readPhases(properties);
    double heaviest = 0;
    for (const auto& phase : plan.phases) heaviest = std::max(heaviest, phase.rho);
    if (const auto pairs = entry::sigma(properties); !pairs.empty() && pairs.front().value > 0)
        plan.bondPerArea = heaviest * plan.g / pairs.front().value;

    std::vector<std::string> names;
    for (const auto& phase : plan.phases) names.push_back(phase.name);
    const auto dict = c.dictionaryIfPresent("system/packParticlesDict");
    plan.lattice = readLattice(dict, plan.geometry.dimension, spacing);
    plan.latticeAt = entry::jitter.given(dict) ? entry::jitter.where(dict) : entry::lattice.where(dict);
    plan.allowEmpty = entry::allowEmpty(dict);
    plan.fill = readFill(dict, names, plan.geometry);
    if (entry::saturation.given(dict))
        plan.saturation = readSaturation(entry::saturation(dict), names, plan.g > 0 ? -1 / plan.g * gravity : Vector<3>{0, 1, 0});
    if (entry::velocity.given(dict)) plan.velocity = readVelocity(entry::velocity(dict));
    if (entry::pressure.given(dict)) plan.pressure = readPressure(dict);
    if (entry::relax.given(dict)) plan.relaxation = readRelaxation(entry::relax(dict));
    plan.relaxAt = entry::relax.where(dict);
    dict.ignore("solids"); // see src/solids
    dict.reportUnused();
    geometry.reportUnused();
    c.diagnostics().throwIfAny();
    return plan;
}

}
