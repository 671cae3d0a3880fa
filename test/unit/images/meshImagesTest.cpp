/// Images in meshes: what is behind a surface is filled once, whatever its edges and vertices.
#include "Largest.hpp"
#include "geometry/NearWalls.hpp"
#include "geometry/Plane.hpp"
#include "geometry/Sphere.hpp"
#include "geometry/TriangleMesh.hpp"
#include "meshes.hpp"
#include "scenes.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

using namespace test;
constexpr double H = 1, spacing = 1.0 / 3;

/// The solid around a wedge of fluid along z, of that angle [degrees] from the x axis on.
TriangleSurface aroundWedge(double angle)
{
    const double R = 40, a = angle * std::numbers::pi / 180, rest = 2 * std::numbers::pi - a;
    std::vector<Vector<3>> outline{{0, 0, 0}};
    for (int k = 0; k <= 8; ++k) outline.push_back({R * std::cos(a + k * rest / 8), R * std::sin(a + k * rest / 8), 0});
    return prism(outline, -40, 40);
}

double wendland(double r) // C2 of support 1, of integral 1
{
    const double q = 1 - r;
    return r < 1 ? 21 / (2 * std::numbers::pi) * q * q * q * q * (4 * r + 1) : 0;
}

/// Each body of the meshes by itself, and other shapes.
Geometry meshScene(const TriangleSurface& s, const std::vector<std::shared_ptr<const Shape>>& others = {})
{
    Geometry g;
    g.low = {-10, -10, -10};
    g.high = {10, 10, 10};
    g.facetScale = {spacing, H};
    for (const auto& body : bodiesOf(ofOneRegion(s), g.facetScale)) g.originals.push_back({std::make_shared<TriangleMesh>(body), 0});
    for (const auto& other : others) g.originals.push_back({other, 0});
    g.walls.resize(1);
    repeatPeriodically(g, 1.2 * H);
    return g;
}

/// Places of the fluid around x by a low-discrepancy sequence (Roberts 2018), whose sums are integrals to half a per cent, and the volume of each.
struct Sample
{
    std::vector<Vector<3>> points;
    double volume;
};

Sample sample(const Geometry& g, const Vector<3>& x, int n)
{
    const double R = 2.2 * H, phi = 1.2207440846057596;
    Sample result{{}, std::pow(2 * R, 3) / n};
    for (int k = 1; k <= n; ++k)
    {
        const auto at = [&](double a) { return R * (2 * std::fmod(0.5 + k * a, 1.0) - 1); };
        const Vector<3> p = x + Vector<3>{at(1 / phi), at(1 / (phi * phi)), at(1 / (phi * phi * phi))};
        if (mag(p - x) <= R && g.distance(p) > 0) result.points.push_back(p);
    }
    return result;
}

/// Particles at `points` and their images, with shares.
struct WithImages
{
    FieldStore<3> store;
    Images<3> images;

    WithImages(const Geometry& g, const std::vector<Vector<3>>& points) : images(g, H, spacing)
    {
        images.rules().set(Velocity{}, std::make_unique<Reversed<3>>());
        store.allocate(ImageWeight{});
        setPositions(store, points);
        images.build(store, points.size());
    }
    std::size_t size() const { return images.owned() + images.count(); }
    std::span<const double> weights() { return {store.component(ImageWeight::info.name, 0), size()}; }
};

/// The integral of W over fluid and images around x: 1 where all is filled once.
double filled(const Geometry& g, const Vector<3>& x, int n = 200000)
{
    const auto [points, volume] = sample(g, x, n);
    WithImages all(g, points);
    const auto weight = all.weights();
    double sum = 0;
    for (std::size_t k = 0; k < all.size(); ++k) sum += weight[k] * wendland(mag(positionOf(all.store, k) - x));
    return sum * volume;
}

