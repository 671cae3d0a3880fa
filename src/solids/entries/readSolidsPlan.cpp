#include "case/phaseEntries.hpp"
#include "solids/entries/SolidsPlan.hpp"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <numeric>

namespace sph
{

namespace entry
{
const SubDictionary solids{"solids", notGiven, "a bed of solids, which packParticles -solids packs and all other programs leave alone"},
    container{"container", required, "what the solids lie in; open at the top, which is where gravity comes from"},
    solidSize{"size", required, "diameters, of meshes those of the sphere of equal volume"};
const Choice method{"method",
                    {{"settle", "rigid bodies fall and come to rest (Bullet)"},
                     {"randomClose", "spheres that overlap push one another apart until none does; the top is closed"}},
                    "settle",
                    "how the bed is made; of randomClose the porosity and the sizes decide on the number of spheres"};
const Count solidsSeed{"seed", 1, anyNumber, "the same seed makes the same bed"},
    count{"count", byScene("needed without height"), between(1, 1e6).saying("count {}: 1 to a million solids can be packed"),
          "number of solids"};
const Scalar filled{"height", units::m, byScene("that of count solids"), positive,
                    "the bed reaches it: as many solids as that takes; those whose centres come to lie above are taken away"};
const DictionaryList solidShapes{"shapes", byScene("spheres"), "the shapes, each with its share"};
const FileName meshFile{"file", "constant/triSurface", byScene("a sphere"),
                        "closed surface in constant/triSurface: .stl, .stlb, .obj, .ply, .off, .gltf or .glb, normals outwards"};
const Scalar share{"share", units::none, 1, positive,
                   "of the solids that have the shape; without sharesOf a weight, with it their sum is 1"};
const Choice sharesOf{"sharesOf", {"number", "mass"}, byScene("number"), "what the shares of shapes are of"};
const Choice collision{"collision",
                       {{"automatic", "hull where it has at most 2 % more volume than the shape, else parts"},
                        {"hull", "the convex hull"},
                        {"parts", "convex parts (HACD, Mamou & Ghorbel 2009) whose hulls cover the shape"}},
                       "automatic",
                       "what a mesh collides as"};

const SubDictionary fines{"fines", notGiven, "fines bound to each solid of the shape, as agglomeration leaves them: one mesh with it"};
const Scalar finesShare{"massShare", units::none, required, positiveBelow(0.5).saying("massShare {} is none of 0 to 0.5"),
                        "of the agglomerate that is fines"},
    finesMin{"min", units::none, required, positiveBelow(1), "smallest fine, over the size of the grain"},
    finesMax{"max", units::none, byScene("min"), positiveBelow(1), "largest fine, over the size of the grain; sizes are evenly between"},
    bond{"bond", units::none, 0.25, between(0.05, 0.5).saying("bond {} is none of 0.05 to 0.5"),
         "depth to which a fine reaches into the grain, over its size"};
const FileName finesFile{"file", "constant/triSurface", byScene("a sphere of 80 facets"),
                         "closed surface of a fine, in constant/triSurface"};
const Count finesVariants{"variants", 1, between(1, 100), "different agglomerates that are made of the shape"};

const Choice containerType{"type", {"box", "cylinder"}, required, "shape of the container"};
const VectorParameter boxMin{"min", units::m, required, "lowest corner"}, boxMax{"max", units::m, required, "highest corner"},
    cylinderBase{"base", units::m, required, "middle of the bottom; the axis is along gravity"};
const ListOf<std::string> boxPeriodic{"periodic", byScene("(), no direction"),
                                      "directions in which a box repeats; the one along gravity for randomClose alone"};
const Scalar cylinderRadius{"radius", units::m, required, positive, "of the cylinder"},
    cylinderHeight{"height", units::m, required, positive, "of the cylinder"};

const Scalar friction{"friction", units::none, 0.5, nonNegative, "coefficient of Coulomb's friction, at solids and container"},
    restitution{"restitution", units::none, 0.1, between(0, 1), "of the speed after an impact"},
    restEnergy{"restEnergy", units::none, 1e-6, positive, "mean kinetic energy over m g d below which the bed is at rest"},
    timeLimit{"timeLimit", Unit{units::none, "sqrt(d/g)"}, 400, positive, "time after which a bed that is not at rest is an error"},
    targetPorosity{"porosity", units::none, byScene("the least that is reached"), positiveBelow(1), "to be reached"},
    settledPorosity{"porosity", units::none, byScene("that of its fall"), positiveBelow(1),
                    "of the middle half of the height: the container is tapped until the bed is as dense"};
const AutomaticScalar shrink{
    "shrink", units::none, byScene("automatic"), between(0, 0.1).saying("shrink {} is none of 0 to 0.1"),
    "share by which solids are made smaller in the end, so that surfaces do not cross and the gaps where they touch are resolved; "
    "automatic: each as much as parts it from others and the container, of meshes a little more"};
const Switch level{"level", false, "take away what stands out of the top, which is an error else"};
}

double SolidContainer::area() const { return isCylinder ? std::numbers::pi * radius * radius : length * width; }

double SolidContainer::narrowest() const
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    return isCylinder ? 2 * radius : std::min(periodic[0] ? endless : length, periodic[1] ? endless : width);
}

