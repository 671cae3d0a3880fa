/// Velocity and pressure rules of wall ghosts against the flows and columns that they are to continue exactly.
#include "models/walls/ghostRules.hpp"
#include "Largest.hpp"
#include "geometry/Plane.hpp"
#include "scenes.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

/// A wall y = 0 that moves with 0.5 m/s along x; fluid of nu = 0.02 m^2/s, driven by g_x = 3 m/s^2.
struct MovingWall
{
    Geometry geometry;
    Coefficients coefficients;
    FieldStore<2> store;

    MovingWall()
    {
        geometry.dimension = 2;
        geometry.high = {1, 1, 0};
        WallProperties wall;
        wall.velocity = {0.5, 0, 0};
        geometry.walls = {wall};
        geometry.originals = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0}};
        repeatPeriodically(geometry, 0.3);
        coefficients.restDensity = {1000};
        coefficients.viscosity = {20};
        coefficients.g = {3, -9.81, 0};
        store.allocateState(Position{});
        store.allocateState(WallAcceleration{});
        store.allocate(PressureAcceleration{});
        store.resize(2);
    }
    static Reflection<2> at(double d) { return {d, 1, {0, 1}, 0, {0.3, 0, 0}}; }
};

// change() is what operator() does to a difference of velocities, whatever the wall does and however curved it is.
TEST(GhostVelocity, ChangeIsTheLinearPart)
{
    MovingWall w;
    SecondOrderVelocity<2> second(w.geometry, w.store, w.coefficients, false);
    second.bind();
    const ReflectedVelocity<2> reflected(w.geometry);
    const LimitedVelocity<2> limited(w.geometry);
    const SlippingVelocity<2> slipping(w.geometry);
    auto at = w.at(0.07);
    at.weight = 0.6;
    const Vector<2> v{0.7, -0.2}, dv{0.03, 0.05};
    for (const GhostVelocity<2>* rule : {static_cast<const GhostVelocity<2>*>(&second), static_cast<const GhostVelocity<2>*>(&reflected),
                                         static_cast<const GhostVelocity<2>*>(&limited), static_cast<const GhostVelocity<2>*>(&slipping)})
        EXPECT_LT(mag((*rule)(v + dv, 0, at) - (*rule)(v, 0, at) - rule->change(dv, at)), 1e-15);
}

// v_g = 2 v_w - v: Couette flow v = v_w + s y is continued exactly.
TEST(GhostVelocity, ReflectedContinuesShear)
{
    const MovingWall w;
    const ReflectedVelocity<2> rule(w.geometry);
    const double d = 0.07, s = 11;
    EXPECT_NEAR(rule({0.5 + s * d, 0.2}, 0, w.at(d)).x, 0.5 - s * d, 1e-15);
    EXPECT_NEAR(rule({0.5 + s * d, 0.2}, 0, w.at(d)).y, -0.2, 1e-15);
}

// Values by hand: v_i - v_g = beta (v_i - v_w), beta = min(1.5, 1 + d_g/d).
TEST(GhostVelocity, OfMorrisIsLimited)
{
    const MovingWall w;
    const LimitedVelocity<2> rule(w.geometry);
    auto at = w.at(0.06);
    for (const auto& [ghost, beta] : {std::pair{0.015, 1.25}, {0.03, 1.5}, {0.06, 1.5}, {0.18, 1.5}})
    {
        at.ratio = ghost / 0.06;
        const Vector<2> v{0.7, -0.4}, v_w{0.5, 0};
        EXPECT_LT(mag(v - rule(v, 0, at) - beta * (v - v_w)), 1e-15) << ghost;
    }
}

