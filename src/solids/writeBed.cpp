#include "base/OutputFile.hpp"
#include "case/FoamHeader.hpp"
#include "solids/BedReport.hpp"
#include "solids/entries/bedTables.hpp"
#include "solids/rocks/closedSurface.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Shares of the shapes as packed, by number and mass.
std::string sharesText(const Bed& bed)
{
    std::vector<double> number(bed.shapes.size()), mass(bed.shapes.size());
    double all = 0;
    for (const auto& b : bed.bodies)
    {
        const double volume = std::pow(b.size, 3);
        number[std::size_t(b.shape)] += 1.0 / double(bed.bodies.size());
        mass[std::size_t(b.shape)] += volume;
        all += volume;
    }
    std::string text;
    for (std::size_t k = 0; k < bed.shapes.size(); ++k)
        text += fmt::format("    {}: {:.4f} of the number, {:.4f} of the mass\n", bed.shapes[k].isSphere() ? "sphere" : bed.shapes[k].file,
                            number[k], mass[k] / all);
    return text;
}

}

std::string report(const SolidsPlan& plan, const Bed& bed, const BedMeasures& m)
{
    std::string text;
    const auto to = std::back_inserter(text);
    fmt::format_to(to, "Solids: {}, mean size {:.6g} m", bed.bodies.size(), bed.meanSize);
    if (bed.sizeFactor != 1) fmt::format_to(to, ", all sizes {:+.3g} % of those asked for", 100 * (bed.sizeFactor - 1));
    text += "\n";
    if (plan.shapes.size() > 1) text += sharesText(bed);
    for (const auto& note : bed.notes) fmt::format_to(to, "    {}\n", note);
    if (bed.takenAway)
        fmt::format_to(to, "    {} {} were taken away\n", bed.takenAway,
                       plan.filled ? fmt::format("with centres above {:g} m", *plan.filled) : "that stood out of the top");
    if (!plan.randomClose)
        fmt::format_to(to, "At rest after {:.4g} sqrt(d/g){}, kinetic energy of a body {:.3g} m g d\n", bed.time,
                       plan.porosity ? fmt::format(" and {} taps", bed.taps) : "", bed.kineticEnergy);
    fmt::format_to(to, "Height: {:.6g} m{}\nPorosity of the middle half: {:.5f}", m.height,
                   plan.randomClose ? "" : " (90 % of the solids end below)", m.porosity);
    if (m.corePorosity) fmt::format_to(to, ", a size away from the sides {:.4f} +- {:.4f}", *m.corePorosity, m.coreError);
    fmt::format_to(to, "\nContacts: {} between solids, coordination number {:.3f}{}\n", bed.contacts.size(), m.coordination,
                   m.coreCoordination ? fmt::format(", away from the ends and sides {:.3f}", *m.coreCoordination) : "");
    if (m.orientation)
        fmt::format_to(to, "Longest axes: {:+.3f} (1 upright, 0 at random to +- {:.3f}, -0.5 lying)\n", *m.orientation, m.orientationError);
    fmt::format_to(to, "Largest overlap: {:.3g} % of the size", 100 * bed.overlap);
    if (m.shrunk > 0)
        text += plan.shrink ? fmt::format("; all solids then made {:.3g} % smaller", 100 * m.shrunk)
                            : fmt::format("; solids then made smaller until none does, {:.3g} % in the mean", 100 * m.shrunk);
    constexpr double tooMuch = 0.01;
    if (bed.overlap > tooMuch)
        text += "\nWarning: that is more than 1 %. A shape that collides as its convex parts may do so as its \"hull\"";
    text += "\n";
    return text;
}

namespace
{

/// Reads back to the same numbers.
std::string exact(const Vector<3>& a) { return fmt::format("({} {} {})", a.x, a.y, a.z); }

std::string solidsText(const SolidContainer& c, const Bed& bed)
{
    auto text = foamHeader(WriteFormat::ascii, "dictionary", "constant", "solids");
    const auto to = std::back_inserter(text);
    text += "\n// A point X of a shape's file is at  x = centre + scale R (X - centroid),  R by the unit quaternion (w x y z);\n"
            "// of a sphere, whose file would have the diameter 1, scale is the diameter.\n\nshapes\n(\n";
    for (const auto& s : bed.shapes)
        if (s.isSphere()) text += "    { type sphere; }\n";
        else fmt::format_to(to, "    {{ type mesh; file \"{}\"; centroid {}; }}\n", s.file, exact(s.centroid));
    text += ");\n\nbodies\n(\n";
    const auto frame = rotationTo(c.along, c.across, c.up);
    for (const auto& b : bed.bodies)
    {
        const auto q = frame * b.rotation;
        fmt::format_to(to, "    {{ shape {}; scale {}; centre {}; rotation ({} {} {} {}); }}\n", b.shape, b.size / bed.shapeOf(b).fileSize,
                       exact(c.toWorld(b.centre)), q.w, q.v.x, q.v.y, q.v.z);
    }
    return text + ");\n";
}

/// Names of the columns, and rows of as many cells.
std::string csvText(const TableInfo& table, const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::string> names;
    for (const auto& column : table.columns) names.push_back(column.name);
    auto text = fmt::format("{}\n", fmt::join(names, ","));
    for (const auto& row : rows) text += fmt::format("{}\n", fmt::join(row, ","));
    return text;
}

std::string digits(double a) { return fmt::format("{:.9g}", a); }
std::string digits(const std::optional<double>& a) { return a ? digits(*a) : ""; }

/// The curve has a row for each sieve or listed size, else for fifty steps between the smallest size and the largest.
std::string gradingText(const SolidsPlan& plan, const Bed& bed)
{
    const auto& s = plan.size;
    auto sizes = s.sizes;
    constexpr int steps = 50;
    if (sizes.empty())
        for (int k = 0; k <= steps; ++k) sizes.push_back(s.low * std::pow(s.high / s.low, double(k) / steps));
    std::ranges::sort(sizes);
    constexpr double rounding = 1e-9; // what a size has lost on its way
    const double drawn = bed.sizeFactor * (1 + rounding);
    double all = 0;
    for (const auto& b : bed.bodies) all += std::pow(b.size, 3);
    std::vector<std::vector<std::string>> rows;
    for (const double d : sizes)
    {
        double finer = 0;
        for (const auto& b : bed.bodies)
            if (b.size <= d * drawn * (1 - b.shrunk)) finer += std::pow(b.size, 3);
        rows.push_back({digits(d), digits(finer / all), digits(s.passing(d))});
    }
    return csvText(sizesTable(), rows);
}

}

