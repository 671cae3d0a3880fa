#include "solids/Bed.hpp"
#include "geometry/geodesicSphere.hpp"
#include "solids/rocks/closedSurface.hpp"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <numeric>

namespace sph
{

namespace
{

/// The closed surface of a file, with the volume of a sphere of diameter 1 and its centroid at the origin.
SolidShape readMesh(const Case& c, const std::string& file, const Location& where)
{
    SolidShape shape;
    shape.where = where;
    const auto fail = [&](const std::string& what) { throw CaseError(where, file + " " + what); };
    if (!c.has(file)) fail("is missing. makeRocks makes shapes of rocks");
    shape.name = std::filesystem::path(file).stem().string();
    shape.file = file;
    shape.mesh = readSurface(c.folder(), file);
    if (const auto loose = looseEdges(shape.mesh))
        fail(fmt::format("is no closed surface: {} of its edges are not shared by two facets that agree on the side", loose));
    const auto moments = volumeMoments(shape.mesh);
    if (!(moments.volume > 0)) fail(fmt::format("has the volume {:g}: its normals must point outwards", moments.volume));
    shape.centroid = moments.centroid;
    shape.fileSize = std::cbrt(6 / std::numbers::pi * moments.volume);
    shape.reach = 0;
    for (auto& p : shape.mesh.points)
    {
        p = (p - shape.centroid) / shape.fileSize;
        shape.reach = std::max(shape.reach, mag(p));
    }
    return shape;
}

/// A sphere of that many facets along an edge of the icosahedron, of the volume of the sphere of diameter 1.
TriangleSurface facetedSphere(int n)
{
    auto s = geodesicSphere(n);
    const double size = std::cbrt(6 / std::numbers::pi * volumeMoments(s).volume);
    for (auto& p : s.points) p = p / size;
    return s;
}

}

SolidShape readSolidShape(const Case& c, const ShapeToPack& s, std::uint64_t seed)
{
    SolidShape shape;
    shape.where = s.where;
    shape.name = "sphere";
    if (!s.file.empty()) shape = readMesh(c, s.file, s.where);
    shape.form = s.form;
    if (!s.fines) return shape;
    constexpr int ofGrain = 4, ofFine = 2;
    if (s.file.empty()) shape.mesh = facetedSphere(ofGrain);
    const auto fine = s.fines->file.empty() ? facetedSphere(ofFine) : readMesh(c, s.fines->file, s.fines->where).mesh;
    return agglomerate(shape, fine, *s.fines, seed);
}

namespace
{

/// Shapes for bodies of these sizes, by the shares of their mass: the largest body first, each gets the shape that has most of its share to come. Bodies of one size come in random
/// order, since their order is that in which they fall.
std::vector<int> shapesByMass(const SolidsPlan& plan, const std::vector<double>& sizes, Noise& noise)
{
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < sizes.size(); ++k) order.emplace_back(noise(), k);
    std::ranges::sort(order);
    std::ranges::stable_sort(order, std::greater{}, [&](const auto& each) { return sizes[each.second]; });
    double all = 0, massOfAll = 0;
    for (const auto& s : plan.shapes) all += s.share;
    for (const double d : sizes) massOfAll += d * d * d;
    std::vector<double> missing;
    for (const auto& s : plan.shapes) missing.push_back(s.share / all * massOfAll);
    std::vector<int> shapes(sizes.size());
    for (const auto& [key, k] : order)
    {
        const auto most = std::ranges::max_element(missing);
        *most -= std::pow(sizes[k], 3);
        shapes[k] = int(most - missing.begin());
    }
    return shapes;
}

}

std::vector<Body> drawBodies(const SolidsPlan& plan, int count)
{
    Noise noise(plan.seed);
    const auto shuffled = [&](auto of)
    {
        std::vector<int> values;
        for (int k = 0; k < count; ++k) values.push_back(k);
        for (int k = count - 1; k > 0; --k) std::swap(values[std::size_t(k)], values[std::size_t(noise.below(k + 1))]);
        std::vector<decltype(of(0))> drawn;
        for (const int v : values) drawn.push_back(of(v));
        return drawn;
    };
    // Sizes that each stand for an equal part, and quantiles of the shapes, in random order: the shares are met as well as whole numbers can.
    const auto ascending = plan.size.ofGrains(count);
    const auto sizes = shuffled([&](int k) { return ascending[std::size_t(k)]; });
    double all = 0;
    for (const auto& s : plan.shapes) all += s.share;
    const auto quantile = [&](int which)
    {
        double upTo = 0;
        int k = 0;
        while (k + 1 < int(plan.shapes.size()) && (upTo += plan.shapes[std::size_t(k)].share / all) < (which + 0.5) / count) ++k;
        return k;
    };
    const auto shapes = plan.sharesOfMass ? shapesByMass(plan, sizes, noise) : shuffled(quantile);
    std::vector<Body> bodies;
    for (std::size_t k = 0; k < std::size_t(count); ++k) bodies.push_back({shapes[k], sizes[k], {}, randomRotation(noise)});
    return bodies;
}