// v = v_w + s y - g y^2/(2 nu), the steady flow along a wall, has v(-d) = 2 v_w - v(d) - g d^2/nu: the second-order rule gives
// it exactly, the normal part of gravity (which pressure carries) left out.
TEST(GhostVelocity, SecondOrderContinuesAParabola)
{
    MovingWall w;
    SecondOrderVelocity<2> rule(w.geometry, w.store, w.coefficients, false);
    rule.bind();
    const double s = 11, nu = 0.02;
    const auto flow = [&](double y) { return 0.5 + s * y - 3 * y * y / (2 * nu); };
    for (double d : {0.01, 0.05, 0.2})
    {
        EXPECT_NEAR(rule({flow(d), 0}, 0, w.at(d)).x, flow(-d), 1e-13);
        EXPECT_NEAR(rule({flow(d), 0}, 0, w.at(d)).y, 0, 1e-15);
        // A ghost of a ghost behind walls at right angles takes the sign alone.
        auto atCorner = w.at(d);
        atCorner.facing = 0;
        EXPECT_NEAR(rule({flow(d), 0}, 0, atCorner).x, 1 - flow(d), 1e-13);
    }
}

/// Largest error of the images' v_z between planes, of particles at `points` in a flow v_z(x) along z, driven by a = 3 m/s^2 at nu = 0.02 m^2/s.
double errorOfContinuation(const std::vector<Plane>& planes, const std::vector<Vector<3>>& points, const auto& flow)
{
    Geometry g = test::domain(3, {1, 1, 1});
    for (const auto& plane : planes) test::addWall(g, plane);
    const double reach = 0.4, spacing = 0.1;
    repeatPeriodically(g, reach);
    Coefficients c;
    c.restDensity = {1000};
    c.viscosity = {20};
    c.g = {0, 0, 3};
    FieldStore<3> store;
    store.allocateState(WallAcceleration{});
    store.allocateState(Velocity{});
    test::setPositions(store, points);
    Images<3> images(g, reach, spacing);
    images.build(store, points.size());
    images.rules().set(Velocity{}, std::make_unique<SecondOrderVelocity<3>>(g, store, c, false));
    images.rules().bind();
    const auto v = store.pointers(Velocity{});
    for (std::size_t i = 0; i < points.size(); ++i)
        sph::store(Vector<3>{0, 0, flow(points[i])}, [&](int k, double q) { v[std::size_t(k)][i] = q; });
    Images<3>::refresh<Velocity>(images, store);
    EXPECT_GT(images.count(), planes.size() * points.size()); // images of images, too
    test::Largest largest;
    for (std::size_t k = points.size(); k < images.nullParticle(); ++k) largest(v[2][k] - flow(test::positionOf(store, k)));
    return largest.value();
}

// Between parallel plates from half a spacing to three spacings apart every image, images of images among them, has the parabola's velocity at its place: to round-off.
TEST(GhostVelocity, SecondOrderContinuesAParabolaAtAnyWidth)
{
    for (const double spacings : {0.5, 1.0, 1.7, 2.5, 3.0})
    {
        const double w = 0.1 * spacings;
        std::vector<Vector<3>> points;
        for (const double share : {0.1, 0.5, 0.8}) points.push_back({0.5, share * w, 0.5});
        EXPECT_LT(errorOfContinuation({Plane({0, 0, 0}, {0, 1, 0}), Plane({0, w, 0}, {0, -1, 0})}, points,
                                      [w](const Vector<3>& x) { return 3 / 0.04 * x.y * (w - x.y); }),
                  1e-13)
            << spacings;
    }
}

// In a wedge of up to 60 degrees the polynomial d_1 d_2 goes on through both planes; from 80 degrees on the flow r^(pi/alpha) sin(pi theta/alpha) does, which changes its
// sign at each: at 90 degrees 2 x y, of no acceleration.
TEST(GhostVelocity, SecondOrderContinuesTheFlowAlongAWedge)
{
    for (const double degrees : {20.0, 40.0, 60.0})
    {
        const double alpha = degrees * std::numbers::pi / 180;
        const Plane floor({0, 0, 0}, {0, 1, 0}), slope({0, 0, 0}, {std::sin(alpha), -std::cos(alpha), 0});
        std::vector<Vector<3>> points;
        for (const double r : {0.05, 0.15})
            for (const double share : {0.2, 0.7}) points.push_back({r * std::cos(share * alpha), r * std::sin(share * alpha), 0.5});
        EXPECT_LT(errorOfContinuation({floor, slope}, points,
                                      [&](const Vector<3>& x)
                                      { return 3 / (0.04 * std::cos(alpha)) * floor.foot(x).distance * slope.foot(x).distance; }),
                  1e-13)
            << degrees;
    }
    EXPECT_EQ(evenShare(std::cos(80 * std::numbers::pi / 180)), 0);
    EXPECT_EQ(evenShare(0), 0);
    EXPECT_EQ(evenShare(-1), 0);
}

