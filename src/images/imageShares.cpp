#include "images/imageShares.hpp"
#include "images/chainTable.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
/// Two surfaces that meet at a fluid angle from 105 to 120 degrees on fill the solid behind them with one reflection each. n_p . n_q =
/// -cos(angle).
constexpr double alignedNormals = 0.26, mostAlignedNormals = 0.5;
/// Half of the width over which the images of two surfaces fade into one another at the bisector behind the tip of their wedge [spacings].
constexpr double halfFade = 0.35;
/// Products of the normals of two walls, 8 and 20 degrees between them: what is narrower is a gap, which no spacing resolves, and is filled by one image of an image.
constexpr double ofGap = -0.99, ofWedge = -0.94;
/// Largest change of their product until lists are built anew, of bodies with edges.
constexpr double mostTurn = 0.03;

/// Largest change of the product of two normals that turn towards one another by an angle [rad].
double changeOfProduct(const Vector<3>& n, const Vector<3>& m, double angle)
{
    const double product = std::clamp(dot(n, m), -1.0, 1.0);
    return std::min(mostTurn, std::cos(std::max(std::acos(product) - angle, 0.0)) - product);
}
}

double shareOfWedge(const Vector<3>& n, const Vector<3>& m, double slack)
{
    return smoothStep((dot(n, m) + slack - ofGap) / (ofWedge - ofGap));
}

double shareBeside(const Vector<3>& n, double h, const Vector<3>& m, double k, double spacing, double slack)
{
    const double ofAngle = smoothStep((mostAlignedNormals - dot(n, m)) / (mostAlignedNormals - alignedNormals));
    if (ofAngle == 0) return 0;
    const double turn = mag(n - m), width = std::min(halfFade * spacing, (h + k) / turn);
    return ofAngle * smoothStep(0.5 + 0.5 * ((h - k) / turn + slack) / width);
}

double shareAmong(const ReflectingWalls& walls, const Mirror* mirrors, const Face* faces, int last, const Vector<3>& y, double slack)
{
    const auto& geometry = walls.geometry();
    const int p = mirrors[last].patch;
    if (last == 0 || !geometry.mayBeCovered(p)) return 1;
    const auto& coverers = geometry.coverers[std::size_t(p)];
    const auto within = [&](int patch)
    { return smoothStep(0.5 - 0.5 * geometry.patches[std::size_t(patch)].shape->foot(y).distance / (halfFade * walls.spacing())); };
    double share = 1;
    for (int r = last - 1; r >= 0; --r)
    {
        const int q = mirrors[r].patch;
        const auto isOfThis = [&](const Mirror& m) { return m.patch == q; };
        if (q == p || std::any_of(mirrors + r + 1, mirrors + last, isOfThis) || !std::ranges::binary_search(coverers, q)) continue;
        const auto &face = faces[last], &other = faces[r];
        const double k = other.depthOf(y);
        if (std::abs(dot(face.normal, other.normal)) < rightAngle || k <= 0) continue;
        const double beside = shareBeside(face.normal, face.depthOf(y), other.normal, k, walls.spacing(), slack), inThis = within(p),
                     inOther = within(q);
        if (inThis == 0 && inOther == 0) continue;
        share *= inThis * (1 - inOther * (1 - beside)) / (inThis + inOther - inThis * inOther);
    }
    return share;
}

double weightSoon(const ReflectingWalls& walls, const Chain& chain, Foot f, double speed, int dim)
{
    const double way = 0.5 * walls.skin();
    const auto volumeAt = [&f](double distance)
    {
        Foot at = f;
        at.distance = distance;
        const double factor = volumeFactor(at);
        return factor > 0 ? factor : Box::infinity; // beyond a centre of curvature
    };
    const double volume = std::max(volumeAt(f.distance + way * speed), volumeAt(std::max(f.distance - way * speed, 0.0)));
    f.exposure = 1;
    f.margin += way;
    const int last = chain.reflections - 1;
    double wedge = 1;
    if (goesOnInWedge(chain.mirrors.data(), last, walls.reflectors(), dim))
    {
        const auto &face = chain.faces[std::size_t(last)], &before = chain.faces[std::size_t(last) - 1];
        wedge = shareOfWedge(face.normal, before.normal, changeOfProduct(face.normal, before.normal, face.turn + before.turn));
    }
    return volume * faceShare(f, walls.spacing()) * wedge * shareAmong(walls, chain.mirrors.data(), chain.faces.data(), last, chain.x, way);
}

}
