#include "models/soil/soil.hpp"
#include "case/phaseEntries.hpp"
#include "geometry/makeWallLayers.hpp"
#include "models/soil/Excavation.hpp"
#include "models/soil/Hourglass.hpp"
#include "models/soil/OuterWater.hpp"
#include "models/soil/Seepage.hpp"
#include "models/soil/SoilFields.hpp"
#include "models/soil/StressUpdate.hpp"
#include "models/soil/WallFriction.hpp"
#include "models/soil/readPoreWater.hpp"
#include "models/soil/soilTerms.hpp"
#include "operators/BalancedGradient.hpp"
#include "operators/VelocityGradient.hpp"
#include "scene/DensityOfModel.hpp"
#include "soilLaws/soilLaws.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const SubDictionary soil{"soil", notGiven, "how soil is discretised"};
const Scalar correctedFrom{
    "correctedFrom", units::none, CorrectedFrom{}.lambda, between(0.1, 2),
    "least eigenvalue of the moment matrix from which on the velocity gradient is corrected in full; from 0.1 less on in part"},
    alpha{"artificialViscosity", units::none, 1, nonNegative,
          "alpha of Monaghan and Gingold, with the sound speed of the soil's present stiffness"};
const Choice viscosityActs{"viscosityActs",
                           {{"onApproach", "of two particles"},
                            {"always", "on recession, too: for long rest; far too viscous in a collapse"},
                            {"onNoise", "on what the velocity gradients do not explain: smooth flow is not resisted; a pass more"}},
                           "onApproach",
                           "when the artificial viscosity does"};

const Scalar pressure{"pressure", units::pressure, required, nonNegative, "-tr(sigma)/3"},
    confiningPressure{confiningPressureKeyword, units::pressure,
                      byScene("floorPressure with stressFree floor, of laws without tension; else 0"), positive,
                      "on free surfaces, as by a membrane"},
    surface{"surface", units::m, required, anyNumber, "height of the soil's surface, against gravity, from the origin"},
    K0{"K0", units::none, byScene("of the law; needed where it has none"), positive,
       "earth pressure at rest: lateral over vertical stress"};

const SubDictionary excavation{"excavation", notGiven, "soil that is dug out"};
const Text where{"where", required, "an expression of $x, $y, $z [m] and $t [s]: particles go where it is not 0"};

const Choice stressDivergence{
    "stressDivergence",
    {{"symmetric", "conserves momentum, and feels the disorder of particles"},
     {"balanced", "conserves momentum, and is exact for uniform stresses however the particles lie; a pass more"},
     {"corrected", "of differences with the corrected gradient but at surfaces: exact for linear stresses, for quasi-static loading"}},
    "symmetric",
    "the form of the force by the stress"};
const Scalar hourglassStiffness{
    "hourglassStiffness", units::none, 0, between(0, 1),
    "k of a stiffness against motion that no strain answers, with `stressDivergence balanced`; about 0.5 where deformations are small"};
const Scalar stressSmoothing{"stressSmoothing", units::none, 0, between(0, 1),
                             "delta by which the stress's short-wave noise is smoothed; about 0.1 in collapses"};
const Choice smoothingActs{"smoothingActs",
                           {{"onStrain", "by 1/(500 delta) of strain"}, {"always", "at the rate delta c/h: creeps at rest"}},
                           "onStrain",
                           "when the stress is smoothed"};
const Choices shown{
    "shown",
    "fields",
    {"strainRate", "shearStrain", "plasticShearStrain", "stressWork", "seepageVelocity"},
    std::vector<std::string>{},
    "further fields of time folders: D; the integral of sqrt(2 dev D:dev D), to which elastic oscillation adds, and that of the plastic part of D "
    "alone, with laws druckerPrager and mohrCoulomb; the integral of sigma:D; and what seeps, per area of soil, with poreWater"};
const Scalar compactionSpeed{
    "compactionSpeed", units::mPerS, 0, nonNegative,
    "speed of sound of what pushes soil apart where it is denser than 1.05 rho; about 10 times the largest velocity, in flows"};

Cases initialCases()
{
    return {
        {{"isotropic", "the same pressure everywhere"}, {pressure}},
        {{"geostatic",
          "at rest under gravity: vertical stress rho g depth, lateral K0 of it; confiningPressure and water on the surface, or floorPressure at least"},
         {surface, K0}}};
}
const Choice type{"type", wordsOf(initialCases()), required, "what it is"};
const SubDictionary initialStress{initialStressKeyword, byScene("the field sigma of the time folder"),
                                  "stress at the start where there is no field of it"};
}