// The same of a source with mu and rho of its own, whose weight and body force drive it: a = g + f/rho.
TEST(GhostVelocity, SecondOrderKnowsTheSourcesOwnViscosity)
{
    MovingWall w;
    w.coefficients.bodyForce = {500, 0, 0};
    w.store.allocate(Density{});
    w.store.allocate(DynamicViscosity{});
    w.store.resize(2);
    SecondOrderVelocity<2> rule(w.geometry, w.store, w.coefficients, true);
    rule.bind();
    w.store.component("rho", 0)[1] = 250;
    w.store.component("mu", 0)[1] = 4;
    const double d = 0.05, s = 11, curvature = (3 + 500 / 250.0) / (4 / 250.0);
    const auto flow = [&](double y) { return 0.5 + s * y - curvature * y * y / 2; };
    EXPECT_NEAR(rule({flow(d), 0}, 1, w.at(d)).x, flow(-d), 1e-13);
}

// A flow driven by pressure looks the same to the wall once the low-passed a_p has arrived: after n steps 1 - 0.9^n of it has.
TEST(GhostVelocity, SecondOrderFollowsThePressureSlowly)
{
    MovingWall w;
    w.coefficients.g = {0, 0, 0};
    SecondOrderVelocity<2> rule(w.geometry, w.store, w.coefficients, false);
    w.store.component("dUdtByPressure", 0)[0] = 3;
    rule.bind();
    for (int step = 0; step < 5; ++step) rule.filter();
    const double arrived = 3 * (1 - std::pow(0.9, 5)), d = 0.1;
    EXPECT_NEAR(rule({0.5, 0}, 0, w.at(d)).x, 0.5 - d * d / 0.02 * arrived, 1e-14);
}

// Outside a sphere of radius R the ghost at distance d moves (R + d)/(R - d) times as fast the other way: 1/sqrt of its volume
// factor.
TEST(GhostVelocity, SecondOrderKnowsTheCurvature)
{
    MovingWall w;
    w.coefficients.g = {0, 0, 0};
    w.geometry.walls[0].velocity = {0, 0, 0};
    SecondOrderVelocity<2> rule(w.geometry, w.store, w.coefficients, false);
    rule.bind();
    auto reflection = w.at(0.1);
    const double R = 0.4, d = 0.1;
    reflection.weight = std::pow((R - d) / (R + d), 2);
    EXPECT_NEAR(rule({0.7, 0}, 0, reflection).x, -0.7 * (R + d) / (R - d), 1e-14);
}

// Outside a sphere -a/(6 nu) (r^2 - 3 R^2 + 2 R^3/r) + B (1/R - 1/r) is the flow of constant acceleration a that depends on r alone and vanishes at R: the rule continues it exactly.
TEST(GhostVelocity, SecondOrderContinuesAFlowOutsideASphere)
{
    MovingWall w;
    w.geometry.walls[0].velocity = {0, 0, 0};
    SecondOrderVelocity<2> rule(w.geometry, w.store, w.coefficients, false);
    rule.bind();
    const double R = 0.4, B = 2, a = 3, nu = 0.02;
    const auto flow = [&](double r) { return -a / (6 * nu) * (r * r - 3 * R * R + 2 * R * R * R / r) + B * (1 / R - 1 / r); };
    for (const double d : {0.01, 0.1, 0.3})
    {
        auto reflection = w.at(d);
        reflection.weight = std::pow((R - d) / (R + d), 2);
        EXPECT_NEAR(rule({flow(R + d), 0}, 0, reflection).x, flow(R - d), 1e-11) << d;
    }
}