int FinesToBind::count() const
{
    const double a = smallest, b = largest, cube = b > a ? (std::pow(b, 4) - std::pow(a, 4)) / (4 * (b - a)) : a * a * a;
    return std::max(1, int(std::lround(massShare / ((1 - massShare) * cube))));
}

namespace
{

/// Adds the shape of an entry of `shapes`, several of them where there are different agglomerates of it.
void addShape(const Dictionary& d, std::vector<ShapeToPack>& shapes)
{
    const auto file = entry::meshFile.ifGiven(d);
    ShapeToPack shape{file ? "constant/triSurface/" + *file : "",
                      entry::share(d),
                      CollisionForm(entry::collision.index(d)),
                      {},
                      file ? entry::meshFile.where(d) : d.location()};
    if (!entry::fines.given(d)) return shapes.push_back(shape);
    const auto dict = entry::fines(d);
    FinesToBind fines;
    fines.where = dict.location();
    fines.massShare = entry::finesShare(dict);
    if (const auto fine = entry::finesFile.ifGiven(dict)) fines.file = "constant/triSurface/" + *fine;
    fines.smallest = entry::finesMin(dict);
    fines.largest = entry::finesMax(dict, fines.smallest);
    fines.bond = entry::bond(dict);
    if (fines.largest < fines.smallest)
        entry::finesMax.error(dict, fmt::format("max {:g} is less than min {:g}", fines.largest, fines.smallest));
    constexpr int most = 300;
    if (fines.smallest > 0 && fines.massShare > 0 && fines.massShare < 0.5)
        if (const int count = fines.count(); count > most)
            entry::finesMin.error(
                dict, fmt::format("a grain takes {} fines of these sizes; {} are possible. Larger fines, or a smaller massShare, are fewer",
                                  count, most));
    const int variants = entry::finesVariants(dict);
    shape.share /= variants;
    // Their files are named by the grain's: numbers go on where several entries have fines on one grain.
    const auto nameOf = [](const ShapeToPack& s) { return std::filesystem::path(s.file).stem(); };
    fines.variant = int(std::ranges::count_if(shapes, [&](const auto& other) { return other.fines && nameOf(other) == nameOf(shape); }));
    for (int k = 0; k < variants; ++k, ++fines.variant)
    {
        shape.fines = fines;
        shapes.push_back(shape);
    }
}

/// A box has its edges along the coordinates: `up` is the one nearest to `against gravity`, which must be along it.
SolidContainer readBox(const Dictionary& dict, const Vector<3>& up, const Location& gravityAt)
{
    SolidContainer c;
    const std::array<Vector<3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    int vertical = 2;
    for (int k = 0; k < 3; ++k)
        if (std::abs(dot(up, axes[std::size_t(k)])) > 1 - 1e-9) vertical = k;
    if (std::abs(dot(up, axes[std::size_t(vertical)])) < 1 - 1e-9)
        dict.diagnostics().error(gravityAt, "gravity is along no edge of the container: turn it, or use a cylinder");
    const bool isUpsideDown = dot(up, axes[std::size_t(vertical)]) < 0;
    const int first = (vertical + 1) % 3, second = (vertical + 2) % 3;
    c.along = axes[std::size_t(first)];
    c.across = isUpsideDown ? -axes[std::size_t(second)] : axes[std::size_t(second)];
    c.up = isUpsideDown ? -axes[std::size_t(vertical)] : axes[std::size_t(vertical)];
    const auto low = entry::boxMin(dict), high = entry::boxMax(dict);
    const auto size = high - low;
    if (entry::boxMin.given(dict) && entry::boxMax.given(dict) && !(size.x > 0 && size.y > 0 && size.z > 0))
        entry::boxMax.error(dict, "max must be greater than min in each direction");
    const auto extent = [&](const Vector<3>& axis) { return std::abs(dot(size, axis)); };
    c.length = extent(c.along);
    c.width = extent(c.across);
    c.height = extent(c.up);
    c.base = isUpsideDown ? low + c.width * -c.across + c.height * -c.up : low;
    static const std::vector<std::string> names{"x", "y", "z"};
    for (const auto& name : entry::boxPeriodic(dict, {}))
    {
        const auto k = int(std::ranges::find(names, name) - names.begin());
        if (k == 3) entry::boxPeriodic.error(dict, fmt::format("\"{}\" is no direction: x, y, z", name));
        else c.periodic[k == first ? 0 : k == second ? 1 : 2] = true;
    }
    return c;
}

SolidContainer readCylinder(const Dictionary& dict, const Vector<3>& up)
{
    SolidContainer c;
    c.isCylinder = true;
    c.up = up;
    // Perpendicular to up: the coordinate that it is least along.
    const Vector<3> least = std::abs(up.x) < 0.6 ? Vector<3>{1, 0, 0} : Vector<3>{0, 1, 0};
    const auto a = least - dot(least, up) * up;
    c.along = a / mag(a);
    c.across = cross(c.up, c.along);
    c.base = entry::cylinderBase(dict);
    c.radius = entry::cylinderRadius(dict);
    c.height = entry::cylinderHeight(dict);
    return c;
}

const EntryList& containerEntries()
{
    using namespace entry;
    static const EntryList entries{
        {containerType, {{"box", {boxMin, boxMax, boxPeriodic}}, {"cylinder", {cylinderBase, cylinderRadius, cylinderHeight}}}}};
    return entries;
}

}