namespace
{
bool isSoil(const Settings& s) { return s.facts.get<ConstitutiveStress>().exists; }

/// Stress [Pa] at a place, where no field gives it.
using InitialStress = std::function<SymmTensor<3>(Vector<3>)>;

bool isTensionless(const Soil& soil)
{
    return std::visit([]<class Law>(const Law&) { return Law::tensionless; }, soil.law);
}

std::optional<double> earthPressureOf(const Soil& soil)
{
    const auto* law = std::get_if<WuBauer>(&soil.law);
    return law ? law->K0() : std::nullopt;
}

/// p_s of ActingStress.hpp.
double readSurfacePressure(const Dictionary& dict, const Soil& soil)
{
    const bool floored = isTensionless(soil) && soil.integration.stressFree == StressFree::floor;
    const double floor = floored ? soil.integration.floorPressure : 0;
    const auto confining = entry::confiningPressure.ifGiven(dict);
    if (confining && isTensionless(soil) && !floored)
        entry::confiningPressure.error(dict, "on soil whose stress is 0 for good nothing would answer: it goes with `stressFree floor;`");
    if (confining && *confining < floor)
        entry::confiningPressure.error(dict,
                                       fmt::format("{:.6g} Pa is less than floorPressure, {:.6g} Pa: the surface would be free of stress",
                                                   *confining, floor));
    return confining.value_or(floor);
}

std::optional<Digging> readExcavation(const Dictionary& dict)
{
    if (!entry::excavation.given(dict)) return {};
    const auto d = entry::excavation(dict);
    const auto text = entry::where(d);
    if (text.empty()) return {};
    try
    {
        Digging digging{{text, kindInDigging}, entry::where.where(d)};
        if (digging.where.kind() == ExpressionProgram::Kind::number) return digging;
        throw ExpressionError("the result is a vector, not a number");
    }
    catch (const ExpressionError& e)
    {
        entry::where.error(d, fmt::format("\"{}\": {}", text, e.what()));
        return {};
    }
}

/// `water`: null, or the pore pressure at the start, which geostatic stresses are less by, as they are more by what stands on the surface.
InitialStress readInitialStress(const Dictionary& dict, const Soil& soil, const Coefficients& c, const InitialPorePressure& water)
{
    const auto g = c.g;
    const auto d = entry::initialStress.needed(dict);
    const SymmTensor<3> I{1, 0, 0, 1, 0, 1};
    const auto type = entry::type.known(d);
    if (!type) return nullptr;
    const auto confining = entry::confiningPressure.ifGiven(dict);
    if (*type == "isotropic")
    {
        const double p = entry::pressure.needed(d);
        if (!water && confining && p != *confining)
            entry::pressure.error(d,
                                  fmt::format("{:.6g} Pa within is not confiningPressure, {:.6g} Pa: free surfaces would set off at once",
                                              p, *confining));
        return [=](Vector<3>) { return -p * I; };
    }
    const double surface = entry::surface.needed(d);
    if (!(mag(g) > 0))
    {
        entry::type.error(d, "geostatic needs gravity, `value` of constant/g");
        return nullptr;
    }
    const auto ofLaw = earthPressureOf(soil);
    const double K = ofLaw ? entry::K0(d, *ofLaw) : entry::K0.needed(d);
    const double onSurface = confining.value_or(0) + OuterWater(c).pressure(-surface / mag(g) * g);
    return [=, rho = soil.rho, floor = soil.integration.floorPressure](Vector<3> x)
    {
        const auto down = 1 / mag(g) * g;
        const double depth = surface + dot(down, x), total = rho * mag(g) * depth + onSurface;
        const double vertical = std::fmax(total - (water ? water(x) : 0), floor);
        return -vertical * (outer(down) + K * (I - outer(down)));
    };
}

template<int dim> void fill(const Loading& loading, const InitialStress& initial)
{
    for (std::size_t i = 0; i < loading.size(); ++i)
        store(stressIn<dim>(initial({loading.cloud.x[i], loading.cloud.y[i], loading.cloud.z[i]})),
              [&](int c, double q) { loading.values[std::size_t(c)][i] = q; });
}

template<int dim> void checkStress(const Loading& loading, const Soil& soil)
{
    const Location where{loading.cloud.fields.contains(SoilStress::info.name) ? loading.cloud.folder + "/" + SoilStress::info.name
                                                                              : soilProperties,
                         0};
    for (std::size_t i = 0; i < loading.size(); ++i)
    {
        const auto s = in3D(valueAt<StressTensor<dim>>(loading.values, i));
        // Laws with state variables are asked when those are there, too.
        const bool admitted = std::visit(
            [&]<class Law>(const Law& law)
            {
                if constexpr (LawOfState<Law>) return norm(s) == 0 || isCompressive(s);
                else return norm(s) == 0 || law.admits(s);
            },
            soil.law);
        if (admitted && std::isfinite(norm(s))) continue;
        throw CaseError(
            where,
            fmt::format(
                "{} has a stress that the law does not admit, of principal values {:.6g}, {:.6g} and {:.6g} Pa, trace {:.6g} Pa; tension is positive{}",
                loading.cloud.particle(i), principalValues(s)[0], principalValues(s)[1], principalValues(s)[2], trace(s),
                isTensionless(soil) ? ", and this law has none: each principal value and the trace are negative" : ""));
    }
}

Evolving stressOf(const Soil& soil, const InitialStress& initial, int dimension)
{
    Evolving sigma{stateField(SoilStress{})};
    sigma.advancedByModel = sigma.ofMaterial = true;
    sigma.missing = [=](const Loading& loading)
    {
        if (loading.restarted)
            throw CaseError("the time folder that the run goes on from has no field sigma: the stress of the soil is lost");
        if (!initial)
        {
            if (!isTensionless(soil)) return;
            throw CaseError(
                {soilProperties, 0},
                "has no `initialStress`, and the time folder no field sigma: free of stress, soil of this law has no stiffness");
        }
        dimension == 2 ? fill<2>(loading, initial) : fill<3>(loading, initial);
    };
    sigma.check = [=](const Loading& loading)
    {
        if (!loading.restarted) dimension == 2 ? checkStress<2>(loading, soil) : checkStress<3>(loading, soil);
    };
    return sigma;
}

/// The stress of a particle at the start: of the time folder's field, or as `initialStress` says; 0 without either.
SymmTensor<3> stressAtStart(const Loading& loading, const InitialStress& initial, std::size_t i)
{
    const auto& fields = loading.cloud.fields;
    if (const auto field = fields.find(SoilStress::info.name); field != fields.end())
        return valueAt<SymmTensor<3>>(field->second.component, i);
    return initial ? initial({loading.cloud.x[i], loading.cloud.y[i], loading.cloud.z[i]}) : SymmTensor<3>{};
}

/// State variables of the law as fields: from the time folder, or as `initialStress` says.
void addVariables(Settings& settings, const Soil& soil, const InitialStress& initial, const Dictionary& dict)
{
    const int dimension = settings.coefficients.dimension;
    std::visit(
        [&]<class Law>(const Law& law)
        {
            if constexpr (LawOfState<Law>)
            {
                using Variables = typename Law::Variables;
                const auto d = entry::initialStress(dict);
                const bool known = Law::startGiven(d);
                const std::function<Variables(SymmTensor<3>)> startOf =
                    known ? law.readVariables(d) : std::function<Variables(SymmTensor<3>)>([](SymmTensor<3>) { return Variables{}; });
                std::size_t first = 0; // component of all variables
                Variables variables{};
                forEachVariable(
                    variables,
                    [&]<class Part>(const StateVariable& variable, const Part& part)
                    {
                        Evolving evolving{.value = fieldOf(variable, part), .advancedByModel = true, .ofMaterial = true};
                        evolving.missing = [=](const Loading& loading)
                        {
                            if (!known)
                                throw CaseError({soilProperties, 0},
                                                fmt::format("initialStress has no {}, and the time folder no field {}, which law {} needs",
                                                            Law::startWords, variable.name, Law::name));
                            for (std::size_t i = 0; i < loading.size(); ++i)
                            {
                                std::array<double, components<Variables>> all;
                                store(startOf(stressAtStart(loading, initial, i)), [&](int c, double q) { all[std::size_t(c)] = q; });
                                Part value{};
                                fetch(value, [&](int c) { return all[first + std::size_t(c)]; });
                                const auto set = [&](int c, double q) { loading.values[std::size_t(c)][i] = q; };
                                if constexpr (std::is_same_v<Part, double>) store(value, set);
                                else if (dimension == 2) store(stressIn<2>(value), set);
                                else store(value, set);
                            }
                        };
                        first += std::size_t(components<Part>);
                        settings.state.push_back(evolving);
                    });
                if constexpr (LawOfVoidRatio<Law>) settings.facts.give(DensityOfModel{true}, soilProperties);
            }
        },
        soil.law);
}

/// Entries of fluids, which would do nothing, or move particles without their stress.
void refuse(const Reading& reading)
{
    for (const auto* keyword : {"pressureGradient", "backgroundPressure", "pMin", "artificialViscosity", "densityDiffusion",
                                "densityRelaxation", "shifting", "transportVelocity"})
        if (reading.schemes.found(keyword))
            reading.schemes.error(
                keyword,
                fmt::format(
                    "{} goes with a state equation, and the stress of soil is that of a law; its own entries are in `soil {{ ... }}`",
                    keyword));
    for (const auto* file : {"constant/openings", "constant/transportProperties"})
        if (reading.theCase.has(file))
            reading.schemes.diagnostics().error({file, 0}, "does not go with soil: `stress constitutiveLaw` in constant/phaseProperties");
}

bool shows(const std::vector<std::string>& shown, const char* field) { return std::ranges::find(shown, field) != shown.end(); }

/// The field of `shown` that grows from step to step.
StateField integralOf(const std::string& name)
{
    for (const auto& field : {stateField(ShearStrain{}), stateField(PlasticShearStrain{})})
        if (field.name == name) return field;
    return stateField(StressWork{});
}

/// Hypoplastic laws have no elastic part: all of their strain is of one kind, and stays in part when the stress goes back.
void refusePlasticStrain(const Reading& reading, const Soil& soil)
{
    const auto d = entry::soil(reading.schemes);
    const auto shown = entry::shown(d);
    if (!shows(shown, PlasticShearStrain::info.name)) return;
    const auto [name, plastic] = std::visit([]<class Law>(const Law&) { return std::pair(Law::name, ElastoPlasticLaw<Law>); }, soil.law);
    if (!plastic)
        entry::shown.error(
            d,
            fmt::format(
                "plasticShearStrain is of laws that are linearly elastic within a yield surface, druckerPrager and mohrCoulomb; of law {} "
                "shearStrain has all of it",
                name));
}

void declare(const Reading& reading)
{
    const auto& phases = reading.settings.coefficients.phases;
    const bool exists =
        std::ranges::any_of(phases, [&](const auto& name) { return entry::stress.is(reading.phases.subDictOrEmpty(name), byLaw); });
    if (!exists) return;
    reading.settings.facts.give(ConstitutiveStress{true}, "constant/phaseProperties");
    reading.settings.facts.give(SchemeSet{"soil"}, "constant/phaseProperties");
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    if (!isSoil(settings))
    {
        if (reading.theCase.has(soilProperties))
            reading.theCase.diagnostics().error(
                {soilProperties, 0},
                "does nothing here: no phase of constant/phaseProperties has `stress constitutiveLaw`. Give it to one, or take "
                "the file away");
        return;
    }
    refuse(reading);
    const auto dict = reading.theCase.dictionary(soilProperties);
    const auto soil = readSoil(dict);
    if (settings.multiphase()) entry::rho.error(dict, "soil goes with one phase alone; constant/phaseProperties lists several");
    else if (soil.rho != c.restDensity[0])
        entry::rho.error(dict, fmt::format("{:.6g} kg/m^3 is not the density of {} in constant/phaseProperties, {:.6g} kg/m^3", soil.rho,
                                           c.phases[0], c.restDensity[0]));
    const auto water = readPoreWater(reading, dict);
    const auto initial = entry::initialStress.given(dict) ? readInitialStress(dict, soil, c, water) : nullptr;
    SoilNumbers numbers;
    numbers.surfacePressure = readSurfacePressure(dict, soil);
    if (const auto digging = readExcavation(dict)) settings.runningModels.push_back(running<Excavation>(*digging));
    c.set(numbers);
    settings.state.push_back(stressOf(soil, initial, c.dimension));
    addVariables(settings, soil, initial, dict);
    dict.reportUnused();
    settings.state.push_back({.value = stateField(SoilSound{}), .advancedByModel = true, .written = false});
    for (const auto& field : entry::shown(entry::soil(reading.schemes)))
        if (field == StrainRate::info.name || field == SeepageVelocity::info.name) settings.shown.emplace_back(field, field);
        else settings.state.push_back({.value = integralOf(field), .advancedByModel = true, .ofMaterial = true});
    refusePlasticStrain(reading, soil);
    if (!water && shows(entry::shown(entry::soil(reading.schemes)), SeepageVelocity::info.name))
        entry::shown.error(entry::soil(reading.schemes),
                           "seepageVelocity is that of `poreWater` in constant/soilProperties, which is not there");
    settings.ruleReads[ActingStress::info.name] = {stateField(Density{})};
    if (reading.geometry.withFriction())
    {
        settings.state.push_back({.value = stateField(WallShear{}), .advancedByModel = true, .ofMaterial = true});
        settings.ruleReads[ActingStress::info.name].push_back(stateField(WallShear{}));
    }
    c.set(soil);
}

/// Terms by which a stress, that of the soil or of its water, accelerates.
struct Divergence
{
    std::vector<std::string> ofSoil, ofWater;
};
Divergence divergenceTerms(const std::string& form)
{
    if (form == "balanced") return {{"balancedSoilStress"}, {"balancedPoreStress"}};
    if (form == "corrected") return {{"soilStressDifference", "soilStressAtSurface"}, {"poreStressDifference", "poreStressAtSurface"}};
    return {{"soilStressDivergence"}, {"poreStressDivergence"}};
}

/// Adds the state of the balanced gradient and of the hourglass stiffness, and the laws that advance it behind the strain.
void balanceGradient(Settings& settings, bool stiffens)
{
    settings.groups.back().terms.emplace_back("gradientImbalance");
    settings.groups.push_back({ofBalance, {"gradientOffset"}});
    settings.state.push_back({.value = stateField(GradientOffset{}), .advancedByModel = true});
    if (!stiffens) return;
    for (const auto* term : {"hourglassForce", "unstrainedOffFit"}) settings.terms.emplace_back(term);
    settings.groups.back().terms.emplace_back("unstrainedMotion");
    settings.state.push_back({.value = stateField(UnstrainedMotion{}), .advancedByModel = true});
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    const auto d = entry::soil(reading.schemes);
    SoilNumbers numbers;
    if (isSoil(settings)) numbers = c.of<SoilNumbers>();
    numbers.alpha = entry::alpha(d);
    numbers.actsOnRecession = entry::viscosityActs(d) == "always";
    numbers.smoothing = entry::stressSmoothing(d);
    numbers.smoothsAtRest = entry::smoothingActs(d) == "always";
    numbers.hourglass = entry::hourglassStiffness(d);
    numbers.compactionSpeed = entry::compactionSpeed(d);
    numbers.compactFrom = 1.05 * c.restDensity[0];
    const CorrectedFrom corrected{entry::correctedFrom(d)};
    const auto divergence = entry::stressDivergence(d);
    const auto shown = entry::shown(d);
    if (!(numbers.smoothing > 0) && entry::smoothingActs.given(d))
        entry::smoothingActs.error(d, "smoothingActs does nothing without stressSmoothing: give that, or leave this out");
    if (numbers.hourglass > 0 && divergence != "balanced")
        entry::hourglassStiffness.error(d, "hourglassStiffness goes with `stressDivergence balanced;`: give that, or leave this out");
    if (!(numbers.alpha > 0) && entry::viscosityActs.given(d))
        entry::viscosityActs.error(d, "viscosityActs does nothing with artificialViscosity 0: leave it out");
    if (!isSoil(settings))
    {
        if (entry::soil.given(reading.schemes))
            entry::soil.error(reading.schemes,
                              "does nothing without soil: no phase of constant/phaseProperties has `stress constitutiveLaw`");
        if (const auto* wall = reading.geometry.withFriction())
            reading.schemes.diagnostics().error(
                wall->where,
                fmt::format("frictionAngle of {} is that of soil: no phase of constant/phaseProperties has `stress constitutiveLaw`",
                            wall->name));
        return;
    }
    const auto& soil = c.of<Soil>();
    if (isTensionless(soil) && soil.integration.stressFree == StressFree::floor) numbers.floorPressure = soil.integration.floorPressure;
    c.set(numbers);
    c.set(corrected);
    for (const auto* term : {"meanPressure", c.has<PoreWater>() ? "totalStress" : "actingStress"}) reading.select(term);
    const bool balanced = divergence == "balanced";
    const std::string gradient = balanced ? "balancedVelocityGradient" : "velocityGradient";
    const auto [ofSoil, ofWater] = divergenceTerms(divergence);
    for (const auto& term : ofSoil) reading.select(term);
    if (numbers.alpha > 0 && entry::viscosityActs(d) == "onNoise")
        for (const auto& term : {gradient, std::string("soilNoiseViscosity")}) reading.select(term);
    else if (numbers.alpha > 0) reading.select("soilViscosity");
    settings.groups.push_back({ofStrain, {gradient}, {Velocity::info.name}});
    if (shows(shown, StrainRate::info.name)) settings.groups.back().terms.emplace_back(StrainRate::info.name);
    if (numbers.smoothing > 0) settings.groups.back().terms.insert(settings.groups.back().terms.end(), {"fitWeights", "stressNoise"});
    if (balanced) balanceGradient(settings, numbers.hourglass > 0);
    if (c.has<TwoLevels>()) settings.state.push_back({.value = stateField(OlderStress{}), .advancedByModel = true});
    if (c.has<PoreWater>()) selectPoreWater(reading, ofWater, shows(shown, SeepageVelocity::info.name));
    settings.runningModels.push_back(running<StressUpdate>());
    settings.integration.factorsOfRunningModels.push_back(&StepFactors::sound);
    if (reading.geometry.withFriction()) settings.runningModels.push_back(running<WallFriction>());
    settings.facts.give(EnergyAdvice{"a smaller `soundFactor` in `integration`"}, soilProperties);
}
}

