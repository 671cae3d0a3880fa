/// Shapes of rocks to pack: see src/solids/rocks.
#include "base/CaseError.hpp"
#include "base/CommandLine.hpp"
#include "base/OutputFile.hpp"
#include "base/words.hpp"
#include "solids/rocks/closedSurface.hpp"
#include "solids/rocks/makeRock.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace
{

struct Choice
{
    std::string kind = "all", format = "obj";
    int count = 1, facets = 80, seed = 1;
    double size = 1;
};

void check(const Choice& choice)
{
    std::vector<std::string> known{"all", "scan"};
    for (const auto& kind : sph::rockKinds()) known.push_back(kind.name);
    const std::vector<std::string> formats{"obj", "stl"};
    const auto oneOf = [](const char* option, const std::string& word, const char* things, const std::vector<std::string>& words)
    {
        if (std::ranges::find(words, word) == words.end())
            throw sph::CaseError(fmt::format("{}: \"{}\" is unknown. {}", option, word, sph::suggestion(word, things, words)));
    };
    oneOf("-kind", choice.kind, "kinds", known);
    oneOf("-format", choice.format, "formats", formats);
    if (choice.count < 1) throw sph::CaseError(fmt::format("-count {}: at least 1", choice.count));
    if (choice.facets < sph::fewestFacets) throw sph::CaseError(fmt::format("-facets {}: at least {}", choice.facets, sph::fewestFacets));
    if (!(choice.size > 0)) throw sph::CaseError(fmt::format("-size {}: must be positive", choice.size));
}

void write(const std::filesystem::path& folder, const std::string& name, const std::string& format, const sph::TriangleSurface& s)
{
    const auto moments = sph::volumeMoments(s);
    const auto file = "constant/triSurface/" + name + "." + format;
    sph::writeFile(folder / file, format == "obj" ? sph::objText({{name, s}}) : sph::stlBytes(s));
    const auto loose = sph::looseEdges(s);
    fmt::print("{:<40} {:>7} facets, volume {:.6g} m^3{}\n", file, s.triangles.size(), moments.volume,
               loose ? fmt::format(", {} edges that are not shared by two facets", loose) : "");
}

}

int main(int argc, char** argv)
{
    Choice choice;
    return sph::runApplication(
        "makeRocks", argc, argv,
        "Makes shapes of rocks in constant/triSurface: <kind><number>, closed surfaces, and a scan with the faults of one.",
        [&](sph::CommandLine& line)
        {
            std::string kinds = "all, scan";
            for (const auto& kind : sph::rockKinds()) kinds += fmt::format(", {} ({})", kind.name, kind.meaning);
            line.option("kind", choice.kind, "word", "One of: " + kinds);
            line.option("count", choice.count, "n", "Shapes of each kind (default 1)");
            line.option("facets", choice.facets, "n",
                        "Facets of each, the nearest possible number (default 80; the scan has 25 times as many)");
            line.option("size", choice.size, "d", "Diameter of the sphere of equal volume [m] (default 1)");
            line.option("seed", choice.seed, "n", "The same seed makes the same shapes (default 1)");
            line.option("format", choice.format, "word", "obj (default, exact) or stl (binary)");
        },
        [&](const std::filesystem::path& folder)
        {
            check(choice);
            sph::createFolders(folder / "constant" / "triSurface");
            const auto seedOf = [&](int number) { return std::uint64_t(choice.seed) * 1000 + std::uint64_t(number); };
            for (const auto& kind : sph::rockKinds())
                if (choice.kind == "all" || choice.kind == kind.name)
                    for (int k = 1; k <= choice.count; ++k)
                        write(folder, kind.name + std::to_string(k), choice.format,
                              sph::makeRock(kind, choice.facets, choice.size, seedOf(k)));
            constexpr int scanned = 25;
            if (choice.kind == "all" || choice.kind == "scan")
                for (int k = 1; k <= choice.count; ++k)
                    write(folder, "scan" + std::to_string(k), choice.format,
                          sph::makeScan(scanned * choice.facets, choice.size, seedOf(k)));
            fmt::print("\nEnd\n");
            return 0;
        });
}
