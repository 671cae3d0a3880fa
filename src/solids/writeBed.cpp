#include "base/OutputFile.hpp"
#include "case/FoamHeader.hpp"
#include "solids/BedReport.hpp"
#include "solids/rocks/closedSurface.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

std::string report(const SolidsPlan& plan, const Bed& bed, const BedMeasures& m)
{
    std::string text;
    const auto to = std::back_inserter(text);
    fmt::format_to(to, "Solids: {}, mean size {:.6g} m", bed.bodies.size(), bed.meanSize);
    if (bed.sizeFactor != 1) fmt::format_to(to, ", all sizes {:+.3g} % of those asked for", 100 * (bed.sizeFactor - 1));
    text += "\n";
    for (const auto& note : bed.notes) fmt::format_to(to, "    {}\n", note);
    if (bed.takenAway) fmt::format_to(to, "    {} that stood out of the top were taken away\n", bed.takenAway);
    if (!plan.randomClose)
        fmt::format_to(to, "At rest after {:.4g} sqrt(d/g), kinetic energy of a body {:.3g} m g d\n", bed.time, bed.kineticEnergy);
    fmt::format_to(to, "Height: {:.6g} m{}\nPorosity of the middle half: {:.5f}", m.height,
                   plan.randomClose ? "" : " (90 % of the solids end below)", m.porosity);
    if (m.corePorosity) fmt::format_to(to, ", a size away from the sides {:.4f} +- {:.4f}", *m.corePorosity, m.coreError);
    fmt::format_to(to, "\nContacts: {} between solids, coordination number {:.3f}\nLargest overlap: {:.3g} % of the size",
                   bed.contacts.size(), m.coordination, 100 * bed.overlap);
    if (bed.shrunk > 0)
        fmt::format_to(to, "; all solids then made {:.3g} % smaller{}", 100 * bed.shrunk, plan.shrink ? "" : ", so that none overlap");
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

    std::string porosity = "height,porosity\n", contacts = "first,second,gap\n";
    for (std::size_t k = 0; k < m.layerMiddle.size(); ++k) porosity += fmt::format("{:.9g},{:.9g}\n", m.layerMiddle[k], m.layerPorosity[k]);
    for (const auto& [i, j, gap] : bed.contacts) contacts += fmt::format("{},{},{:.6g}\n", i, j, gap);
    write("postProcessing/solids/porosity.csv", porosity);
    write("postProcessing/solids/contacts.csv", contacts);
    write("postProcessing/solids/bed.csv",
          fmt::format(
              "solids,meanSize,height,porosity,corePorosity,contacts,coordination,largestOverlap,shrunk,kineticEnergy\n{},{:.9g},{:.9g},"
              "{:.9g},{},{},{:.9g},{:.6g},{:.6g},{:.6g}\n",
              bed.bodies.size(), bed.meanSize, m.height, m.porosity,
              m.corePorosity ? fmt::format("{:.9g}", *m.corePorosity) : std::string(), bed.contacts.size(), m.coordination, bed.overlap,
              bed.shrunk, bed.kineticEnergy));
    // Last: what it names is there.
    write("constant/solids", solidsText(c, bed));
    return written;
}

}