const Model& soilModel()
{
    static const Model model{
        "soil",
        "stress of a constitutive law, which lives from step to step",
        read,
        soilTerms<2>(),
        soilTerms<3>(),
        prepare,
        {{"density",
          [](const Settings& s) { return isSoil(s) && (!s.facts.get<IntegratedDensity>().exists || s.facts.get<VolumeOfPlaces>().exists); },
          "soil has an integrated density and the volume m/rho: take continuity, and leave `volume` out"},
         {"integration",
          [](const Settings& s)
          {
              return isSoil(s) && s.integration.scheme != "symplecticEuler" && s.integration.scheme != "leapfrog" &&
                     !s.coefficients.has<TwoLevels>();
          },
          "the stress of soil lives in the middle of steps, with one evaluation there, or at the ends of Verlet's: take scheme symplecticEuler, leapfrog or verlet"},
         {"integration", [](const Settings& s) { return s.coefficients.has<PoreWater>() && s.integration.scheme != "symplecticEuler"; },
          "poreWater is solved for between the velocities of a step's end and its strain: take scheme symplecticEuler"},
         {"soil",
          [](const Settings& s)
          {
              return s.coefficients.has<PoreWater>() && s.coefficients.of<PoreWater>().projects &&
                     std::ranges::find(s.terms, std::string("balancedSoilStress")) == s.terms.end();
          },
          "`projection exact;` of poreWater solves for a divergence whose adjoint is the force: take `stressDivergence balanced;` in `soil`"},
         {"walls", [](const Settings& s) { return s.coefficients.has<PoreWater>() && s.has(entry::wallKind, "layers"); },
          "pore water meets walls by ghosts that mirror the soil: take walls reflected"},
         {"integration",
          [](const Settings& s) { return isSoil(s) && s.coefficients.has<TwoLevels>() && hasVariables(s.coefficients.of<Soil>().law); },
          "the state variables of this law live at one level of time: take scheme symplecticEuler or leapfrog"}},
        {},
        {{soilProperties,
          {entry::confiningPressure,
           {entry::excavation, {entry::where}},
           {entry::initialStress, EntryList{{entry::type, entry::initialCases()}} + variableEntries()},
           poreWaterEntries()}},
         {"system/sphSchemes",
          {{entry::soil,
            {entry::alpha, entry::viscosityActs, entry::correctedFrom, entry::stressDivergence, entry::hourglassStiffness,
             entry::stressSmoothing, entry::smoothingActs, entry::compactionSpeed, entry::shown}}}}},
        declare};
    return model;
}

}
