#include "schemes/schemeSets.hpp"
#include "dictionary/addDefaults.hpp"
#include <algorithm>
#include <vector>

namespace sph
{

namespace
{
struct Set
{
    const char *name, *meaning;
    std::string words, resolution = "", kernel = "wendlandC2"; ///< `resolution` holds the support, which goes with the kernel
    std::string all() const { return resolution.empty() ? words : "resolution { " + resolution + " } " + words; }
};

const std::vector<Set>& sets()
{
    static const std::vector<Set> all{
        {"suite", "enclosed fluids, at rest or in motion; what measurements favour where nothing else is known", ""},
        {"freeSurface", "one liquid that does not fill its space, whose boundary layers are thinner than a spacing",
         "density continuity; densityDiffusion 0.1; densityDiffusionForm antuono; densityRelaxation 100; artificialViscosity 0.02; pressureGradient tensileControlled; shifting 2; "
         "shiftingAtSurface tangential; wallPressure detaching; wallVelocity freeSlip; integration { scheme leapfrog; }"},
        {"twoPhase", "fluids with interfaces that splash", "shifting 2;"},
        {"suspension", "powder in a binder", "shifting 2; integration { scheme semiImplicit; }", "kernel quinticSpline; support 2.6;",
         "quinticSpline"},
        {"channel", "one liquid that creeps or flows along walls", "integration { scheme implicit; }", "support 2.6;"},
        {"enclosed", "one liquid that turns between walls",
         "shifting 4; shiftingSpeed largest; backgroundPressure 0; integration { scheme symplecticEuler; }", "support 3.2;"},
        {"bed", "one liquid that travels through a bed of grains", "transportVelocity 1; integration { scheme symplecticEuler; }",
         "support 2.6;"},
        {"soil", "soil by a constitutive law", "density continuity; integration { scheme symplecticEuler; }"},
        {"paper",
         "what Barker et al. (2012) printed, but for edges: images of edges and vertices are the suite's, not the paper's point reflection and fan of "
         "planes, which leave 360 - 4 phi degrees empty behind a corner of phi < 90 degrees of fluid",
         ""},
        {"paperPowder",
         "what Kauzlaric et al. (2011) printed of powder in a binder, eqs. (3.1) to (3.8), and the walls of Morris et al. (1997); their kernel is not",
         "density continuity; continuityForm mass; volume continuity; pressureGradient massWeighted; "
         "viscosity clearyMonaghan; shearRate gradient; powderFraction ofDensity; walls layers; wallVelocity morris; integration { migration explicit; }",
         "kernel cubicSpline; support 2.4;", "cubicSpline"}};
    return all;
}

const Set& set(const std::string& name)
{
    const auto found = std::find_if(sets().begin(), sets().end(), [&](const Set& s) { return s.name == name; });
    return found == sets().end() ? sets().front() : *found;
}

/// Messages name the user's line, and the set whose word it is: "system/sphSchemes:4, scheme bed:1".
Dictionary dictionaryOf(const Set& s, const std::string& words, const Dictionary& sphSchemes)
{
    const auto chosenAt = sphSchemes.found("scheme") ? toString(sphSchemes.where("scheme")) + ", " : "";
    return Dictionary::parse(words, chosenAt + "scheme " + s.name, sphSchemes.sharedDiagnostics());
}

ChoiceWords names()
{
    ChoiceWords words;
    for (const auto& s : sets()) words.push_back({s.name, s.all().empty() ? s.meaning : s.meaning + (": " + s.all())});
    return words;
}
}

namespace entry
{
const Choice scheme{
    "scheme", names(),
    byScene(
        "freeSurface where one liquid, without openings, fills less than 95 % of its space and the file has none of that set's words; soil where the phase has `stress constitutiveLaw`; else suite"),
    "the set of defaults"};
}

void addSchemeSet(const Dictionary& sphSchemes) { addSchemeSet(sphSchemes, entry::scheme(sphSchemes, "suite")); }

void addSchemeSet(const Dictionary& sphSchemes, const std::string& name)
{
    const auto& s = set(name);
    const auto resolution = sphSchemes.subDictOrEmpty("resolution");
    const bool anotherKernel = resolution.found("kernel") && !resolution.isWord("kernel", s.kernel);
    addDefaults(sphSchemes, dictionaryOf(s, anotherKernel ? s.words : s.all(), sphSchemes));
}

bool givesWordsOf(const std::string& name, const Dictionary& sphSchemes)
{
    const auto keys = dictionaryOf(set(name), set(name).all(), sphSchemes).keys();
    return std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return key != "integration" && sphSchemes.found(key); });
}

std::string wordsOfSet(const std::string& name) { return set(name).all(); }

EntryList schemeEntries() { return {entry::scheme}; }

}