/// The same by mirroring each point in those facets that it lies over, and no rule for edges.
double filledByFacesAlone(const Geometry& g, const Vector<3>& x, int n)
{
    const auto& body = asMesh(*g.patches[0].shape)->body();
    const auto [points, volume] = sample(g, x, n);
    double sum = 0;
    for (const auto& p : points)
    {
        sum += wendland(mag(p - x));
        for (const auto& f : body.facets())
        {
            const auto corner = [&](int c) { return body.points()[std::size_t(f.points[std::size_t(c)])]; };
            const double d = dot(f.normal, p - corner(0));
            const auto foot = p - d * f.normal;
            if (d > 0 && nearestOnTriangle(foot, corner(0), corner(1), corner(2)).part == TrianglePart::face)
                sum += wendland(mag(foot - d * f.normal - x));
        }
    }
    return sum * volume;
}

// Grooves of 20 degrees to blades of 330: what is behind is filled once, to the sampling's error. The mirror images in the facets alone miss or
// double up to half of it.
TEST(MeshImages, FillWhatIsBehindAnEdgeOnce)
{
    Largest worstAlone;
    for (const double angle : {20., 45., 75., 120., 150., 210., 270., 330.})
    {
        const auto g = meshScene(aroundWedge(angle));
        for (const double r : {0.05, 0.3})
        {
            const double a = 0.3 * angle * std::numbers::pi / 180;
            const Vector<3> x{r * std::cos(a), r * std::sin(a), 0.1};
            const int n = angle < 60 ? 600000 : 200000;
            EXPECT_NEAR(filled(g, x, n), 1, 0.02) << angle << " degrees, " << r;
            worstAlone(filledByFacesAlone(g, x, n) - 1);
        }
    }
    EXPECT_GT(worstAlone.value(), 0.4);
}

// Narrower grooves fill in part, as meshToGhost warns and says: 0.83 at 15 degrees, 0.60 at 10, 0.32 at 5, to the sampling's error.
TEST(MeshImages, FillNarrowGroovesInPart)
{
    for (const auto& [angle, share] : {std::pair{15., 0.83}, {10., 0.60}, {5., 0.32}})
    {
        const double a = 0.3 * angle * std::numbers::pi / 180, r = 0.05;
        EXPECT_NEAR(filled(meshScene(aroundWedge(angle)), {r * std::cos(a), r * std::sin(a), 0.1}, 600000), share, 0.03) << angle;
    }
}

/// A block whose top, through the z axis, makes that angle [degrees] with the floor y = 0, above the fluid.
TriangleSurface overhang(double angle)
{
    const double L = 30, a = angle * std::numbers::pi / 180;
    const Vector<3> along{L * std::cos(a), L * std::sin(a), 0}, into{-L * std::sin(a), L * std::cos(a), 0};
    return prism({-1 * along, along, along + into, into - along}, -L, L);
}

// The same wedges between two bodies, a mesh on a plane and on another mesh, are filled as those of one, by as many images of each particle as they need. With
// two or three at all angles the integral was 0.42 at 20 degrees, 0.70 at 40, and 1.19 at 100. The samples are the same; at 115 degrees, where three images go
// over into two, up to 3 % are missing.
TEST(MeshImages, FillTheWedgeOfTwoBodiesAsThatOfOne)
{
    const auto floor = std::make_shared<Plane>(Vector<3>{}, Vector<3>{0, 1, 0});
    for (const double angle : {20., 30., 40., 60., 80., 88., 100., 104., 106., 115., 130.})
    {
        const auto one = meshScene(aroundWedge(angle)), onPlane = meshScene(overhang(angle), {floor}),
                   onMesh = meshScene(together(overhang(angle), block({-30, -30, -30}, {30, 0, 30})));
        for (const double r : {0.05, 0.3})
        {
            const double a = 0.3 * angle * std::numbers::pi / 180;
            const Vector<3> x{r * std::cos(a), r * std::sin(a), 0.1};
            const double expected = filled(one, x, 100000);
            for (const auto* g : {&onPlane, &onMesh})
            {
                EXPECT_NEAR(filled(*g, x, 100000), expected, angle == 115 ? 0.035 : 0.006) << angle << " degrees, " << r;
                EXPECT_LE(WithImages(*g, {x}).images.count(), std::size_t(2 * (std::ceil(180 / angle) + 1))) << angle << " degrees, " << r;
            }
        }
    }
}

