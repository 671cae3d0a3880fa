#include "packing/FluidSpace.hpp"
#include "geometry/components.hpp"
#include "geometry/forEachFoot.hpp"
#include "packing/overFluid.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph
{

namespace
{
constexpr double roundOff = 1e-9;

double measure(const Vector<3>& length, int dimension) { return length.x * length.y * (dimension == 3 ? length.z : 1); }

/// Does the flat patch normal to `axis` reach from one side of the domain to the other?
bool crosses(const Box& b, const Geometry& g, int axis)
{
    for (int k = 0; k < g.dimension; ++k)
        if (k != axis)
        {
            const double slack = roundOff * (g.high.*component(k) - g.low.*component(k));
            if (b.low.*component(k) > g.low.*component(k) + slack || b.high.*component(k) < g.high.*component(k) - slack) return false;
        }
    return true;
}

/// Fraction of the box of edges `edge` around the point at distance d from a plane of unit normal n that lies on the side n
/// points to (Scardovelli & Zaleski 2000, here by inclusion and exclusion of its corners).
double fractionAbove(double d, const Vector<3>& n, const Vector<3>& edge, int dimension)
{
    std::array<double, 3> m{};
    double sum = 0;
    for (int k = 0; k < dimension; ++k) sum += m[k] = std::fabs(n.*component(k)) * edge.*component(k);
    if (d >= sum / 2) return 1;
    if (d <= -sum / 2) return 0;

    // A normal along an axis makes the sum 0/0; leaning it by 1e-4 rounds the fraction off within 1e-4 of its ends, 0 and 1.
    double product = 1;
    for (int k = 0; k < dimension; ++k) product *= m[k] = std::max(m[k], 1e-4 * sum);
    double alpha = d;
    for (int k = 0; k < dimension; ++k) alpha += m[k] / 2;

    double volume = 0;
    for (int corner = 0; corner < 1 << dimension; ++corner)
    {
        double a = alpha;
        int sign = 1;
        for (int k = 0; k < dimension; ++k)
            if (corner >> k & 1)
            {
                a -= m[k];
                sign = -sign;
            }
        if (a > 0) volume += sign * (dimension == 3 ? a * a * a / 6 : a * a / 2);
    }
    return std::clamp(volume / product, 0.0, 1.0);
}

/// Volume of fluid in one cell.
double fluidIn(const Geometry& g, const Vector<3>& centre, const Vector<3>& edge, int halvings)
{
    const double halfDiagonal = mag(edge) / 2, d = g.distance(centre);
    const double whole = measure(edge, g.dimension);
    if (d > halfDiagonal) return whole;
    if (d < -halfDiagonal) return 0;
    if (halvings == 0)
    {
        double fraction = 1;
        forEachFootAlone(g, centre, halfDiagonal,
                         [&](const Foot& f, int)
                         {
                             if (f.distance < -halfDiagonal) return;
                             // The surface bends away from its tangent plane by (k1 + k2)/2 h^2/12 on average over the cell.
                             const double h2 = dot(edge, edge) / g.dimension;
                             fraction *= fractionAbove(f.distance - (f.k1 + f.k2) * h2 / 24, f.normal, edge, g.dimension);
                         });
        return fraction * whole;
    }
    double sum = 0;
    Vector<3> half = 0.5 * edge;
    for (int corner = 0; corner < 1 << g.dimension; ++corner)
    {
        const Vector<3> c{centre.x + (corner & 1 ? 0.5 : -0.5) * half.x, centre.y + (corner & 2 ? 0.5 : -0.5) * half.y,
                          g.dimension == 3 ? centre.z + (corner & 4 ? 0.5 : -0.5) * half.z : centre.z};
        sum += fluidIn(g, c, half, halvings - 1);
    }
    return sum;
}

double quadrature(const Geometry& g, const Box& box, double coarsest, int halvings)
{
    const Vector<3> length = box.high - box.low;
    RegularCells cells{box.low, {}};
    CellRange all{{0, 0, 0}, {1, 1, 1}};
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        all.high[k] = std::max(1L, std::lround(std::ceil(length.*c / coarsest)));
        cells.step.*c = length.*c / double(all.high[k]);
    }
    if (g.dimension == 2) cells.low.z = 0;
    const auto ofBlock = [&](const CellRange& range)
    {
        double count = 1;
        for (int k = 0; k < g.dimension; ++k) count *= double(range.high[k] - range.low[k]);
        return count * measure(cells.step, g.dimension);
    };
    return overFluid<double>(g, cells, all, 0, ofBlock,
                             [&](const auto&, const Vector<3>& middle) { return fluidIn(g, middle, cells.step, halvings); });
}

/// Nothing but balls and the faces of the box bounds the fluid, and no two of these overlap.
bool isBoxAroundBalls(const Geometry& g, const Box& box, const std::vector<Ball>& balls)
{
    for (const auto& patch : g.patches)
    {
        if (asBall(*patch.shape, g.dimension)) continue;
        const Box b = patch.shape->bounds();
        bool isFace = false;
        for (int k = 0; k < g.dimension; ++k)
            isFace |= b.low.*component(k) == b.high.*component(k) && crosses(b, g, k) &&
                      (b.low.*component(k) <= box.low.*component(k) || b.high.*component(k) >= box.high.*component(k));
        if (!isFace) return false;
    }
    const Vector<3> length = g.high - g.low;
    for (std::size_t a = 0; a < balls.size(); ++a)
    {
        for (int k = 0; k < g.dimension; ++k)
        {
            if (g.periodic[k]) continue;
            const double c = balls[a].centre.*component(k), r = balls[a].radius * (1 - roundOff);
            if (c - r < box.low.*component(k) || c + r > box.high.*component(k)) return false;
        }
        for (std::size_t b = a; b < balls.size(); ++b)
        {
            const Vector<3> between = balls[b].centre - balls[a].centre;
            for (int sx = -1; sx <= 1; ++sx)
                for (int sy = -1; sy <= 1; ++sy)
                    for (int sz = -1; sz <= 1; ++sz)
                    {
                        if ((sx && !g.periodic[0]) || (sy && !g.periodic[1]) || (sz && !g.periodic[2])) continue;
                        if (a == b && !sx && !sy && !sz) continue;
                        const double gap = mag(between + Vector<3>{sx * length.x, sy * length.y, sz * length.z});
                        if (gap < (balls[a].radius + balls[b].radius) * (1 - roundOff)) return false;
                    }
        }
    }
    return true;
}
}

