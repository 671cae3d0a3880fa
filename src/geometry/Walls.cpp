#include "geometry/Walls.hpp"
#include "base/Hash.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include "case/MappedFile.hpp"
#include "geometry/TriangleMesh.hpp"
#include "geometry/components.hpp"
#include "geometry/readShapes.hpp"
#include "geometry/readSpace.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <ranges>
#include <set>
#include <sstream>

namespace sph
{

namespace
{

/// The file beside a MetaImage (.mhd) that has its voxels; empty of all other files.
std::string voxelFileOf(const std::filesystem::path& file, std::string_view text)
{
    if (file.extension() != ".mhd") return "";
    std::istringstream in{std::string(text)};
    for (std::string key, equals, name; in >> key;)
        if (key == "ElementDataFile" && in >> equals >> name) return name;
    return "";
}

/// Adds a file and, where an #include names one that exists beside it, that file.
void addFile(Hash& hash, const std::filesystem::path& file, std::set<std::filesystem::path>& seen)
{
    if (!seen.insert(file.lexically_normal()).second) return;
    std::string none;
    std::istringstream in(readText(file, none).value_or(""));
    for (std::string line; std::getline(in, line);)
    {
        hash.add(line + '\n');
        const auto start = line.find_first_not_of(" \t");
        const bool includes =
            start != std::string::npos && (line.compare(start, 8, "#include") == 0 || line.compare(start, 9, "#sinclude") == 0);
        const auto open = line.find('"'), close = line.rfind('"');
        if (includes && close > open) addFile(hash, file.parent_path() / line.substr(open + 1, close - open - 1), seen);
        // `file "rocks.stl";` of a mesh or `file "bed.csv";` of spheres, whatever is in it.
        if (includes || !(close > open)) continue;
        std::error_code unknown;
        const auto name = line.substr(open + 1, close - open - 1);
        for (const auto& data : {file.parent_path() / "triSurface" / name, file.parent_path() / name})
        {
            if (!std::filesystem::is_regular_file(data, unknown)) continue;
            const MappedFile bytes(data);
            hash.add(bytes.text());
            if (const auto beside = data.parent_path() / voxelFileOf(data, bytes.text()); std::filesystem::is_regular_file(beside, unknown))
                hash.add(MappedFile(beside).text());
        }
    }
}

std::string text(const Vector<3>& a) { return fmt::format("({} {} {})", a.x, a.y, a.z); }

/// Infinite extents stand for "as far as the domain", which is how the reader makes them infinite again.
Vector<3> withinDomain(Vector<3> a, const Geometry& g)
{
    for (const auto c : coordinates)
        if (std::isinf(a.*c)) a.*c = a.*c < 0 ? g.low.*c : g.high.*c;
    return a;
}

/// Text of the angles with the place in constant/geometry, which is that of a mistake: their meaning the solver alone can tell.
std::string anglesText(const WallProperties& wall)
{
    if (!wall.wets) return "";
    std::string pairs;
    for (const auto& [first, second, angle] : wall.contactAngles) pairs += fmt::format(" ({} {}) {}", first, second, angle);
    const auto angles = pairs.empty() ? fmt::format(" contactAngle {};", wall.contactAngle) : fmt::format(" contactAngles ({} );", pairs);
    return angles + fmt::format(" anglesAt \"{}\";", toString(wall.anglesAt));
}

std::string patchText(const Patch& patch, const Geometry& g)
{
    if (asMesh(*patch.shape))
    {
        std::string regions;
        for (const int w : patch.walls) regions += " " + g.walls[std::size_t(w)].name;
        return fmt::format("    {{ wall {}; type triSurface; regions ({} ); }}\n", g.walls[std::size_t(patch.wall)].name, regions);
    }
    const auto d = patch.shape->description();
    auto line = fmt::format("    {{ wall {}; type {};", g.walls[patch.wall].name, d.type);
    for (const auto& [key, value] : d.vectors) line += fmt::format(" {} {};", key, text(withinDomain(value, g)));
    for (const auto& [key, value] : d.scalars) line += fmt::format(" {} {};", key, value);
    if (d.hasSide) line += d.fluid == FluidSide::inside ? " fluid inside;" : " fluid outside;";
    return line + " }\n";
}

}

std::string geometryStamp(const std::filesystem::path& caseFolder, double spacing, double support)
{
    Hash hash;
    std::set<std::filesystem::path> seen;
    addFile(hash, caseFolder / "constant" / "geometry", seen);
    hash.add(fmt::format("spacing {} support {}", spacing, support));
    return hash.hex();
}

std::string wallsText(const Geometry& g, const std::string& stamp)
{
    std::string periodic;
    for (int k = 0; k < 3; ++k)
        if (g.periodic[k]) periodic += (periodic.empty() ? "" : " ") + std::string(1, coordinateNames[k]);
    std::string out = fmt::format("FoamFile\n{{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n"
                                  "    location    \"constant\";\n    object      walls;\n}}\n\n"
                                  "// Made by meshToGhost from constant/geometry: change it there.\n"
                                  "stamp       \"{}\";\ndimension   {};\n"
                                  "domain      {{ min {}; max {}; periodic ({}); }}\nreach       {};\n\nwalls\n{{\n",
                                  stamp, g.dimension, text(g.low), text(g.high), periodic, g.reach);
    for (const auto& wall : g.walls)
    {
        out += fmt::format("    {} {{", wall.name);
        out += anglesText(wall);
        out += fmt::format(" velocity {};", text(wall.velocity));
        if (wall.omega != Vector<3>{}) out += fmt::format(" omega {}; origin {};", text(wall.omega), text(wall.origin));
        if (wall.slips) out += " slip yes;";
        if (wall.frictionAngle) out += fmt::format(" frictionAngle {};", *wall.frictionAngle);
        if (const auto& load = wall.load)
            out += fmt::format(" load {{ force \"{}\"; direction {}; mass {}; damping {}; }}", load->force, text(load->direction),
                               load->mass, load->damping);
        if (wall.frictionAngle || wall.load) out += fmt::format(" definedAt \"{}\";", toString(wall.where));
        out += " }\n";
    }
    out += "}\n\npatches\n(\n";
    // The bodies of a mesh are one entry.
    for (std::size_t k = 0; k < g.originals.size(); ++k)
        if (const auto& patch = g.originals[k]; k == 0 || !asMesh(*patch.shape) || patch.wall != g.originals[k - 1].wall)
            out += patchText(patch, g);
    return out + ");\n";
}

namespace
{
std::string entryOfStamp(const Dictionary& dict) { return dict.get<std::string>("stamp"); }
}

Geometry readWalls(const Dictionary& dict, const Resolution& resolution, const std::filesystem::path& folder)
{
    Geometry g;
    g.folder = folder;
    g.facetScale = {resolution.spacing, resolution.H()};
    readSpace(dict, g);
    checkFit(g, resolution, dict.diagnostics());
    g.reach = std::max(supportsOfSolver * resolution.H(), dict.get("reach", units::m));
    entryOfStamp(dict);
    std::vector<std::string> names;
    const auto walls = dict.subDict("walls");
    for (const auto& name : walls.keys())
    {
        const auto wall = walls.subDict(name);
        g.walls.push_back(readWallProperties(wall, g.dimension, true));
        readLoad(wall, g.walls.back(), g.dimension);
        const auto readPlace = [&](const char* key, Location& place)
        {
            const std::string at = wall.get(key, "");
            if (const auto colon = at.rfind(':'); colon != std::string::npos)
                place = {at.substr(0, colon), std::atoi(at.c_str() + colon + 1)};
        };
        readPlace("anglesAt", g.walls.back().anglesAt);
        readPlace("definedAt", g.walls.back().where);
        names.push_back(name);
    }
    for (const auto& patch : dict.dictionaries("patches"))
    {
        const auto name = patch.get<std::string>("wall");
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
        {
            if (patch.found("wall")) patch.error("wall", fmt::format("wall \"{}\" is unknown. {}", name, suggestion(name, "walls", names)));
            continue;
        }
        if (isMesh(patch))
        {
            const auto mesh = readMesh(name, g, dict.diagnostics());
            if (!mesh) continue;
            std::vector<int> ofRegions;
            for (const auto& region : patch.get<std::vector<std::string>>("regions"))
                if (const auto at = std::find(names.begin(), names.end(), region); at != names.end())
                    ofRegions.push_back(int(at - names.begin()));
            if (ofRegions.size() != mesh->regions.size())
                patch.error("regions", fmt::format("must name a wall for each of the {} regions of {}: run meshToGhost again",
                                                   mesh->regions.size(), wallMeshFile(name)));
            else addBodies(*mesh, int(found - names.begin()), ofRegions, g);
            continue;
        }
        for (auto& shape : readShapes(patch, g)) g.originals.push_back({std::move(shape), int(found - names.begin())});
    }
    repeatPeriodically(g, g.reach);
    return g;
}

std::string wallInWords(const Geometry& g, int patch, const Vector<3>& x)
{
    const auto& p = g.patches[std::size_t(patch)];
    const auto& name = g.walls[std::size_t(p.wall)].name;
    const auto words = fmt::format("\"{}\"", name);
    if (!p.mesh || !std::filesystem::exists(g.folder / wallMeshFile(name))) return words;
    Diagnostics none;
    const auto surface = readWallMesh(g.folder, name, none);
    const auto y = p.mesh->local(x);
    const auto distanceTo = [&](std::size_t f)
    {
        const auto corner = [&](int k) { return surface.points[std::size_t(surface.triangles[f][std::size_t(k)])]; };
        return mag(y - nearestOnTriangle(y, corner(0), corner(1), corner(2)).point);
    };
    const auto facets = std::views::iota(std::size_t(0), surface.triangles.size());
    const auto nearest = std::ranges::min_element(facets, {}, distanceTo);
    if (nearest == facets.end()) return words;
    const auto& region = g.walls[std::size_t(p.wallAt(surface.region[*nearest]))].name;
    return fmt::format("\"{}\", facet {} of {}", region, *nearest, wallMeshFile(name));
}

Geometry readWalls(const Case& c, const Resolution& resolution)
{
    const auto dict = c.dictionary("constant/walls");
    if (c.has("constant/geometry") && entryOfStamp(dict) != geometryStamp(c.folder(), resolution.spacing, resolution.support))
        c.diagnostics().error({"constant/walls", 0},
                              "does not belong to the present constant/geometry and resolution: run meshToGhost again");
    return readWalls(dict, resolution, c.folder());
}

}