// A sphere of 15 spacings across on a floor, analytic and of facets, where the gap is 0.05 to 0.5 H high. With one image of an image it was 0.42 in the
// narrowest, where the surfaces are 12 degrees apart: further images fade there.
TEST(MeshImages, FillTheGapBelowASphereOnce)
{
    const double R = 2.5 * H;
    const auto floor = std::make_shared<Plane>(Vector<3>{}, Vector<3>{0, 1, 0});
    for (const bool facets : {false, true})
        for (const double height : {0.05, 0.15, 0.5})
        {
            const Vector<3> centre{0, R, 0};
            const auto g = facets ? meshScene(icosphere(5, R, centre), {floor})
                                  : meshScene({}, {floor, std::make_shared<Sphere>(centre, R, FluidSide::outside)});
            const Vector<3> x{std::sqrt(R * R - (R - height) * (R - height)), 0.5 * height, 0};
            const double share = filled(g, x);
            EXPECT_GT(share, height < 0.1 ? 0.65 : 0.94) << height << (facets ? ", facets" : "");
            EXPECT_LT(share, 1.04) << height << (facets ? ", facets" : "");
            EXPECT_LE(WithImages(g, {x}).images.count(), 18u);
        }
}

// Grains that touch, overlap as packers leave them, or almost touch, of 8 and 16 spacings of radius; three that touch one another; one in the corner of a box. What is behind them is filled
// once wherever their crevice is wide enough for particles.
TEST(MeshImages, FillTheCrevicesOfGrainsThatTouch)
{
    const auto grain = [](const Vector<3>& centre, double R) { return std::make_shared<Sphere>(centre, R, FluidSide::outside); };
    const auto along = [](const std::string& what, const Geometry& g, const Vector<3>& from, const Vector<3>& to)
    {
        const NearWalls walls(g, H);
        int looked = 0;
        for (int k = 0; k <= 10; ++k)
        {
            const auto x = from + 0.1 * k * (to - from);
            if (g.distance(x) <= 0.2 * spacing || walls.crevice(x, narrowestCrevice * spacing).width < Box::infinity) continue;
            ++looked;
            EXPECT_NEAR(filled(g, x, 100000), 1, 0.05) << what << ", " << 0.1 * k;
        }
        EXPECT_GE(looked, 4) << what;
    };
    for (const double R : {8 * spacing, 16 * spacing})
        for (const double overlap : {-0.05, 0.0, 0.01, 0.03}) // of the diameter
        {
            const double D = 2 * R * (1 - overlap);
            along(std::to_string(overlap), meshScene({}, {grain({-D / 2, 0, 0}, R), grain({D / 2, 0, 0}, R)}), {}, {0, 8 * spacing, 0});
        }
    const double R = 8 * spacing, h = 2 * R / std::sqrt(3.0);
    const auto three = meshScene({}, {grain({h, 0, 0}, R), grain({-h / 2, R, 0}, R), grain({-h / 2, -R, 0}, R)});
    along("three, along their axis", three, {}, {0, 0, 4 * spacing});
    along("three, towards a contact", three, {}, {-h / 2, 0, 0});
    const auto corner =
        meshScene({}, {std::make_shared<Plane>(Vector<3>{}, Vector<3>{1, 0, 0}), std::make_shared<Plane>(Vector<3>{}, Vector<3>{0, 1, 0}),
                       std::make_shared<Plane>(Vector<3>{}, Vector<3>{0, 0, 1}), grain({R, R, R}, R)});
    along("in the corner of a box", corner, {spacing, spacing, spacing}, {0.4 * R, 0.4 * R, 0.4 * R});
    along("in the edge of a box, towards a contact", corner, {0.2 * R, 0.2 * R, R}, {0.1 * R, 0.4 * R, R});
}

