#include "models/scalarTransport/readScalars.hpp"
#include "base/words.hpp"
#include "geometry/wallNames.hpp"
#include "models/scalarTransport/carriedScalar.hpp"
#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <ranges>

namespace sph
{

namespace entry
{
const FreeName scalar{"<scalar>", "dictionary", "a scalar of the case's own name, which is that of its field"};
const FreeName D{"D", "number [m^2/s], or a dictionary of one for each phase", "diffusivity, 0 or more"},
    initial{"initial", "number or expression of $x $y $z, or a dictionary of one for each phase",
            "value where the time folder has none; default 0"},
    walls{"walls", "dictionary of numbers, by wall", "value at a wall; no flux at all others"};
}

EntryList scalarEntries() { return {{entry::scalar, {entry::D, entry::initial, entry::walls}}}; }

namespace
{
using Words = std::vector<std::string>;

double readDiffusivity(const Dictionary& d, const std::string& key)
{
    const double D = d.get(key, units::kinematicViscosity);
    if (D < 0) d.error(key, fmt::format("a diffusivity is 0 or more [m^2/s], not {:.6g}", D));
    return std::max(0.0, D);
}

std::vector<std::optional<double>> readWallValues(const Dictionary& d, const Geometry& geometry)
{
    std::vector<std::optional<double>> values(geometry.walls.size());
    const auto names = wallNames(geometry);
    const auto walls = d.subDictOrEmpty("walls");
    for (const auto& key : walls.keys())
    {
        const auto found = std::find(names.begin(), names.end(), key);
        const double value = walls.get<double>(key);
        if (found != names.end()) values[std::size_t(found - names.begin())] = value;
        else if (names.empty()) walls.error(key, "there are no walls in constant/geometry");
        else walls.error(key, fmt::format("wall \"{}\" is unknown. {}", key, suggestion(key, "walls", names)));
        if (!geometry.layers.empty())
            walls.error(key,
                        "a value at a wall needs ghosts that mirror the fluid: take `walls reflected` in system/sphSchemes, or leave this "
                        "wall out");
    }
    return values;
}

/// A name is a file of the time folder, and no other field's.
void checkName(const Dictionary& d, const Settings& settings, const std::vector<TransportedScalar>& before)
{
    const auto name = d.keyword();
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
    if (!std::isalpha(static_cast<unsigned char>(name[0])) || !std::all_of(name.begin(), name.end(), plain))
        d.diagnostics().error(d.location(),
                              fmt::format("\"{}\" is no name of a scalar: it begins with a letter, and has letters, digits and _ alone",
                                          name));
    const TransportedScalar scalar{name, {}, {}, {}};
    bool taken = false;
    for (const auto& own : {name, scalar.rateName(), name + "_0"})
    {
        taken = taken || settings.fieldClasses.contains(own);
        for (const auto& evolving : settings.state)
            taken = taken || own == evolving.value.name || own == evolving.startName() || (evolving.rate && own == evolving.rate->name);
        for (const auto& [field, onDisk] : settings.shown) taken = taken || own == onDisk;
        for (const auto& other : before) taken = taken || own == other.name || own == other.rateName() || own == other.name + "_0";
    }
    const auto names = std::views::keys(settings.fieldClasses);
    if (taken)
        d.diagnostics().error(
            d.location(),
            fmt::format("\"{}\" is the name of a field already, or that of its rate is: give the scalar another one. Names of "
                        "fields: {}",
                        name, list(Words(names.begin(), names.end()))));
}
}

std::vector<TransportedScalar> readScalars(const Reading& reading)
{
    std::vector<TransportedScalar> scalars;
    if (!reading.theCase.has("constant/scalarTransport")) return scalars;
    const auto dict = reading.theCase.dictionary("constant/scalarTransport");
    const auto& phases = reading.settings.coefficients.phases;
    for (const auto& name : dict.keys())
    {
        if (!dict.isDictionary(name))
        {
            dict.error(name, fmt::format("scalar \"{0}\" must be a dictionary: {0} {{ D 1e-9; }}", name));
            continue;
        }
        const auto d = dict.subDict(name);
        checkName(d, reading.settings, scalars);
        scalars.push_back(
            {name, ofPhases<double>(d, "D", phases, readDiffusivity), readInitial(d, phases), readWallValues(d, reading.geometry)});
    }
    dict.reportUnused();
    return scalars;
}

}
