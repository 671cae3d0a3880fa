#include "soilLaws/soilLaws.hpp"

namespace sph
{

namespace
{

/// Calls f with a law of each type, in the order of the variant.
void forEachLaw(const auto& f)
{
    const auto each = [&]<class... Laws>(std::variant<Laws...>*) { (f(Laws{}), ...); };
    each(static_cast<SoilLaw*>(nullptr));
}

std::string coeffsOf(const std::string& law) { return law + "Coeffs"; }

SubDictionary coefficients(const std::string& law) { return {coeffsOf(law), byScene("needed with law " + law), "constants of law " + law}; }

Cases lawCases()
{
    std::vector<std::pair<ChoiceWord, EntryList>> laws;
    forEachLaw(
        [&]<ConstitutiveLaw Law>(Law)
        {
            if constexpr (OptionOfLaw<Law>) laws.back().second += Law::entries();
            else laws.push_back({{Law::name, Law::meaning}, Law::entries()});
        });
    Cases cases;
    for (const auto& [word, entries] : laws) cases.push_back({word, {{coefficients(word.word), entries}}});
    return cases;
}

constexpr const EmbeddedPair* pairs[]{&dormandPrince, &bogackiShampine};

ChoiceWords pairWords()
{
    ChoiceWords words;
    for (const auto* pair : pairs) words.push_back({pair->name, pair->meaning});
    return words;
}

}

namespace entry
{
const Scalar rho{"rho", units::density, required, positive, "density of the soil with its pores"};
const Choice law{"law", wordsOf(lawCases()), required, "what gives the stress"};
const Scalar reduceStrength{
    "reduceStrength", units::none, 1, positive,
    "factor that cohesion, tan(frictionAngle) and tensile strength are divided by, of laws that have them; dilatancyAngle is at most the angle that is left"};
const Choice integrator{"integrator", pairWords(), dormandPrince.name, "embedded pair of the substeps"};
const Scalar tolerance{"tolerance", units::none, 1e-6, Range{1e-13, 1e-2}, "error of a substep over the stress"};
const Choice turning{"turning",
                     {{"halves", "by half the angle before the strain and half after: second order in the angle of a step"},
                      {"within", "at each stage: the integral of the law at steps of any size"}},
                     byScene("halves; within in elementTest"),
                     "how the stress turns with the material while it is strained"};
const Choice stressFree{"stressFree",
                        {{"floor", "the stress is kept at floorPressure, and acts without it"},
                         {"detached", "the stress is 0 until it is set anew"}},
                        "floor",
                        "what becomes of a mean pressure below floorPressure, with laws whose stiffness vanishes with it"};
const Scalar floorPressure{"floorPressure", units::pressure, 10, Range{1e-100, 1e100}, "below it soil is free of stress"};
}

std::string strengthInWords(const SoilLaw& law)
{
    const auto* const cone = std::get_if<DruckerPrager>(&law);
    if (!cone) return "";
    const auto angles = cone->frictionAngles();
    return fmt::format("friction angle {:.4g} degrees in plane strain, {:.4g} degrees in triaxial compression", angles.planeStrain,
                       angles.triaxialCompression);
}

namespace
{
void reduceStrength(const Dictionary& d, SoilLaw& law)
{
    const double F = entry::reduceStrength(d);
    std::visit(
        [&]<class Law>(Law& l)
        {
            if constexpr (LawOfStrength<Law>) l = l.reduced(F);
            else
                entry::reduceStrength.error(
                    d, fmt::format("law {} has no cohesion and friction angle to reduce; druckerPrager and mohrCoulomb have", Law::name));
        },
        law);
}
}

Soil readSoil(const Dictionary& d, const std::string& turning)
{
    Soil soil;
    soil.rho = entry::rho(d);
    const auto name = entry::law(d);
    if (entry::law.known(d))
        forEachLaw(
            [&]<ConstitutiveLaw Law>(Law)
            {
                if constexpr (OptionOfLaw<Law>)
                {
                    const auto coeffs = d.subDictOrEmpty(coeffsOf(name));
                    if (name == Law::name && Law::given(coeffs)) soil.law = Law::read(coeffs, std::get<typename Law::Option>(soil.law));
                }
                else if (name == Law::name) soil.law = Law::read(d.subDict(coeffsOf(name)));
                else if (d.found(coeffsOf(Law::name))) Law::read(d.subDict(coeffsOf(Law::name))); // of a law to change to: checked alone
            });
    if (entry::reduceStrength.given(d)) reduceStrength(d, soil.law);
    auto& how = soil.integration;
    how.pair = pairs[entry::integrator.index(d)];
    how.tolerance = entry::tolerance(d);
    how.turning = entry::turning(d, turning) == "within" ? Turning::within : Turning::halves;
    how.stressFree = entry::stressFree(d) == "detached" ? StressFree::detached : StressFree::floor;
    how.floorPressure = entry::floorPressure(d);
    return soil;
}

bool hasVariables(const SoilLaw& any)
{
    return std::visit([]<class Law>(const Law&) { return LawOfState<Law>; }, any);
}

EntryList variableEntries()
{
    EntryList entries;
    forEachLaw(
        [&]<ConstitutiveLaw Law>(Law)
        {
            if constexpr (LawOfState<Law>) entries += Law::variableEntries();
        });
    return entries;
}

EntryList soilEntries()
{
    return {entry::rho,       {entry::law, lawCases()}, entry::reduceStrength, entry::integrator,
            entry::tolerance, entry::turning,           entry::stressFree,     entry::floorPressure};
}

}