// Corners of a cube, of a box, and where a concave edge ends among convex ones, from either side. Where three faces meet, each image has a share
// of a half: what is within half a spacing of the line where they are as near counts one and a half times, 2 to 3 % beside the corner.
TEST(MeshImages, FillWhatIsBehindACornerOnce)
{
    const auto square = prism({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}}, -4, 4);
    const auto L = prism({{0, 0, 0}, {0, 4, 0}, {-4, 4, 0}, {-4, -4, 0}, {4, -4, 0}, {4, 0, 0}}, -4, 4);
    struct Corner
    {
        const char* name;
        TriangleSurface surface;
        Vector<3> vertex, into;
    };
    for (const auto& [name, surface, vertex, into] :
         {Corner{"cube", square, {4, 4, 4}, {1, 1, 1}}, Corner{"box", inverted(square), {4, 4, 4}, {-1, -1, -1}},
          Corner{"above the concave edge", L, {0, 0, 4}, {0.5, 0.5, 1}}, Corner{"in it", L, {0, 0, 4}, {0.5, 0.5, -0.5}},
          Corner{"above the solid", L, {0, 0, 4}, {-0.5, -0.5, 1}}, Corner{"in a cavity", inverted(L), {0, 0, 4}, {-0.5, -0.5, -1}},
          Corner{"beside its edge", inverted(L), {0, 0, 4}, {0.5, -0.5, -0.5}}})
        for (const double r : {0.1, 0.4}) EXPECT_NEAR(filled(meshScene(surface), vertex + r * into), 1, 0.035) << name << ", " << r;
}

// Facets from five spacings down to half of one, around the fluid and in it: faces that stand for themselves, then a smooth surface.
TEST(MeshImages, FillWhatIsBehindASphereOnceAtAnySizeOfFacets)
{
    const double R = 6;
    for (const int halvings : {1, 2, 3, 5})
        for (const bool inside : {false, true})
        {
            const auto s = icosphere(halvings, R);
            const auto g = meshScene(inside ? inverted(s) : s);
            for (const double d : {0.1, 0.4})
            {
                const Vector<3> x = (inside ? R - d : R + d) * Vector<3>{0.3, 0.95394, 0};
                EXPECT_NEAR(filled(g, x), 1, 0.015) << halvings << (inside ? " inside " : " outside ") << d;
            }
        }
}

// A drum: where the ends meet the curved side, of facets of one and of half a spacing, from without and within.
TEST(MeshImages, FillWhatIsBehindTheRimOfADrumOnce)
{
    const double R = 3;
    for (const int sides : {24, 57})
    {
        std::vector<Vector<3>> outline;
        for (int k = 0; k < sides; ++k)
            outline.push_back({R * std::cos(2 * std::numbers::pi * k / sides), R * std::sin(2 * std::numbers::pi * k / sides), 0});
        const auto drum = prism(outline, -3, 3);
        for (const bool inside : {false, true})
        {
            const auto g = meshScene(inside ? inverted(drum) : drum);
            for (const double d : {0.1, 0.4})
                for (const double angle : {0.3, 2.0})
                {
                    const double r = inside ? R - d : R + d;
                    const Vector<3> x{r * std::cos(angle), r * std::sin(angle), inside ? 3 - d : 3 + d};
                    EXPECT_NEAR(filled(g, x, inside ? 600000 : 200000), 1, 0.015)
                        << sides << (inside ? " inside " : " outside ") << d << ", " << angle;
                    if (inside) continue;
                    const Vector<3> under{r * std::cos(angle), r * std::sin(angle), 3 - d};
                    EXPECT_NEAR(filled(g, under), 1, 0.015) << sides << " beside " << d << ", " << angle;
                }
        }
    }
}

// A rough body with edges and curved patches, smaller than the support in places: no share is NaN or negative, nor once the particles have moved
// by more than the lists allow.
TEST(MeshImages, OfARoughBodyHaveFiniteShares)
{
    auto s = icosphere(2, 1.2 * H);
    for (std::size_t p = 0; p < s.points.size(); ++p) s.points[p] = (1 + 0.3 * std::sin(7.0 * double(p * p))) * s.points[p];
    for (const bool inside : {false, true})
    {
        const auto g = meshScene(inside ? inverted(s) : s);
        std::vector<Vector<3>> points;
        for (int k = 1; k <= 4000; ++k)
        {
            const auto at = [&](double a) { return 2.5 * H * (2 * std::fmod(0.5 + k * a, 1.0) - 1); };
            if (const Vector<3> p{at(0.8191725134), at(0.6710436067), at(0.5497004779)}; g.distance(p) > 0) points.push_back(p);
        }
        WithImages all(g, points);
        for (const bool moved : {false, true})
        {
            if (moved)
            {
                for (std::size_t c = 0; c < 3; ++c)
                    for (std::size_t i = 0; i < points.size(); ++i)
                        all.store.pointers(Position{})[c][i] += 0.2 * H * std::sin(double(3 * i + c));
                all.images.move(all.store);
            }
            const auto wrong = std::ranges::count_if(all.weights(), [](double w) { return !(w >= 0 && std::isfinite(w)); });
            EXPECT_EQ(wrong, 0) << (inside ? "inside" : "outside") << (moved ? ", moved" : "");
        }
    }
}