Vector<3> shortest(const SolidContainer& c, Vector<3> d)
{
    if (c.periodic[0]) d.x -= c.length * std::round(d.x / c.length);
    if (c.periodic[1]) d.y -= c.width * std::round(d.y / c.width);
    if (c.periodic[2]) d.z -= c.height * std::round(d.z / c.height);
    return d;
}

std::vector<std::pair<int, int>> nearPairs(const SolidContainer& c, std::span<const Vector<3>> centres, std::span<const double> reach,
                                           double margin)
{
    // Sorted by height, each with those above it
    const int n = int(centres.size());
    std::vector<int> order(centres.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int i) { return std::pair(centres[std::size_t(i)].z, i); });
    const double largest = reach.empty() ? 0 : std::ranges::max(reach);
    std::vector<std::pair<int, int>> pairs;
    for (int k = 0; k < n; ++k)
    {
        const auto i = std::size_t(order[std::size_t(k)]);
        for (int l = k + 1; l < (c.periodic[2] ? k + n : n); ++l)
        {
            const auto j = std::size_t(order[std::size_t(l % n)]);
            const double above = centres[j].z - centres[i].z + (l < n ? 0 : c.height);
            if (above > reach[i] + largest + margin) break;
            const auto d = shortest(c, centres[j] - centres[i]);
            const double limit = reach[i] + reach[j] + margin;
            if (dot(d, d) < limit * limit) pairs.emplace_back(int(std::min(i, j)), int(std::max(i, j)));
        }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

TriangleSurface placed(const SolidContainer& c, const SolidShape& shape, const Body& body)
{
    auto s = shape.mesh;
    for (auto& p : s.points) p = c.toWorld(body.centre + body.size * body.rotation(p));
    return s;
}

namespace
{

void takeAwayWhatStandsOut(const SolidsPlan& plan, Bed& bed)
{
    std::vector<int> newNumber(bed.bodies.size(), -1);
    std::vector<Body> kept;
    double highest = 0;
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        const auto& shape = bed.shapeOf(b);
        double top = b.centre.z + 0.5 * b.size;
        if (!shape.isSphere())
        {
            top = 0;
            for (const auto& p : shape.mesh.points) top = std::max(top, b.centre.z + b.size * b.rotation(p).z);
        }
        highest = std::max(highest, top);
        // By centres: the sizes of what stays are those of what was poured.
        if (top > plan.container.height || (plan.filled && b.centre.z > *plan.filled)) continue;
        newNumber[i] = int(kept.size());
        kept.push_back(b);
    }
    bed.takenAway = int(bed.bodies.size() - kept.size());
    if (bed.takenAway == 0) return;
    if (!plan.level && !plan.filled)
        throw CaseError(
            plan.countAt,
            fmt::format("the bed of {} solids is {:.4g} m high, and the container {:.4g} m: {} solids stand out of it. With \"level "
                        "yes;\" they are taken away",
                        bed.bodies.size(), highest, plan.container.height, bed.takenAway));
    if (kept.empty()) throw CaseError(plan.container.where, "every solid stands out of the container: it is too low");
    bed.bodies = std::move(kept);
    std::vector<Contact> contacts;
    for (const auto& [i, j, gap] : bed.contacts)
        if (newNumber[std::size_t(i)] >= 0 && newNumber[std::size_t(j)] >= 0)
            contacts.push_back({newNumber[std::size_t(i)], newNumber[std::size_t(j)], gap});
    bed.contacts = std::move(contacts);
}

/// Share by which solids are parted at least, which shrinking hardly does where agglomerates lie hooked in one another.
double leastParting(const Bed& bed) { return std::ranges::any_of(bed.shapes, &SolidShape::isAgglomerate) ? 1e-3 : 1e-5; }

/// Share by which all are made smaller in the end: what is nearer than the tolerance of welding, meshToGhost takes for a contact.
double gapBetween(const SolidContainer& c, const Bed& bed)
{
    if (std::ranges::all_of(bed.shapes, &SolidShape::isSphere)) return 0;
    const double width = c.isCylinder ? 2 * c.radius : c.width,
                 tolerance = 1e-6 * mag(Vector<3>{c.isCylinder ? width : c.length, width, c.height});
    const double gap = 4 * tolerance / std::ranges::min(bed.bodies, {}, &Body::size).size;
    return std::ranges::any_of(bed.shapes, &SolidShape::isAgglomerate) ? std::max(gap, leastParting(bed)) : gap;
}

void makeSmaller(Body& b, double share)
{
    b.size *= 1 - share;
    b.shrunk = 1 - (1 - b.shrunk) * (1 - share);
}

/// Those that overlap smaller, by what would part two spheres: both smaller by the share s, of sizes whose mean is d, they come apart by s d.
void part(Bed& bed, const std::vector<Overlap>& overlaps)
{
    std::vector<double> smaller(bed.bodies.size(), 0);
    for (const auto& [i, j, depth] : overlaps)
    {
        const auto k = std::size_t(i), l = std::size_t(j < 0 ? i : j); // the container does not give way
        const double d = j < 0 ? 0.5 * bed.bodies[k].size : 0.5 * (bed.bodies[k].size + bed.bodies[l].size);
        for (const auto m : {k, l}) smaller[m] = std::max(smaller[m], 1.1 * depth / d + leastParting(bed));
    }
    for (std::size_t k = 0; k < smaller.size(); ++k) makeSmaller(bed.bodies[k], smaller[k]);
}

/// Each solid smaller about its centroid: by the share that is given, else by what parts it from those that it reaches into, and a little more.
void shrink(const SolidsPlan& plan, Bed& bed, std::vector<Overlap> overlaps)
{
    const auto makeAllSmaller = [&](double share)
    {
        for (auto& b : bed.bodies) makeSmaller(b, share);
    };
    if (plan.shrink) return makeAllSmaller(*plan.shrink);
    constexpr double most = 0.1;
    for (;;)
    {
        for (; !overlaps.empty(); overlaps = findOverlaps(plan.container, bed))
        {
            part(bed, overlaps);
            if (std::ranges::max(bed.bodies, {}, &Body::shrunk).shrunk > most)
                throw CaseError(plan.where,
                                fmt::format("solids overlap by {:.2g} of their size: shrinking does not part them", bed.overlap));
        }
        const double gap = gapBetween(plan.container, bed);
        if (gap == 0) return;
        makeAllSmaller(gap);
        overlaps = findOverlaps(plan.container, bed); // what is hooked may cross anew
        if (overlaps.empty()) return;
    }
}

void pour(const SolidsPlan& plan, int count, Bed& bed, const Progress& progress)
{
    bed.meanSize = plan.size.mean(count);
    bed.bodies = drawBodies(plan, count);
    bed.notes.clear();
    settle(plan, bed, progress);
}

/// A bed that would be level half of a largest solid above the height at least: those whose centres lie above it can then be taken away. The first number is that of a porosity of 0.4, the next one by what that came to.
void pourToHeight(const SolidsPlan& plan, Bed& bed, const Progress& progress)
{
    constexpr int quantiles = 1000, most = 1'000'000;
    const double meanVolume = plan.size.meanVolume(quantiles), wanted = *plan.filled + plan.size.high;
    for (double porosity = 0.4;;)
    {
        const double count = std::ceil((1 - porosity) * plan.container.area() * wanted / meanVolume);
        if (count > most)
            throw CaseError(plan.filledAt,
                            fmt::format("a bed {:g} m high takes {:.3g} of these solids; {} are possible", *plan.filled, count, most));
        progress(fmt::format("{:.0f} solids", count));
        pour(plan, int(count), bed, progress);
        // Its height, were it level
        porosity = porosityOfMiddle(plan, bed);
        const double level = count * meanVolume / ((1 - porosity) * plan.container.area());
        if (level > *plan.filled + 0.5 * plan.size.high) return;
        porosity -= 0.01; // the next bed is one of others
    }
}

}

Bed packSolids(const Case& c, const SolidsPlan& plan, const Progress& progress)
{
    Bed bed;
    for (const auto& s : plan.shapes) bed.shapes.push_back(readSolidShape(c, s, plan.seed));
    if (plan.randomClose) packRandomly(plan, bed, progress);
    else
    {
        if (plan.filled) pourToHeight(plan, bed, progress);
        else pour(plan, plan.count, bed, progress);
        takeAwayWhatStandsOut(plan, bed);
    }
    auto overlaps = findOverlaps(plan.container, bed);
    bed.overlap = deepest(overlaps) / bed.meanSize;
    shrink(plan, bed, std::move(overlaps));
    return bed;
}

}
