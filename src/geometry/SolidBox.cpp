#include "SolidBox.hpp"
#include "components.hpp"
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
        return {d, q / d, 0, 0, moved == 1 && d <= depth, moved == 1 ? depth - d : -Box::infinity};
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
            append(surface,
                   parametricSurface(segments(high.*first - low.*first, size), segments(high.*second - low.*second, size),
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