// A body that is one smooth patch but for single edges of more than 30 degrees, round whose ends it goes on: what lies beyond such an edge is over its far side, too, and has an
// image in either. No two of all particles and images are in one place, and none is in the fluid. Once, images moved to the far side as soon as they were made, and what was mirrored twice there
// came back to its source; and what an edge's far side had no part in competing for came out of the body again, with all its volume.
TEST(MeshImages, AtARidgeThatEndsAreNotInOnePlace)
{
    auto s = icosphere(1, 4 * spacing);
    for (std::size_t p = 0; p < s.points.size(); ++p) s.points[p] = (1 + 0.05 * std::sin(7.0 * double(p * p))) * s.points[p];
    for (const bool inside : {false, true})
    {
        const auto g = meshScene(inside ? inverted(s) : s);
        std::vector<Vector<3>> points;
        for (int k = 1; k <= 20000; ++k)
        {
            const auto at = [&](double a) { return 6.5 * spacing * (2 * std::fmod(0.5 + k * a, 1.0) - 1); };
            if (const Vector<3> p{at(0.8191725134), at(0.6710436067), at(0.5497004779)}; g.distance(p) > 0.05 * spacing)
                points.push_back(p);
        }
        WithImages all(g, points);
        std::vector<Vector<3>> places;
        Largest inFluid;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (all.weights()[k] > 1e-3)
            {
                places.push_back(positionOf(all.store, k));
                if (k >= points.size() && g.distance(places.back()) > 0.02 * spacing) inFluid(all.weights()[k]);
            }
        EXPECT_LT(inFluid.value(), 0.3) << (inside ? "inside" : "outside");
        std::ranges::sort(places, {}, &Vector<3>::x);
        int pairs = 0;
        for (std::size_t k = 0; k < places.size(); ++k)
            for (std::size_t l = k + 1; l < places.size() && places[l].x - places[k].x < 1e-6 * spacing; ++l)
                pairs += mag(places[l] - places[k]) < 1e-6 * spacing;
        EXPECT_EQ(pairs, 0) << (inside ? "inside" : "outside");
        EXPECT_GT(all.images.count(), 1000u);
    }
}

/// A way of at most that length, in a direction and of a length of its own for each k.
Vector<3> wayOf(std::size_t k, double length)
{
    const auto at = [k](double a) { return std::fmod(0.5 + double(k + 1) * a, 1.0) - 0.5; };
    const Vector<3> way{at(0.8191725), at(0.6710436), at(0.5497005)};
    return (0.2 + 0.8 * std::fmod(double(k) * 0.618034, 1.0)) * length / mag(way) * way;
}

// Images of what has moved by no more than `way` since a search are those that the search found, wherever the particle is among the others now; of what has gone farther, or come in since, they are
// searched for.
TEST(MeshImages, AreRecalledOfWhatHasHardlyMoved)
{
    const double way = 0.15 * spacing;
    const auto g = meshScene(aroundWedge(60));
    const auto points = sample(g, {0.3, 0.1, 0.1}, 1000).points;
    const std::size_t n = points.size();
    FieldStore<3> store;
    setPositions(store, points);
    const auto x = store.pointers(Position{});
    const ReflectingWalls walls(g, H + 2 * way, spacing, 2 * way);
    std::vector<double> number(n, 0.0);
    const auto searched = makeImages<3>(walls, true, x, 0, n, {{}, number.data(), way});
    std::size_t recalled = 0, others = 0;
    for (std::size_t i = 0; i < n; ++i) // in reverse order, each fifth far away and each seventh new
    {
        const std::size_t before = n - 1 - i;
        number[i] = i % 7 == 0 ? 0 : double(before + 1);
        sph::store(points[before] + wayOf(i, i % 5 == 0 ? 6 * way : way), [&](int c, double q) { x[c][i] = q; });
    }
    const auto again = makeImages<3>(walls, true, x, 0, n, {searched, number.data(), way});
    for (std::size_t i = 0; i < n; ++i)
    {
        const auto now = positionOf(store, i), before = points[n - 1 - i];
        const bool stays = i % 7 > 0 && mag(now - before) <= way;
        EXPECT_EQ(again[i / particlesAtOnce].particles[i % particlesAtOnce].at, stays ? before : now) << i;
        ++(stays ? recalled : others);
    }
    EXPECT_GT(recalled, n / 2);
    EXPECT_GT(others, n / 5);
    number.assign(n, double(n + 1)); // of nobody
    EXPECT_EQ(makeImages<3>(walls, true, x, 0, n, {searched, number.data(), way})[0].particles[0].at, positionOf(store, 0));
}

