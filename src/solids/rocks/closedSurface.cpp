#include "solids/rocks/closedSurface.hpp"
#include <algorithm>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <map>

namespace sph
{

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

VolumeMoments volumeMoments(const TriangleSurface& s)
{
    // Tetrahedra with a corner at the first point: what is far from the origin loses no digits.
    VolumeMoments sum;
    if (s.points.empty()) return sum;
    const auto origin = s.points.front();
    Vector<3> first;
    SymmTensor<3> second;
    const auto outer = [](const Vector<3>& a) { return SymmTensor<3>{a.x * a.x, a.x * a.y, a.x * a.z, a.y * a.y, a.y * a.z, a.z * a.z}; };
    for (const auto& [i, j, k] : s.triangles)
    {
        const auto a = s.points[std::size_t(i)] - origin, b = s.points[std::size_t(j)] - origin, c = s.points[std::size_t(k)] - origin;
        const double v = dot(a, cross(b, c)) / 6;
        sum.volume += v;
        first += v / 4 * (a + b + c);
        second += v / 20 * (outer(a) + outer(b) + outer(c) + outer(a + b + c));
    }
    if (sum.volume == 0) return sum;
    const auto mean = first / sum.volume;
    sum.centroid = origin + mean;
    sum.second = second - sum.volume * outer(mean);
    return sum;
}

std::size_t looseEdges(const TriangleSurface& s)
{
    std::map<std::pair<int, int>, int> directed;
    for (const auto& t : s.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
    std::size_t loose = 0;
    for (const auto& [edge, times] : directed)
    {
        const auto back = directed.find({edge.second, edge.first});
        loose += times != 1 || back == directed.end() || back->second != 1;
    }
    return loose;
}

TriangleSurface welded(const TriangleSurface& s)
{
    TriangleSurface result;
    std::map<std::array<double, 3>, int> number;
    std::vector<int> of;
    for (const auto& p : s.points)
    {
        const auto [at, isNew] = number.try_emplace({p.x, p.y, p.z}, int(result.points.size()));
        if (isNew) result.points.push_back(p);
        of.push_back(at->second);
    }
    for (const auto& [a, b, c] : s.triangles) result.triangles.push_back({of[std::size_t(a)], of[std::size_t(b)], of[std::size_t(c)]});
    return result;
}

std::string objText(const std::vector<NamedSurface>& surfaces)
{
    std::string text;
    const auto to = std::back_inserter(text);
    int first = 1;
    std::string group;
    for (const auto& [name, s] : surfaces)
    {
        for (const auto& p : s.points) fmt::format_to(to, "v {} {} {}\n", p.x, p.y, p.z);
        if (name != group) fmt::format_to(to, "g {}\n", group = name);
        for (const auto& [a, b, c] : s.triangles) fmt::format_to(to, "f {} {} {}\n", a + first, b + first, c + first);
        first += int(s.points.size());
    }
    return text;
}

std::string stlBytes(const TriangleSurface& s)
{
    std::string bytes(80, ' ');
    const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(std::uint32_t(s.triangles.size()));
    for (const auto& [i, j, k] : s.triangles)
    {
        const auto &a = s.points[std::size_t(i)], &b = s.points[std::size_t(j)], &c = s.points[std::size_t(k)];
        const auto n = cross(b - a, c - a);
        for (const auto& v : {mag(n) > 0 ? n / mag(n) : n, a, b, c})
            for (const double q : {v.x, v.y, v.z}) put(float(q));
        put(std::uint16_t(0));
    }
    return bytes;
}

}
