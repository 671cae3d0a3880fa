#include "meshes/readers/NumberedMesh.hpp"
#include "geometry/Shape.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace sph
{

namespace
{

constexpr std::size_t namedAtMost = 3;

std::string inWords(const NumberedMesh& m, int facet)
{
    const auto f = std::size_t(facet);
    std::string corners;
    for (const int p : m.triangles[f]) corners += " " + inWords(m.points[std::size_t(p)]);
    return nameOfFacet(m, facet) + fmt::format(" (region {}) at{}", m.regions[std::size_t(m.region[f])], corners);
}

std::string listed(const std::string& why, std::size_t count, const auto& inWordsOf, const std::string& remedy)
{
    auto text = why + ":\n";
    for (std::size_t i = 0; i < std::min(count, namedAtMost); ++i) text += "    " + inWordsOf(i) + "\n";
    if (count > namedAtMost) text += fmt::format("    and {} more\n", count - namedAtMost);
    if (remedy.empty()) text.pop_back();
    return text + remedy;
}

}

std::string inWords(const Vector<3>& x) { return fmt::format("({:.6g} {:.6g} {:.6g})", x.x, x.y, x.z); }

std::string nameOfFacet(const NumberedMesh& m, int facet)
{
    const int number = m.number[std::size_t(facet)];
    return number < 0 ? "a facet made by a repair" : fmt::format("facet {}", number);
}

std::string counted(std::size_t number, const std::string& thing) { return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s"); }

UnusableMesh::UnusableMesh(const std::string& why, const NumberedMesh& m, const std::vector<int>& blamed, const std::string& remedy)
    : runtime_error(listed(
          why, blamed.size(), [&](std::size_t i) { return inWords(m, blamed[i]); }, remedy))
{
    facets.points = m.points;
    for (const int f : blamed) facets.triangles.push_back(m.triangles[std::size_t(f)]);
}

UnusableMesh::UnusableMesh(const std::string& why, const NumberedMesh& m, const std::vector<std::array<int, 2>>& blamed,
                           const std::vector<int>& ofFacets, const std::string& remedy)
    : runtime_error(listed(
          why, blamed.size(),
          [&](std::size_t i)
          {
              return fmt::format("{} {} of {}", inWords(m.points[std::size_t(blamed[i][0])]), inWords(m.points[std::size_t(blamed[i][1])]),
                                 inWords(m, ofFacets[i]));
          },
          remedy))
{
    for (const auto& [a, b] : blamed) edges.push_back({m.points[std::size_t(a)], m.points[std::size_t(b)]});
    facets.points = m.points;
    for (const int f : ofFacets) facets.triangles.push_back(m.triangles[std::size_t(f)]);
}

std::vector<HalfEdge> sortedHalfEdges(const TriangleSurface& s)
{
    std::vector<HalfEdge> all;
    all.reserve(3 * s.triangles.size());
    for (std::size_t f = 0; f < s.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
        {
            const int a = s.triangles[f][k], b = s.triangles[f][(k + 1) % 3];
            all.push_back({std::min(a, b), std::max(a, b), int(f), a < b});
        }
    std::sort(all.begin(), all.end(),
              [](const HalfEdge& a, const HalfEdge& b) {
                  return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.facet < b.facet;
              });
    return all;
}

DisjointSets::DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

int DisjointSets::find(int i)
{
    while (parent_[std::size_t(i)] != i) i = parent_[std::size_t(i)] = parent_[std::size_t(parent_[std::size_t(i)])];
    return i;
}

std::pair<std::vector<int>, int> DisjointSets::numbered()
{
    std::vector<int> number(parent_.size(), -1), result(parent_.size());
    int sets = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i)
    {
        auto& n = number[std::size_t(find(int(i)))];
        if (n < 0) n = sets++;
        result[i] = n;
    }
    return {result, sets};
}

Box boundingBox(const TriangleSurface& s)
{
    const double inf = Box::infinity;
    Box box{{inf, inf, inf}, {-inf, -inf, -inf}};
    for (const auto& p : s.points)
        for (const auto c : coordinates)
        {
            box.low.*c = std::min(box.low.*c, p.*c);
            box.high.*c = std::max(box.high.*c, p.*c);
        }
    return box;
}

}