Box fluidBox(const Geometry& g)
{
    Box box{g.low, g.high};
    for (const auto& patch : g.patches)
    {
        const Box b = patch.shape->bounds();
        for (int k = 0; k < g.dimension; ++k)
        {
            const double at = b.low.*component(k);
            if (at != b.high.*component(k) || !crosses(b, g, k)) continue;
            if (at <= g.low.*component(k) || at >= g.high.*component(k)) continue;
            const double sense = patch.shape->foot(0.5 * (g.low + g.high)).normal.*component(k);
            if (sense > 0) box.low.*component(k) = std::max(box.low.*component(k), at);
            if (sense < 0) box.high.*component(k) = std::min(box.high.*component(k), at);
        }
    }
    return box;
}

std::optional<Ball> asBall(const Shape& shape, int dimension)
{
    if (shape.enclosesFluid()) return std::nullopt;
    const auto words = shape.description();
    const auto vector = [&](const char* name)
    {
        for (const auto& [key, value] : words.vectors)
            if (key == name) return value;
        return Vector<3>{};
    };
    const double R = shape.smallestRadius();
    if (words.type == "sphere") return Ball{vector("centre"), R};
    // the circle of a 2-D scene
    if (words.type == "cylinder" && dimension == 2)
    {
        const Vector<3> p = vector("point");
        return Ball{{p.x, p.y, 0}, R};
    }
    return std::nullopt;
}

std::vector<Ball> ballsInCell(const Geometry& g)
{
    std::vector<Ball> balls;
    const Vector<3> length = g.high - g.low;
    for (const auto& patch : g.patches)
    {
        auto ball = asBall(*patch.shape, g.dimension);
        if (!ball) continue;
        for (int k = 0; k < g.dimension; ++k)
            if (g.periodic[k])
            {
                const double L = length.*component(k), low = g.low.*component(k);
                double& c = ball->centre.*component(k);
                c -= L * std::floor((c - low) / L + roundOff);
            }
        const bool known =
            std::any_of(balls.begin(), balls.end(), [&](const Ball& b) { return mag(b.centre - ball->centre) < 1e-6 * ball->radius; });
        if (!known) balls.push_back(*ball);
    }
    return balls;
}

FluidVolume fluidVolume(const Geometry& g, double finest)
{
    const Box box = fluidBox(g);
    const auto balls = ballsInCell(g);
    if (isBoxAroundBalls(g, box, balls))
    {
        double solid = 0;
        for (const auto& [centre, R] : balls) solid += g.dimension == 3 ? 4 * std::numbers::pi / 3 * R * R * R : std::numbers::pi * R * R;
        return {measure(box.high - box.low, g.dimension) - solid, 0, true};
    }
    const int halvings = 3;
    const double coarsest = finest * (1 << halvings);
    const double fine = quadrature(g, box, coarsest, halvings), coarse = quadrature(g, box, coarsest, halvings - 1);
    return {fine, std::fabs(fine - coarse), false};
}

}
