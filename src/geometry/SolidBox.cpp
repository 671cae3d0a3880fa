#include "geometry/SolidBox.hpp"
#include "geometry/components.hpp"
#include <algorithm>

namespace sph
{

Foot SolidBox::foot(const Vector<3>& x) const
{
    const Vector<3> nearest{std::clamp(x.x, low_.x, high_.x), std::clamp(x.y, low_.y, high_.y), std::clamp(x.z, low_.z, high_.z)};
    const auto q = x - nearest;
    const int moved = (q.x != 0) + (q.y != 0) + (q.z != 0);
    if (moved > 0)
    {
        const double d = mag(q);
        double depth = Box::infinity; // at which another face is as near as this one
        for (const auto c : coordinates)
            depth = std::min(depth, q.*c != 0 ? 0.5 * (high_.*c - low_.*c) : std::min(x.*c - low_.*c, high_.*c - x.*c));
        const auto on = moved == 1 ? Foot::On::face : moved == 2 ? Foot::On::edge : Foot::On::vertex;
        return {d, q / d, 0, 0, moved == 1 && d <= depth, moved == 1 ? depth - d : -Box::infinity, on};
    }
    // Inside, or on the surface: the nearest face, where that is one alone.
    Foot f{-Box::infinity, {}, 0, 0, true};
    for (const auto c : coordinates)
        for (const double side : {-1.0, 1.0})
        {
            const double d = side < 0 ? low_.*c - x.*c : x.*c - high_.*c;
            if (d == f.distance) f.smooth = false;
            if (d <= f.distance) continue;
            f = {d, {}, 0, 0, true};
            f.normal.*c = side;
        }
    return f;
}

Foot SolidBox::footOnFace(const Vector<3>& x, const Vector<3>& normal, const Vector<3>& source, const Covered& covered) const
{
    int across = 0;
    while (normal.*coordinates[across] == 0) ++across;
    const auto n = coordinates[across];
    const bool upper = normal.*n > 0;
    const double d = upper ? x.*n - high_.*n : low_.*n - x.*n;
    Vector<3> onFace = source;
    onFace.*n = upper ? high_.*n : low_.*n;
    const auto isCovered = [&](double Vector<3>::*c, double level)
    {
        auto at = onFace;
        at.*c = level;
        return covered({std::clamp(at.x, low_.x, high_.x), std::clamp(at.y, low_.y, high_.y), std::clamp(at.z, low_.z, high_.z)});
    };
    double depth =
        isCovered(n, upper ? low_.*n : high_.*n) ? Box::infinity : 0.5 * (high_.*n - low_.*n); // at which another free face is as near
    for (const auto c : coordinates)
    {
        if (c == n) continue;
        for (const double edge : {low_.*c, high_.*c})
        {
            const double within = edge == low_.*c ? x.*c - low_.*c : high_.*c - x.*c;
            if (within >= depth || isCovered(c, edge)) continue;
            if (within < 0) return foot(x); // beyond an edge that is one
            depth = within;
        }
    }
    return {d, normal, 0, 0, d <= depth, depth - d};
}

std::vector<Foot> SolidBox::feetFromInside(const Vector<3>& x) const
{
    std::vector<Foot> feet;
    for (const auto c : coordinates)
        for (const double side : {-1.0, 1.0})
        {
            const double d = side < 0 ? low_.*c - x.*c : x.*c - high_.*c;
            if (!std::isfinite(d)) continue;
            Foot f{d, {}, 0, 0, true};
            f.normal.*c = side;
            feet.push_back(f);
        }
    return feet;
}

std::unique_ptr<Shape> SolidBox::shifted(const Vector<3>& by) const { return std::make_unique<SolidBox>(low_ + by, high_ + by); }

ShapeDescription SolidBox::description() const { return {"box", {{"min", low_}, {"max", high_}}, {}, true, FluidSide::outside}; }

bool SolidBox::invariantAlong(int direction) const
{
    const auto c = coordinates[direction];
    return std::isinf(low_.*c) && std::isinf(high_.*c);
}

TriangleSurface SolidBox::triangles(const Box& within, double size) const
{
    Vector<3> low, high;
    for (const auto c : coordinates)
    {
        low.*c = std::max(low_.*c, within.low.*c);
        high.*c = std::min(high_.*c, within.high.*c);
    }
    TriangleSurface surface;
    if (high.x <= low.x || high.y <= low.y || high.z <= low.z) return surface;
    for (int k = 0; k < 3; ++k)
    {
        const auto normal = coordinates[k], first = coordinates[(k + 1) % 3], second = coordinates[(k + 2) % 3];
        for (const double level : {low_.*normal, high_.*normal})
        {
            if (!(level >= within.low.*normal && level <= within.high.*normal)) continue;
            append(surface, parametricSurface(segments(high.*first - low.*first, size), segments(high.*second - low.*second, size),
                                              [&](double u, double v)
                                              {
                                                  Vector<3> p;
                                                  p.*normal = level;
                                                  p.*first = low.*first + u * (high.*first - low.*first);
                                                  p.*second = low.*second + v * (high.*second - low.*second);
                                                  return p;
                                              }));
        }
    }
    return surface;
}

}
