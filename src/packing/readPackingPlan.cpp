#include "Packing.hpp"
#include "wallLayers.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// The neighbour tables of the relaxation reach a little beyond the support.
constexpr double reachPerSupport = 1.1;

std::vector<PhaseToPack> readPhases(const Dictionary& dict)
{
    std::vector<PhaseToPack> phases;
    for (const auto& name : dict.get<std::vector<std::string>>("phases"))
    {
        const auto phase = dict.subDict(name);
        phases.push_back({name, phase.getPositive("rho", units::density), phase.location()});
    }
    if (phases.empty() && dict.found("phases")) dict.error("phases", "no phase is named: phases (water air);");
    return phases;
}

std::vector<FillRule> readFill(const Dictionary& dict, std::vector<std::string> phaseNames, const Geometry& g)
{
    std::vector<FillRule> rules;
    if (!dict.found("fill")) return rules;
    phaseNames.push_back("none");
    for (const auto& entry : dict.dictionaries("fill"))
    {
        FillRule rule{readRegion(entry, g), FillRule::noPhase, std::nullopt};
        const auto phase =
            std::find(phaseNames.begin(), phaseNames.end(), entry.choose("phase", phaseNames)) - phaseNames.begin();
        if (phase < long(phaseNames.size()) - 1) rule.phase = int(phase);
        if (entry.found("U")) rule.U = entry.getVector("U", units::mPerS);
        rules.push_back(std::move(rule));
    }
    return rules;
}

LatticeSpec readLattice(const Dictionary& dict, int dimension, double spacing)
{
    LatticeSpec lattice;
    lattice.type = dict.choose("lattice", latticeNames(dimension), latticeNames(dimension).front());
    lattice.spacing = spacing;
    lattice.jitter = dict.getNonNegative("jitter", units::none, 0);
    if (lattice.jitter > 0.5)
        dict.error("jitter", fmt::format("a jitter of {:g} spacings lets neighbours change places; at most 0.5", lattice.jitter));
    lattice.seed = std::uint64_t(dict.get<int>("seed", 1));
    return lattice;
}

RelaxationSettings readRelaxation(const Dictionary& dict)
{
    RelaxationSettings s;
    s.steps = dict.get<int>("steps", s.steps);
    if (s.steps < 0) dict.error("steps", "steps cannot be negative");
    const auto bias = dict.get<std::vector<double>>("bias", {s.bias[0], s.bias[1]});
    if (bias.size() != 2 || bias[0] <= 0 || bias[1] <= 0)
        dict.error("bias", "bias is two positive numbers, at the start and at the end: bias (1 0.01);");
    else
        s.bias = {bias[0], bias[1]};
    s.tolerance = dict.getNonNegative("tolerance", units::none, s.tolerance);
    s.coefficient = dict.getPositive("coefficient", units::none, s.coefficient);
    if (s.coefficient > 1)
        dict.error("coefficient", fmt::format("coefficient {:g} makes the relaxation unstable; at most 1", s.coefficient));
    return s;
}

double bedPeriod(const Dictionary& geometry)
{
    const auto walls = geometry.subDictOrEmpty("walls");
    for (const auto& name : walls.keys())
        if (walls.isDictionary(name) && walls.subDict(name).get("type", "") == "sphereBed")
            return walls.subDict(name).get("period", units::m, 0);
    return 0;
}

Vector<3> readGravity(const Case& c)
{
    const auto dict = c.dictionaryIfPresent("constant/g");
    return dict.getVector("value", units::mPerS2, {});
}
}

PackingPlan readPackingPlan(const Case& c)
{
    PackingPlan plan;
    const auto schemes = c.dictionary("system/sphSchemes");
    const auto resolution = schemes.subDict("resolution");
    const double spacing = resolution.getPositive("spacing", units::m);
    plan.kernel = resolution.choose("kernel", kernelNames(), "wendlandC2");
    plan.support = resolution.getPositive("support", units::none, 2.6)*spacing;
    plan.spacingAt = resolution.where("spacing");
    // nothing below can be made of a spacing or a support that is not there
    c.diagnostics().throwIfAny();

    const auto geometry = c.dictionary("constant/geometry");
    plan.geometry = readGeometry(geometry, reachPerSupport*plan.support);
    if (wallsAreLayers(schemes)) plan.geometry.layers = makeWallLayers(plan.geometry, plan.support, spacing, c.diagnostics());
    plan.bedPeriod = bedPeriod(geometry);
    const Vector<3> gravity = readGravity(c);
    plan.g = mag(gravity);

    const auto properties = c.dictionary("constant/phaseProperties");
    plan.phases = readPhases(properties);
    if (properties.found("sigma"))
        if (const auto pairs = properties.pairs("sigma"); !pairs.empty()) plan.surfaceTension = pairs.front().value;

    std::vector<std::string> names;
    for (const auto& phase : plan.phases) names.push_back(phase.name);
    const auto dict = c.dictionaryIfPresent("system/packParticlesDict");
    plan.lattice = readLattice(dict, plan.geometry.dimension, spacing);
    plan.latticeAt = dict.where(dict.found("jitter") ? "jitter" : "lattice");
    plan.allowEmpty = dict.get<bool>("allowEmpty", false);
    plan.fill = readFill(dict, names, plan.geometry);
    if (dict.found("saturation"))
        plan.saturation =
            readSaturation(dict.subDict("saturation"), names, plan.g > 0 ? -1/plan.g*gravity : Vector<3>{0, 1, 0});
    if (dict.found("velocity")) plan.velocity = readVelocity(dict.subDict("velocity"));
    if (dict.found("pressure"))
    {
        plan.pressure = readPressure(dict);
        if (!schemes.isWord("density", "continuity"))
            dict.error("pressure", "a pressure at the start goes with `density continuity;` in system/sphSchemes: "
                                   "else the positions decide it");
    }
    if (dict.found("relax")) plan.relaxation = readRelaxation(dict.subDict("relax"));
    dict.reportUnused();
    geometry.reportUnused();
    c.diagnostics().throwIfAny();
    return plan;
}

}