std::vector<std::string> writeBed(const Case& theCase, const SolidsPlan& plan, const Bed& bed, const BedMeasures& m)
{
    const auto& c = plan.container;
    const auto& folder = theCase.folder();
    std::vector<std::string> written;
    const auto write = [&](const std::string& file, const std::string& text)
    {
        createFolders((folder / file).parent_path());
        writeFile(folder / file, text);
        written.push_back(file);
    };
    std::string spheres;
    std::vector<NamedSurface> meshes;
    for (const auto& b : bed.bodies)
    {
        const auto& shape = bed.shapeOf(b);
        if (shape.isSphere())
        {
            const auto x = c.toWorld(b.centre);
            spheres += fmt::format("    ({} {} {} {})\n", x.x, x.y, x.z, 0.5 * b.size);
        }
        else meshes.push_back({shape.name, placed(c, shape, b)});
    }
    std::ranges::stable_sort(meshes, {}, &NamedSurface::name);
    // A file of an earlier bed would be taken for this one's.
    const auto writeOrRemove = [&](const std::string& file, bool isThere, const auto& text)
    {
        if (isThere) write(file, text());
        else std::filesystem::remove(folder / file);
    };
    writeOrRemove("constant/solidSpheres", !spheres.empty(),
                  [&] {
                      return "// (x y z radius) of each: in constant/geometry, #include \"solidSpheres\"\nspheres\n(\n" + spheres + ");\n";
                  });
    writeOrRemove("constant/triSurface/solids.obj", !meshes.empty(), [&] { return objText(meshes); });
    for (const auto& shape : bed.shapes)
        if (shape.isAgglomerate()) write(shape.file, objText({{shape.name, shape.mesh}}));

    std::vector<std::vector<std::string>> layers, shells, grains, contacts;
    for (std::size_t k = 0; k < m.layerMiddle.size(); ++k) layers.push_back({digits(m.layerMiddle[k]), digits(m.layerPorosity[k])});
    for (const auto& shell : m.shells)
        shells.push_back(
            {digits(shell.radius), digits((c.radius - shell.radius) / bed.meanSize), digits(shell.porosity), digits(shell.error)});
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        const auto& grain = m.grains[i];
        const auto x = c.toWorld(b.centre);
        grains.push_back({digits(x.x), digits(x.y), digits(x.z), std::to_string(b.shape), digits(b.size), std::to_string(grain.contacts),
                          digits(grain.gap), digits(grain.tilt)});
    }
    for (const auto& [i, j, gap] : bed.contacts) contacts.push_back({std::to_string(i), std::to_string(j), fmt::format("{:.6g}", gap)});
    const std::string tables = "postProcessing/solids/";
    write(tables + heightTable().file, csvText(heightTable(), layers));
    write(tables + contactsTable().file, csvText(contactsTable(), contacts));
    write(tables + grainsTable().file, csvText(grainsTable(), grains));
    writeOrRemove(tables + radialTable().file, !shells.empty(), [&] { return csvText(radialTable(), shells); });
    writeOrRemove(tables + sizesTable().file, plan.size.high > plan.size.low, [&] { return gradingText(plan, bed); });
    write(tables + bedTable().file,
          csvText(bedTable(),
                  {{std::to_string(bed.bodies.size()), digits(bed.meanSize), digits(m.height), digits(m.porosity), digits(m.corePorosity),
                    std::to_string(bed.contacts.size()), digits(m.coordination), digits(bed.overlap), digits(m.shrunk),
                    digits(bed.kineticEnergy), m.corePorosity ? digits(m.coreError) : "", digits(m.coreCoordination), digits(m.orientation),
                    m.orientation ? digits(m.orientationError) : "", std::to_string(bed.taps)}}));
    // Last: what it names is there.
    write("constant/solids", solidsText(c, bed));
    return written;
}

}