// Recalled images fill what those of a search at the present places do, at edges and between bodies, when particles that walls hold off have moved as far as they may.
TEST(MeshImages, FillTheSameWhereTheyAreRecalled)
{
    const double way = 0.15 * spacing;
    const auto floor = std::make_shared<Plane>(Vector<3>{}, Vector<3>{0, 1, 0});
    const Vector<3> besideEdge{0.25, 0.15, 0.1}, inGap{1.6, 0.3, 0.1};
    for (const auto& [g, x] : {std::pair{meshScene(aroundWedge(45)), besideEdge},
                               {meshScene(aroundWedge(270)), besideEdge},
                               {meshScene(overhang(40), {floor}), besideEdge},
                               {meshScene(together(icosphere(4, 3 * H, {0, 3.05 * H, 0}), block({-9, -9, -9}, {9, 0, 9}))), inGap}})
    {
        auto [points, volume] = sample(g, x, 20000);
        std::erase_if(points, [&g = g](const auto& p) { return g.distance(p) < 0.4 * spacing; });
        FieldStore<3> store;
        store.allocate(ImageWeight{});
        store.allocateState(ImagesMade{});
        setPositions(store, points);
        Images<3> images(g, H, spacing, 0, nullptr, 0, way);
        images.build(store, points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            sph::store(points[i] + wayOf(i, way), [p = store.pointers(Position{}), i](int c, double q) { p[c][i] = q; });
        const auto share = [&, volume = volume, x = x] // of the kernel
        {
            images.build(store, points.size(), false);
            double sum = 0;
            for (std::size_t k = 0; k < images.owned() + images.count(); ++k)
                sum += store.component(ImageWeight::info.name, 0)[k] * wendland(mag(positionOf(store, k) - x));
            return sum * volume;
        };
        const double recalled = share();
        images.forget();
        EXPECT_GT(recalled, 0.1);
        EXPECT_NEAR(recalled, share(), 1e-3);
    }
}

// Whoever is near the surface is named, and not as farther off than it is. Images lie along the mean normals of corners, where the surface is farther
// by 0.012 spacings at most here.
TEST(MeshImages, NearFacesAreNoFartherThanTheSurface)
{
    auto s = icosphere(3, 6 * H);
    for (std::size_t p = 0; p < s.points.size(); ++p) s.points[p] = (1 + 0.01 * std::sin(7.0 * double(p * p))) * s.points[p];
    const double within = 0.8 * spacing;
    for (const bool inside : {false, true})
    {
        const auto g = meshScene(inside ? inverted(s) : s);
        std::vector<Vector<3>> points;
        for (const auto& direction : icosphere(4, 1).points)
            for (const double d : {0.02, 0.3})
                if (const auto p = (6 * H + (inside ? -d : d) * spacing) * direction; g.distance(p) > 0) points.push_back(p);
        WithImages all(g, points);
        std::vector<double> bound(points.size(), within);
        for (const auto& [i, d] : all.images.nearFaces(within)) bound[i] = d;
        Largest missed;
        for (std::size_t i = 0; i < points.size(); ++i)
            missed(std::max(0.0, std::min(within, bound[i]) - std::min(within, g.distance(points[i]))));
        EXPECT_GT(points.size(), 2000);
        EXPECT_LT(missed.value(), 1e-12) << (inside ? "inside" : "outside");
    }
}

}
}
