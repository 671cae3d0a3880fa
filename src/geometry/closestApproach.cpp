#include "geometry/closestApproach.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <numbers>

namespace sph
{

namespace
{

/// Angle of the fluid between two surfaces that cross, from the cosine of the angle between their normals.
double wedgeAngle(double cosNormals) { return 180 - std::acos(std::clamp(cosNormals, -1.0, 1.0)) * 180 / std::numbers::pi; }

bool isWithin(const Geometry& g, const Vector<3>& x)
{
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        const double slack = 1e-9 * g.length(k);
        if (x.*c < g.low.*c - slack || x.*c > g.high.*c + slack) return false;
    }
    return true;
}

struct Ball
{
    Vector<3> centre;
    double R;
};

Ball asBall(const Shape& shape)
{
    const auto d = shape.description();
    auto centre = d.vectors.front().second;
    if (d.type == "cylinder") centre.z = 0;
    return {centre, d.scalars.front().second};
}

Approach ballToSurface(const Ball& ball, const Shape& b)
{
    const auto f = b.foot(ball.centre);
    Approach result;
    result.distance = f.distance - ball.R;
    result.at = ball.centre - (ball.R + 0.5 * result.distance) * f.normal;
    result.facing = f.distance > 0;
    return result;
}

Vector<3> onSurface(const Shape& shape, const Vector<3>& x)
{
    const auto f = shape.foot(x);
    return x - f.distance * f.normal;
}

/// Moves along the surface of `a` to a smaller distance from `b`, by steps that halve when none helps (compass search).
Vector<3> descend(const Shape& a, const Shape& b, const Geometry& g, Vector<3> x, double step)
{
    double d = b.foot(x).distance;
    for (int trials = 0; step > 1e-9 * g.length(0) && trials < 4000; ++trials)
    {
        const auto [e1, e2] = crossSection(a.foot(x).normal);
        bool moved = false;
        for (const auto& e : {e1, -e1, e2, -e2})
        {
            auto y = x + step * e;
            if (g.dimension == 2) y.z = 0;
            y = onSurface(a, y);
            const double there = b.foot(y).distance;
            if (!(there < d) || !isWithin(g, y)) continue;
            x = y;
            d = there;
            moved = true;
            break;
        }
        if (!moved) step *= 0.5;
    }
    return x;
}

/// Sharpest wedge along the edges of the triangles that cross `b`.
double sharpestWedge(const Shape& a, const Shape& b, const TriangleSurface& samples, const std::vector<double>& distances, double tolerance)
{
    double sharpest = 180;
    for (const auto& [i, j, k] : samples.triangles)
        for (const auto& [from, to] : {std::pair{i, j}, std::pair{j, k}, std::pair{k, i}})
        {
            if (!(distances[from] < -tolerance && distances[to] > tolerance)) continue;
            auto low = samples.points[from], high = samples.points[to];
            for (int halving = 0; halving < 40; ++halving)
            {
                const auto middle = onSurface(a, 0.5 * (low + high));
                (b.foot(middle).distance < 0 ? low : high) = middle;
            }
            sharpest = std::min(sharpest, wedgeAngle(dot(a.foot(low).normal, b.foot(low).normal)));
        }
    return sharpest;
}

}

bool isBall(const Shape& shape, int dimension)
{
    const auto d = shape.description();
    return d.fluid == FluidSide::outside && (d.type == "sphere" || (d.type == "cylinder" && dimension == 2));
}

Approach closestApproach(const Shape& a, const Shape& b, const Geometry& g, const TriangleSurface& samples, double size)
{
    const double tolerance = g.tolerance();
    const bool ballA = isBall(a, g.dimension), ballB = isBall(b, g.dimension);
    if (ballA && ballB)
    {
        const auto A = asBall(a), B = asBall(b);
        auto result = ballToSurface(A, b);
        const double D = mag(A.centre - B.centre);
        result.crossing = result.distance < -tolerance && D > std::abs(A.R - B.R);
        if (result.crossing) result.wedge = wedgeAngle((sqr(A.R) + sqr(B.R) - sqr(D)) / (2 * A.R * B.R));
        result.overlap = -result.distance / (2 * std::min(A.R, B.R));
        result.same = std::max(D, std::abs(A.R - B.R)) < 1e-3 * A.R;
        if (result.same) result.at = 0.5 * (A.centre + B.centre);
        return result;
    }
    double overlap = 0;
    if (ballA || ballB)
    {
        const auto ball = asBall(ballA ? a : b);
        const auto result = ballToSurface(ball, ballA ? b : a);
        if (result.distance > -tolerance) return result;
        overlap = -result.distance / (2 * ball.R);
    }

    Approach result;
    result.overlap = overlap;
    std::vector<double> distances;
    int best = -1;
    bool outside = false, behind = false;
    for (const auto& p : samples.points)
    {
        const auto f = b.foot(p);
        distances.push_back(f.distance);
        outside = outside || f.distance > tolerance;
        behind = behind || f.distance < -tolerance;
        if (dot(f.normal, a.foot(p).normal) > -0.5 || !isWithin(g, p)) continue; // the sides of a wedge of more than 60 degrees
        if (f.distance < result.distance)
        {
            result.distance = f.distance;
            best = int(distances.size()) - 1;
        }
    }
    if (outside && behind)
    {
        result.crossing = true;
        result.wedge = sharpestWedge(a, b, samples, distances, tolerance);
    }
    if (best < 0) return result;
    const auto nearest = descend(a, b, g, samples.points[best], size);
    const auto f = b.foot(nearest);
    result.distance = f.distance;
    result.at = nearest - 0.5 * f.distance * f.normal;
    result.facing = dot(f.normal, a.foot(nearest).normal) < -0.5;
    if (!result.crossing && outside && f.distance < -tolerance && result.facing)
    {
        // Overlap shallower than the samples can see: the two surfaces all but touch, with next to no angle between them.
        result.crossing = true;
        result.wedge = 0;
    }
    return result;
}

}