EntryList solidsEntries()
{
    using namespace entry;
    return {{solids,
             {{method,
               {{"settle",
                 {count,
                  filled,
                  settledPorosity,
                  {solidShapes, {meshFile, share, collision, {fines, {finesShare, finesMin, finesMax, finesFile, bond, finesVariants}}}},
                  sharesOf,
                  entry::friction,
                  entry::restitution,
                  entry::restEnergy,
                  timeLimit,
                  entry::level}},
                {"randomClose", {targetPorosity}}}},
              solidsSeed,
              entry::shrink,
              {container, containerEntries()},
              {solidSize, sizeEntries()}}}};
}

SolidsPlan readSolidsPlan(const Case& c)
{
    SolidsPlan plan;
    const auto all = c.dictionary("system/packParticlesDict");
    c.diagnostics().throwIfAny();
    if (!entry::solids.given(all))
        throw CaseError(all.location(), "has no section \"solids\", which says what packParticles -solids packs");
    const auto dict = entry::solids(all);
    plan.where = dict.location();
    const auto gravityFile = c.dictionaryIfPresent("constant/g");
    const auto gravity = entry::gravity(gravityFile, {0, 0, -1});
    const auto up = mag(gravity) > 0 ? -gravity / mag(gravity) : Vector<3>{0, 0, 1};

    plan.randomClose = entry::method(dict) == "randomClose";
    plan.seed = std::uint64_t(entry::solidsSeed(dict));
    const auto container = entry::container(dict);
    if (const auto type = entry::containerType.known(container))
        plan.container = *type == "box" ? readBox(container, up, entry::gravity.where(gravityFile)) : readCylinder(container, up);
    plan.container.where = container.location();
    plan.size = readSizes(entry::solidSize(dict));
    plan.shrink = entry::shrink(dict);
    if (plan.randomClose)
    {
        plan.shapes = {ShapeToPack{}};
        plan.porosity = entry::targetPorosity.ifGiven(dict);
        plan.porosityAt = entry::targetPorosity.where(dict);
    }
    else
    {
        plan.filled = entry::filled.ifGiven(dict);
        plan.filledAt = entry::filled.where(dict);
        plan.count = plan.filled ? 0 : entry::count.needed(dict);
        plan.countAt = entry::count.where(dict);
        if (plan.filled && entry::count.given(dict))
            entry::count.error(dict, "the height decides on the number of solids: leave out count or height");
        plan.porosity = entry::settledPorosity.ifGiven(dict);
        plan.porosityAt = entry::settledPorosity.where(dict);
        for (const auto& d : entry::solidShapes(dict)) addShape(d, plan.shapes);
        if (plan.shapes.empty())
        {
            if (entry::solidShapes.given(dict))
                entry::solidShapes.error(dict, "shapes lists none. Without the entry all solids are spheres");
            plan.shapes = {ShapeToPack{}};
        }
        plan.sharesOfMass = entry::sharesOf.is(dict, "mass");
        if (entry::sharesOf.given(dict))
        {
            entry::sharesOf(dict, "number");
            double together = 0;
            for (const auto& s : plan.shapes) together += s.share;
            if (std::abs(together - 1) > 1e-6)
                entry::solidShapes.error(
                    dict, fmt::format(
                              "the shares of the shapes are {:g} together: with sharesOf their sum must be 1; without it they are weights",
                              together));
        }
        plan.friction = entry::friction(dict);
        plan.restitution = entry::restitution(dict);
        plan.restEnergy = entry::restEnergy(dict);
        plan.longest = entry::timeLimit(dict);
        plan.timeLimitAt = entry::timeLimit.where(dict);
        plan.level = entry::level(dict);
        if (plan.container.periodic[2])
            entry::boxPeriodic.error(container, "along gravity a bed that settles does not repeat; randomClose can");
    }
    dict.reportUnused();
    gravityFile.ignore("dimensions");
    c.diagnostics().throwIfAny();

    const auto& box = plan.container;
    const std::array<double, 3> lengths{box.length, box.width, box.height};
    for (std::size_t k = 0; k < 3; ++k)
        if (box.periodic[k] && lengths[k] < 2 * plan.size.high)
            throw CaseError(box.where, fmt::format("a period of {:g} m is shorter than two of the largest solids ({:g} m each)", lengths[k],
                                                   plan.size.high));
    // Sizes are those of spheres here; meshes are longer, and checked when they are read.
    if (const double extent = std::min(box.narrowest(), box.height); plan.size.high > extent)
        throw CaseError(plan.size.where, fmt::format("solids of {:g} m do not fit into a container of {:g} m{}", plan.size.high, extent,
                                                     plan.size.high > 50 * extent ? ": are the sizes in mm? Lengths are in m" : ""));
    if (plan.filled && *plan.filled > box.height)
        throw CaseError(plan.filledAt, fmt::format("the bed cannot be {:g} m high in a container of {:g} m", *plan.filled, box.height));
    if (plan.count > 0 && !plan.level)
    {
        constexpr double densest = 0.74; // of equal spheres (Kepler)
        const double solid = plan.count * plan.size.meanVolume(plan.count);
        if (solid > densest * box.volume())
            throw CaseError(plan.countAt,
                            fmt::format("{} solids have {:.3g} m^3, and the container has {:.3g} m^3: at a porosity of 0.4 it holds "
                                        "about {}. With \"level yes;\" what stands out of it is taken away",
                                        plan.count, solid, box.volume(), int(0.6 * box.volume() / plan.size.meanVolume(plan.count))));
    }
    return plan;
}

}
