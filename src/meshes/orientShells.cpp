#include "meshes/orientShells.hpp"
#include "geometry/components.hpp"
#include "meshes/workingMesh.hpp"
#include <CGAL/Side_of_triangle_mesh.h>
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Volume over area^(3/2) below which a closed surface is flat: the share of rounding of files with seven digits.
constexpr double flat = 1e-6;

bool within(const Box& inner, const Box& outer)
{
    return std::all_of(std::begin(coordinates), std::end(coordinates),
                       [&](auto c) { return inner.low.*c >= outer.low.*c && inner.high.*c <= outer.high.*c; });
}

}

double enclosedVolume(const NumberedMesh& m)
{
    if (m.points.empty()) return 0;
    double six = 0;
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
        six += dot(m.points[std::size_t(m.triangles[f][0])] - m.points[0], areaVector(m, int(f)));
    return six / 6;
}

Shells findShells(const NumberedMesh& m)
{
    DisjointSets points(m.points.size());
    for (const auto& [a, b, c] : m.triangles)
    {
        points.join(a, b);
        points.join(b, c);
    }
    const auto [ofPoint, count] = points.numbered();
    Shells s;
    s.count = count;
    const auto n = std::size_t(count);
    const double inf = Box::infinity;
    s.volume.assign(n, 0);
    s.area.assign(n, 0);
    s.box.assign(n, {{inf, inf, inf}, {-inf, -inf, -inf}});
    std::vector<int> anchor(n, -1); // sums about a point of the shell itself lose no digits
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
    {
        const int first = m.triangles[f][0], shell = ofPoint[std::size_t(first)];
        const auto k = std::size_t(shell);
        s.of.push_back(shell);
        if (anchor[k] < 0) anchor[k] = first;
        const auto a = areaVector(m, int(f));
        s.volume[k] += dot(m.points[std::size_t(first)] - m.points[std::size_t(anchor[k])], a) / 6;
        s.area[k] += 0.5 * mag(a);
        for (const int p : m.triangles[f])
            for (const auto c : coordinates)
            {
                s.box[k].low.*c = std::min(s.box[k].low.*c, m.points[std::size_t(p)].*c);
                s.box[k].high.*c = std::max(s.box[k].high.*c, m.points[std::size_t(p)].*c);
            }
    }
    return s;
}

std::vector<NumberedMesh> apart(const NumberedMesh& m, const Shells& shells)
{
    std::vector<NumberedMesh> parts(std::size_t(shells.count));
    for (auto& part : parts) part.regions = m.regions;
    std::vector<int> place(m.points.size(), -1); // shells have no point in common
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
    {
        auto& part = parts[std::size_t(shells.of[f])];
        auto corners = m.triangles[f];
        for (int& c : corners)
        {
            auto& q = place[std::size_t(c)];
            if (q < 0)
            {
                q = int(part.points.size());
                part.points.push_back(m.points[std::size_t(c)]);
            }
            c = q;
        }
        part.triangles.push_back(corners);
        part.region.push_back(m.region[f]);
        part.number.push_back(m.number[f]);
    }
    return parts;
}

void orientShells(NumberedMesh& m, FluidSide fluid, std::vector<std::string>& repairs)
{
    const auto shells = findShells(m);
    const auto n = std::size_t(shells.count);
    std::vector<int> first(n, -1); // facet of each shell
    for (std::size_t f = m.triangles.size(); f-- > 0;) first[std::size_t(shells.of[f])] = int(f);

    std::vector<int> without;
    for (std::size_t k = 0; k < n; ++k)
        if (std::abs(shells.volume[k]) < flat * std::pow(shells.area[k], 1.5)) without.push_back(first[k]);
    if (!without.empty())
        throw UnusableMesh(fmt::format("{} of {} without volume; a facet of each", without.size(), counted(n, "closed surface")), m,
                           without);

    std::vector<int> depth(n, 0);
    const auto parts = apart(m, shells);
    for (std::size_t outer = 0; outer < n; ++outer)
    {
        std::vector<std::size_t> candidates;
        for (std::size_t inner = 0; inner < n; ++inner)
            if (inner != outer && within(shells.box[inner], shells.box[outer])) candidates.push_back(inner);
        if (candidates.empty()) continue;
        const auto shell = toWorkingMesh(parts[outer]);
        const CGAL::Side_of_triangle_mesh<WorkingMesh, Kernel> sideOf(shell);
        for (const auto inner : candidates)
        {
            auto side = CGAL::ON_BOUNDARY;
            for (std::size_t f = 0; f < parts[inner].triangles.size() && side == CGAL::ON_BOUNDARY; ++f)
                side = sideOf(toPoint(centroid(parts[inner], int(f))));
            depth[inner] += side == CGAL::ON_BOUNDED_SIDE;
        }
    }

    std::vector<char> turn(n);
    std::size_t turned = 0, facets = 0, nested = 0;
    for (std::size_t k = 0; k < n; ++k)
    {
        const bool outwards = (fluid == FluidSide::outside) == (depth[k] % 2 == 0);
        turn[k] = outwards != (shells.volume[k] > 0);
        turned += std::size_t(turn[k]);
        nested += depth[k] > 0;
    }
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
        if (turn[std::size_t(shells.of[f])])
        {
            std::swap(m.triangles[f][1], m.triangles[f][2]);
            ++facets;
        }
    if (turned > 0)
        repairs.push_back(fmt::format("{} of {} turned ({}), so that normals point into the fluid", turned, counted(n, "closed surface"),
                                      counted(facets, "facet")));
    if (nested > 0)
        repairs.push_back(fmt::format("{} of {} in another one: solid and fluid alternate from the outermost inwards", nested,
                                      counted(n, "closed surface") + (nested == 1 ? " lies" : " lie")));
}

}
