#include "Geometry.hpp"
#include "components.hpp"
#include "readShapes.hpp"
#include "readSpace.hpp"
#include "words.hpp"
#include <fmt/format.h>

namespace sph
{

void readSpace(const Dictionary& dict, Geometry& g)
{
    g.dimension = dict.get<int>("dimension");
    if (g.dimension != 2 && g.dimension != 3)
    {
        if (dict.found("dimension")) dict.error("dimension", "dimension must be 2 or 3");
        g.dimension = 3;
    }
    const auto domain = dict.subDict("domain");
    const bool given = domain.found("min") && domain.found("max");
    g.low = domain.getVector("min", units::m);
    g.high = domain.getVector("max", units::m);
    for (int k = 0; k < 3; ++k)
    {
        const auto c = component(k);
        if (g.high.*c > g.low.*c) continue;
        if (k < g.dimension && given)
            domain.error("max", fmt::format("max must be greater than min; in {} it is {} against {}", coordinateNames[k],
                                            g.high.*c, g.low.*c));
        g.high.*c = g.low.*c + 1;
    }
    static const std::vector<std::string> directions{"x", "y", "z"};
    for (const auto& word : domain.get<std::vector<std::string>>("periodic", {}))
    {
        if (word == "x" || word == "y" || (word == "z" && g.dimension == 3))
            g.periodic[word[0] - 'x'] = true;
        else if (word == "z")
            domain.error("periodic", "a 2-D scene does not vary with z: it cannot be periodic there");
        else
            domain.error("periodic", fmt::format("\"{}\" is no direction. {}", word, suggestion(word, "directions", directions)));
    }
}

WallProperties readWallProperties(const Dictionary& dict, bool mayTurn)
{
    WallProperties wall;
    wall.name = dict.keyword();
    wall.where = dict.location();
    wall.wets = dict.found("contactAngle");
    wall.contactAngle = dict.get("contactAngle", units::none, wall.contactAngle);
    if (!(wall.contactAngle >= 0 && wall.contactAngle <= 180))
        dict.error("contactAngle", fmt::format("contactAngle must be between 0 and 180 degrees, not {}", wall.contactAngle));
    wall.velocity = dict.getVector("velocity", units::mPerS, {});
    if (mayTurn)
    {
        wall.omega = dict.getVector("omega", units::none / units::s, {});
        wall.origin = dict.getVector("origin", units::m, {});
    }
    return wall;
}

Geometry readGeometry(const Dictionary& dict, double reach)
{
    Geometry g;
    g.reach = reach;
    readSpace(dict, g);
    const auto walls = dict.subDictOrEmpty("walls");
    for (const auto& name : walls.keys())
    {
        if (!walls.isDictionary(name))
        {
            walls.error(name, fmt::format("wall \"{0}\" must be a dictionary: {0} {{ type plane; ... }}", name));
            continue;
        }
        const auto wall = walls.subDict(name);
        auto shapes = readShapes(wall, g);
        g.walls.push_back(readWallProperties(wall, isSingleShape(wall.get<std::string>("type", ""))));
        for (auto& shape : shapes) g.originals.push_back({std::move(shape), int(g.walls.size()) - 1});
    }
    repeatPeriodically(g, reach);
    return g;
}

}