// A wall with `slip yes;` mirrors, the others do what their rule does, and both at the change of a velocity and when arrays are bound again.
TEST(GhostVelocity, EachWallHasItsRule)
{
    MovingWall w;
    w.geometry.walls.push_back(w.geometry.walls[0]);
    w.geometry.walls[1].slips = true;
    EXPECT_TRUE(w.geometry.slips());
    VelocityByWall<2> rule(w.geometry, std::make_unique<SecondOrderVelocity<2>>(w.geometry, w.store, w.coefficients, false));
    rule.bind();
    SecondOrderVelocity<2> second(w.geometry, w.store, w.coefficients, false);
    second.bind();
    const SlippingVelocity<2> slipping(w.geometry);
    const auto at = w.at(0.07);
    auto atSlipping = at;
    atSlipping.wall = 1;
    const Vector<2> v{0.7, -0.2};
    EXPECT_EQ(rule(v, 0, at), second(v, 0, at));
    EXPECT_EQ(rule.change(v, at), second.change(v, at));
    EXPECT_EQ(rule(v, 0, atSlipping), slipping(v, 0, atSlipping));
    EXPECT_EQ(rule.change(v, atSlipping), (Vector<2>{0.7, 0.2}));
    w.store.component("dUdtByPressure", 0)[0] = 3;
    rule.filter();
    EXPECT_GT(w.store.component("dUdtAtWall", 0)[0], 0);
}

// The fluid slides: along the wall the ghost moves with its source, across it the other way, both relative to the wall.
TEST(GhostVelocity, SlippingMirrors)
{
    MovingWall w;
    w.geometry.walls[0].velocity = {0.5, 0.1, 0};
    const SlippingVelocity<2> rule(w.geometry);
    const auto v = rule({2, 0.4}, 0, w.at(0.1));
    EXPECT_NEAR(v.x, 2, 1e-15);
    EXPECT_NEAR(v.y, -0.2, 1e-15);
}

// p = p_0 - rho (g + f/rho)_y y in a column at rest under gravity and a body force, continued below the floor y = 0: p_g(-d) exactly.
// What acts along the wall changes nothing. rho is the source's own, not the rest density. Round-off of a few kPa.
TEST(GhostPressure, ContinuesAColumnAtRest)
{
    MovingWall w;
    w.coefficients.bodyForce = {40, -700, 0};
    w.store.allocate(Density{});
    w.store.resize(2);
    w.store.component("rho", 0)[0] = 1100;
    w.store.component("rho", 0)[1] = 900;
    HydrostaticPressure<2> rule(w.store, w.coefficients);
    rule.bind();
    for (std::size_t i : {0u, 1u})
    {
        const double rho = i == 0 ? 1100 : 900;
        const auto column = [&](double y) { return 5000 + (rho * -9.81 - 700) * y; };
        for (double d : {0.01, 0.2}) EXPECT_NEAR(rule(column(d), i, w.at(d)), column(-d), 1e-11);
    }
}

// Under a floor that is a lid by the direction of gravity: a drop at p = 0 has a ghost at 0 and falls, where the hydrostatic continuation would
// hold it; a liquid under pressure is continued as at rest, and so is one on a floor; a tension stays what it is.
TEST(GhostPressure, DetachingNeverPulls)
{
    MovingWall w;
    w.coefficients.bodyForce = {0, 2 * 9810, 0}; // upwards: the wall y = 0 is the ceiling of what falls up
    w.store.allocate(Density{});
    w.store.resize(1);
    w.store.component("rho", 0)[0] = 1000;
    DetachingPressure<2> lid(w.store, w.coefficients);
    lid.bind();
    const double fall = 2 * 0.1 * 9810;
    EXPECT_EQ(lid(0, 0, w.at(0.1)), 0);
    EXPECT_NEAR(lid(5000, 0, w.at(0.1)), 5000 - fall, 1e-10);
    EXPECT_EQ(lid(100, 0, w.at(0.1)), 0);
    EXPECT_EQ(lid(-300, 0, w.at(0.1)), -300);
    w.coefficients.bodyForce = {};
    DetachingPressure<2> floor(w.store, w.coefficients);
    floor.bind();
    EXPECT_NEAR(floor(0, 0, w.at(0.1)), fall, 1e-10);
}

}
}
