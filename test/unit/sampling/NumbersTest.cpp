/// Numbers that a case makes of expressions: the function object `reduction`, and `errors` of them.
#include "Observed.hpp"
#include "geometry/Plane.hpp"
#include "sampling/Errors.hpp"
#include "sampling/Reduction.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <utility>

using namespace sph;

namespace
{

/// The values of the row that `numbers { .. }` makes of the particles, without its time.
std::vector<double> numbersOf(const Particles& particles, const std::string& numbers)
{
    Observed<Reduction> object;
    const auto rows = object.rowsOf(particles, "numbers { " + numbers + " }");
    std::vector<double> values;
    for (std::size_t k = 1; k < rows.at(0).size(); ++k) values.push_back(std::stod(rows[0][k]));
    return values;
}

/// The unit square in 10 x 10 particles: water below y = 0.4, air above.
Particles square()
{
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.1);
    particles.phases = {"water", "air"};
    particles.setPhase([](Vector<3> x) { return x.y < 0.4 ? 0 : 1; });
    particles.setP([](Vector<3> x) { return 10 * x.y; });
    particles.setU([](Vector<3> x) { return Vector<3>{x.x, -2 * x.y, 0}; });
    particles.g = {0, -9.81, 0};
    particles.time = 3;
    return particles;
}

}

// Sums over a lattice of midpoints, by hand: exact of linear expressions, to round-off.
TEST(Numbers, areThoseByHand)
{
    auto particles = square();
    const auto n = numbersOf(particles, R"n(
        area        { operation sum; value "$volume"; }
        water       { operation sum; value "$volume"; phase water; }
        pOfWater    { operation mean; value "$p"; phase water; }
        pInBox      { operation mean; value "$p"; region { min (0 0 0); max (1 0.2 0); } }
        right       { operation mean; value "$x"; where "$x > 0.5 && $y > 0.5"; }
        front       { operation max; value "$x + $spacing/2"; phase water; }
        lowest      { operation min; value "$U_y"; }
        byMass      { operation mean; value "$y"; weight "$mass*$y"; }
        head        { value "$pOfWater/(1000*mag($g)) + $t"; }
        ofPhase     { operation mean; value "$restDensity"; }
        push        { operation sum; value "$volume*dot($U, $g)"; }
    )n");
    const double meanOfSquares =
        (sqr(0.05) + sqr(0.15) + sqr(0.25) + sqr(0.35) + sqr(0.45) + sqr(0.55) + sqr(0.65) + sqr(0.75) + sqr(0.85) + sqr(0.95)) / 10;
    const std::vector<double> expected{1, 0.4, 2, 1, 0.75, 1, -1.9, meanOfSquares / 0.5, 2 / 9810.0 + 3, 400.6, 9.81};
    ASSERT_EQ(n.size(), expected.size());
    for (std::size_t k = 0; k < n.size(); ++k) EXPECT_NEAR(n[k], expected[k], 1e-13 * std::abs(expected[k])) << k;
}

// Of 100 values 0.1 to 10, a tenth of the weight in each row of y; weights move the share.
TEST(Numbers, percentilesAreValuesThatParticlesHave)
{
    auto particles = square();
    const std::string of = "operation percentile; value \"$p\"; percent ";
    const auto n =
        numbersOf(particles, "none { " + of + "0; } tenth { " + of + "10; } more { " + of + "10.1; } half { " + of + "50; } all { " + of +
                                 "100; } above { " + of + "50; weight \"$y > 0.8 ? 1 : 0\"; } one { " + of + "50; where \"$p == 2.5\"; }");
    for (std::size_t k = 0; const double expected : {0.5, 0.5, 1.5, 4.5, 9.5, 8.5, 2.5}) EXPECT_DOUBLE_EQ(n.at(k++), expected);
}

// The row beside the floor has its middle half a spacing above it; the wall on the left is another one.
TEST(Numbers, knowParticlesBesideAWall)
{
    auto particles = square();
    auto& g = particles.geometry;
    g.walls.resize(2);
    g.walls[0].name = "floor";
    g.walls[1].name = "left";
    g.patches = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0},
                 {std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{1, 0, 0}), 1}};
    const auto n = numbersOf(
        particles,
        "p { operation mean; value \"$p\"; wall floor; } x { operation max; value \"$x\"; wall left; within 2; where \"$y > 0.5\"; }");
    EXPECT_DOUBLE_EQ(n.at(0), 0.5);
    EXPECT_DOUBLE_EQ(n.at(1), 0.15);
    Observed<Reduction> object;
    EXPECT_EQ(object.mistakesIn(particles, "numbers { p { operation mean; value \"$p\"; wall flor; } }"),
              "system/controlDict:1: wall \"flor\" is unknown. Did you mean \"floor\"? Known wall: floor, left.");
}

// Gradients are exact for linear fields, at faces and corners too; phases, walls and what is smoothed are known by name.
TEST(Numbers, knowGradientsPhasesAndWalls)
{
    auto particles = square();
    auto& g = particles.geometry;
    g.walls.resize(1);
    g.walls[0].name = "floor";
    g.walls[0].contactAngle = 60;
    g.patches = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0}};
    const auto n = numbersOf(particles, R"n(
        steepest    { operation max; value "mag(grad($p) - vector(0, 10, 0))"; }
        divergence  { operation mean; value "dot(grad($U_x), vector(1, 0, 0)) + dot(grad($U_y), vector(0, 1, 0))"; }
        ofWater     { operation sum; value "$water*$volume"; }
        ofAir       { operation sum; value "$air*$volume"; }
        alone       { operation sum; value "$volume"; phase water; where "smooth($water) > 1 - 1e-12"; }
        near        { operation max; value "$y"; where "${distance(floor)} < 0.12"; }
        angle       { value "${contactAngle(floor)}"; }
    )n");
    EXPECT_NEAR(n.at(0), 0, 1e-11);
    EXPECT_NEAR(n.at(1), -1, 1e-12);
    EXPECT_NEAR(n.at(2), 0.4, 1e-12);
    EXPECT_NEAR(n.at(3), 0.6, 1e-12);
    EXPECT_NEAR(n.at(4), 0.2, 1e-12); // two rows see no air within three spacings
    EXPECT_DOUBLE_EQ(n.at(5), 0.05);
    EXPECT_EQ(n.at(6), 60);
    Observed<Reduction> object;
    EXPECT_EQ(object.refusalOf(particles, "numbers { a { operation max; value \"mag(grad($U))\"; } }"),
              "system/controlDict:1: \"mag(grad($U))\": $U is a vector: take a component, $U_x");
    EXPECT_EQ(object.refusalOf(particles, "numbers { a { operation max; value \"mag(grad($t))\"; } }"),
              "system/controlDict:1: \"mag(grad($t))\": $t is no field: it has one value for all particles");
    EXPECT_EQ(object.refusalOf(particles, "numbers { a { operation max; value \"${distance(flor)}\"; } }"),
              "system/controlDict:1: \"${distance(flor)}\": wall \"flor\" is unknown. Did you mean \"floor\"? Known walls: floor.");
    Observed<Reduction> other;
    EXPECT_EQ(other.mistakesIn(particles, "numbers { a { operation max; value \"grad(2*$p)\"; } }"),
              "system/controlDict:1: value \"grad(2*$p)\": grad() takes the name of a field: grad($p)");
}

// Of second order in the interior: a quadratic field on a lattice, whose symmetry makes its gradient exact there, and a cubic one.
TEST(Numbers, gradientsConverge)
{
    double before = 0;
    for (const double spacing : {0.1, 0.05})
    {
        Particles particles(2, {0, 0, 0}, {1, 1, 0}, spacing);
        particles.setP([](Vector<3> x) { return x.x * x.x * x.x; });
        const double error =
            numbersOf(
                particles,
                "e { operation max; value \"abs(dot(grad($p), vector(1, 0, 0)) - 3*$x^2)\"; region { min (0.4 0.4 0); max (0.6 0.6 0); } }")
                .at(0);
        if (before > 0) { EXPECT_NEAR(before / error, 4, 0.4); }
        before = error;
    }
}

TEST(Numbers, ofNoParticleAreNaN)
{
    const auto n =
        numbersOf(square(), "mean { operation mean; value \"$p\"; where 0; } max { operation max; value \"$p\"; where \"$p > 100\"; } "
                            "sum { operation sum; value 1; where 0; }");
    EXPECT_TRUE(std::isnan(n.at(0)));
    EXPECT_TRUE(std::isnan(n.at(1)));
    EXPECT_EQ(n.at(2), 0);
}

TEST(Numbers, conditionsThatAreNaNDoNotHold)
{
    const auto n =
        numbersOf(square(),
                  "some { operation sum; value 1; where \"sqrt(0.5 - $x)\"; } same { operation sum; value 1; where \"$x < 0.5\"; } "
                  "none { operation sum; value 1; where \"0/0*$x\"; }");
    EXPECT_GT(n.at(0), 0);
    EXPECT_EQ(n.at(0), n.at(1));
    EXPECT_EQ(n.at(2), 0);
}

// A NaN among the particles that count shows in each of them; of one that does not count in none.
TEST(Numbers, showANaN)
{
    for (const bool first : {true, false})
    {
        auto particles = square();
        particles.p[first ? 0 : 99] = std::nan("");
        const std::string all = "value \"$p\"; } ";
        for (const double value : numbersOf(particles, "a { operation sum; " + all + "b { operation mean; " + all + "c { operation min; " +
                                                           all + "d { operation max; " + all))
            EXPECT_TRUE(std::isnan(value));
        EXPECT_FALSE(std::isnan(
            numbersOf(particles, std::string("m { operation mean; where \"$x ") + (first ? ">" : "<") + " 0.5\"; " + all).at(0)));
    }
}

// Taylor-Green's flow at a quarter of a second, as tutorials/verification/taylorGreen measures it, with as much again of a flow of another shape, which is not part of the
// amplitude. At the start there is no rate.
TEST(Numbers, giveTheDecayOfVortices)
{
    constexpr double pi = std::numbers::pi;
    Particles particles(2, {0, 0, 0}, {2, 2, 0}, 0.05);
    const double rate = 2 * 0.03 * sqr(pi), A = std::exp(-rate * 0.25);
    particles.setU(
        [&](Vector<3> x)
        {
            return Vector<3>{A * (-std::cos(pi * x.x) * std::sin(pi * x.y) + std::sin(2 * pi * x.y)),
                             A * (std::sin(pi * x.x) * std::cos(pi * x.y) - std::sin(2 * pi * x.x)), 0};
        });
    const std::string numbers = R"n(
        along { operation sum; value "$volume*($U_y*sin(pi()*$x)*cos(pi()*$y) - $U_x*cos(pi()*$x)*sin(pi()*$y))"; }
        exact { operation sum; value "$volume*(sqr(sin(pi()*$x)*cos(pi()*$y)) + sqr(cos(pi()*$x)*sin(pi()*$y)))"; }
        rate  { value "-log($along/$exact)/$t"; })n";
    particles.time = 0.25;
    EXPECT_NEAR(numbersOf(particles, numbers).at(2), rate, 1e-12);
    particles.time = 0;
    EXPECT_FALSE(std::isfinite(numbersOf(particles, numbers).at(2)));
}

// phi gammaDot eta^2 = 6 where the particles are sheared but for one, which is 3 % off: its distance from the mean is ln(1.03) (1 - 1/4). The fifth has a tenth of the
// largest stress and does not count. As the channels of tutorials/powderMoulding measure it.
TEST(Numbers, giveTheLargestDepartureFromAMean)
{
    Particles particles(2, {0, 0, 0}, {0.5, 0.1, 0}, 0.1);
    std::vector<double> eta{1, 2, 1, 2, 0.2}, phi{0.5, 0.5, 0.3, 0.4, 0.5}, gammaDot(5);
    for (std::size_t i = 0; i < 5; ++i) gammaDot[i] = 6 / phi[i] / sqr(eta[i]) * (i == 2 ? 1.03 : 1);
    gammaDot[4] = 1;
    const auto value = [&]
    {
        Observed<Reduction> object;
        const auto reduction = object.made(particles, R"n(numbers
            {
                largest { operation max; value "$eta*$gammaDot"; }
                mean    { operation mean; weight 1; value "log($phi*$gammaDot) + 2*log($eta)"; where "$eta*$gammaDot >= 0.1*$largest"; }
                balance { operation max; value "abs(log($phi*$gammaDot) + 2*log($eta) - $mean)"; where "$eta*$gammaDot >= 0.1*$largest"; }
            })n");
        EXPECT_EQ(errorsOf(object.theCase.diagnostics()), "");
        auto view = particles.view();
        view.fields.push_back({"phi", FieldClass::scalar, {phi.data()}});
        view.fields.push_back({"gammaDot", FieldClass::scalar, {gammaDot.data()}});
        view.fields.push_back({"eta", FieldClass::scalar, {eta.data()}});
        reduction->execute(view);
        return std::stod(object.folder.rows("postProcessing/own/0/reduction.dat").at(0).at(3));
    };
    EXPECT_NEAR(value(), 0.75 * std::log(1.03), 1e-12);
    for (const std::size_t at : {0u, 4u})
        for (auto* field : {&eta, &gammaDot})
        {
            const double before = std::exchange((*field)[at], std::nan(""));
            EXPECT_TRUE(std::isnan(value())) << at;
            (*field)[at] = before;
        }
}

/// Values of the last row of numbers over the pressure p(t) of all particles, from rows 0.01 apart up to `end`; the run is stopped half-way and goes on from its histories.
std::vector<double> lastOf(const std::string& numbers, double end, const std::function<double(double)>& p)
{
    auto particles = square();
    Observed<Reduction> object;
    const std::string text = "numbers { now { operation mean; value \"$p\"; } " + numbers + " }";
    auto reduction = object.made(particles, text);
    EXPECT_EQ(errorsOf(object.theCase.diagnostics()), "");
    const long rows = std::lround(end / 0.01);
    for (long k = 0; k <= rows; ++k)
    {
        particles.time = 0.01 * double(k);
        particles.setP([&](Vector<3>) { return p(particles.time); });
        reduction->execute(particles.view());
        if (k != rows / 2) continue;
        const auto stored = reduction->histories();
        reduction = object.made(particles, text);
        reduction->restore(stored);
        reduction->execute(particles.view()); // the time of the folder again
    }
    std::vector<double> values;
    for (const auto& entry :
         std::filesystem::directory_iterator(object.folder.folder() / "postProcessing/own/0")) // the second half has a file of its own
        if (const auto more = object.folder.rows("postProcessing/own/0/" + entry.path().filename().string());
            std::stod(more.back()[0]) > end - 0.005)
            for (std::size_t k = 2; k < more.back().size(); ++k) values.push_back(std::stod(more.back()[k]));
    return values;
}

// Laws in closed form, without noise: to the accuracy of the fits. The mean of t^2 over 0.5 .. 1 by its 51 rows.
TEST(NumbersOverTime, findTheConstantsOfLaws)
{
    const auto decay = lastOf(
        "s { operation fit; value \"$now\"; form exponential; } A { operation fit; value \"$now\"; form exponential; gives amplitude; }", 1,
        [](double t) { return -3 * std::exp(-2.5 * t); });
    EXPECT_NEAR(decay.at(0), -2.5, 1e-12);
    EXPECT_NEAR(decay.at(1), -3, 1e-12);
    const auto power =
        lastOf("n { operation fit; value \"$now\"; form power; } A { operation fit; value \"$now\"; form power; gives factor; }", 1,
               [](double t) { return 7 * std::pow(t, 1.5); });
    EXPECT_NEAR(power.at(0), 1.5, 1e-12);
    EXPECT_NEAR(power.at(1), 7, 1e-12);
    const auto swing = lastOf(
        "T { operation fit; value \"$now\"; form oscillation; } d { operation fit; value \"$now\"; form oscillation; gives decayRate; guess 0.5; from 0.2; }",
        2, [](double t) { return 4 + 2 * std::exp(-0.7 * t) * std::cos(2 * std::numbers::pi * t / 0.4 + 1); });
    EXPECT_NEAR(swing.at(0), 0.4, 1e-9);
    EXPECT_NEAR(swing.at(1), 0.7, 1e-8);
    const auto growth =
        lastOf("s { operation fit; value \"$now\"; form growth; } g { operation fit; value \"$now\"; form growth; guess 2; }", 2,
               [](double t) { return std::cosh(3 * t); });
    EXPECT_NEAR(growth.at(0), 3, 1e-6);
    EXPECT_NEAR(growth.at(1), 3, 1e-6);
    const auto mean = lastOf(
        "m { operation timeMean; value \"$now\"; from 0.5; } a { operation arrival; value \"$now\"; level 0.25; } b { operation arrival; value \"-$now\"; level -0.09; } "
        "never { operation arrival; value \"$now\"; level 2; }",
        1, [](double t) { return t * t; });
    double sum = 0;
    for (int k = 50; k <= 100; ++k) sum += sqr(0.01 * k) / 51;
    EXPECT_NEAR(mean.at(0), sum, 1e-14);
    EXPECT_NEAR(mean.at(1), 0.5, 1e-12);
    EXPECT_NEAR(mean.at(2), 0.3, 1e-12);
    EXPECT_TRUE(std::isnan(mean.at(3)));
}

// A number of a model's report, by its name in braces; before its time a mean has no row, and stored times have no such numbers.
TEST(NumbersOverTime, takeMeansOfWhatModelsReport)
{
    const auto particles = square();
    Observed<Errors> object;
    const auto errors = object.made(
        particles,
        "norm absolute; numbers { Nu { operation timeMean; value \"${power(hot)}\"; from 2; reference { type expression; value 3; } } }");
    ASSERT_EQ(errorsOf(object.theCase.diagnostics()), "");
    auto view = particles.view();
    for (const double t : {1.0, 2.0, 3.0, 3.0, 4.0})
    {
        view.time = t;
        view.numbers = {{"power(hot)", t * t}, {"heat", 7}};
        errors->execute(view);
    }
    const auto rows = object.folder.rows("postProcessing/own/0/errors.dat");
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_NEAR(std::stod(rows.back()[7]), (4 + 9 + 16) / 3., 1e-15);
    view.numbers = {{"power(cold)", 1}};
    try
    {
        errors->execute(view);
        ADD_FAILURE() << "a number that no model reports was found";
    }
    catch (const CaseError& e)
    {
        EXPECT_NE(std::string(e.what()).find("\"$power(hot)\" is unknown. Known names: "), std::string::npos) << e.what();
    }
    view.numbers.clear();
    errors->execute(view);
    EXPECT_EQ(object.folder.rows("postProcessing/own/0/errors.dat").back()[7], "nan");
}

// Mistakes that can be seen before the first row are all said at once, each at its line.
TEST(Numbers, mistakesNameTheirLine)
{
    Observed<Reduction> object;
    EXPECT_EQ(
        object.mistakesIn(
            square(),
            "numbers\n{\n    a { value \"$b + 1\"; }\n    b { operation max; value \"$p + \"; }\n    c { operation mean; value \"$U*$g\"; "
            "phase watr; }\n    d { operation max; value \"vector(1, 2, 3)\"; }\n    e { operation median; value 1; }\n    f 3;\n    g { value \"sqt(2)\"; wall x; }\n}\n"),
        "system/controlDict:4: value \"$p + \": a value is missing at the end\n"
        "system/controlDict:5: phase \"watr\" is unknown. Did you mean \"water\"? Known phase: water, air.\n"
        "system/controlDict:6: value \"vector(1, 2, 3)\": it gives a vector: take a component, or mag() of it\n"
        "system/controlDict:7: operation \"median\" is unknown. Did you mean \"mean\"? Known operation: formula, sum, mean, min, max, percentile, timeMean, arrival, fit, contour.\n"
        "system/controlDict:8: f must be a dictionary: f { operation mean; value \"$p\"; }\n"
        "system/controlDict:9: value \"sqt(2)\": \"sqt\" is unknown (a macro is written $sqt). Did you mean \"sqr\"? Known functions: dot, mag, vector, grad, smooth, abs, acos, asin, atan, atan2, cbrt, ceil, "
        "cos, cosh, degToRad, e, erf, erfc, exp, floor, log, log10, max, min, pi, pow, radToDeg, round, sin, sinh, sqr, sqrt, tan, tanh.\n"
        "system/controlDict:9: entry \"wall\" is not used here. Known entries: operation, value.\n7 errors");
}

// What only a view knows is said where it is met.
TEST(Numbers, unknownNamesAreExplainedWhenTheyAreFirstSeen)
{
    Observed<Reduction> object;
    EXPECT_EQ(
        object.refusalOf(square(), "numbers\n{\n    a { operation max; value \"$pp\"; }\n}"),
        "system/controlDict:3: \"$pp\": \"$pp\" is unknown. Known names: U, U_x, U_y, U_z, p, x, y, z, t, mass, volume, coverage, distance, restDensity, "
        "soundSpeed, viscosity, spacing, support, deltaT, g, water, air.");
    EXPECT_EQ(object.refusalOf(square(), "numbers { a { value \"2*$b\"; } b { value 1; } }"),
              "system/controlDict:1: \"2*$b\": $b stands behind it: numbers are found in the order in which they are given");
    EXPECT_EQ(object.refusalOf(square(), "numbers { a { operation max; value \"2*$U\"; } }"),
              "system/controlDict:1: \"2*$U\": it gives a vector: take a component, or mag() of it");
    EXPECT_EQ(
        object.refusalOf(square(), "numbers { a { value \"2*$p\"; } }"),
        "system/controlDict:1: \"2*$p\": $p has a value for each particle: an operation (sum, mean, min, max, percentile) makes one number of them");
}

TEST(Numbers, areColumnsByTheirNames)
{
    Observed<Reduction> object;
    object.rowsOf(square(), "numbers { area { operation sum; value \"$volume\"; } }");
    EXPECT_NE(object.folder.read("postProcessing/own/0/reduction.dat")
                  .find("# area [of its expression]: a number by the name that the case gives it\n# Time\tarea\n"),
              std::string::npos);
}

// Values and references by hand: of a table half-way between its rows, of an expression with the number itself.
TEST(Numbers, areComparedWithTablesAndExpressions)
{
    Observed<Errors> object;
    object.folder.write("front.csv", "T,Z\n0,1\n4,3\n");
    const auto rows = object.rowsOf(square(), R"n(norm absolute;
        numbers
        {
            front { operation max; value "$x + $spacing/2"; phase water; reference { type csv; file "front.csv"; columns { time T; value Z; } } }
            twice { value "2*$front"; }
            rate  { value "$twice*3"; reference { type expression; value "$t*$twice - 1"; } }
        })n");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0][1], "front");
    EXPECT_DOUBLE_EQ(std::stod(rows[0][7]), 1);
    EXPECT_DOUBLE_EQ(std::stod(rows[0][8]), 2.5);
    EXPECT_DOUBLE_EQ(std::stod(rows[0][3]), 1.5);
    EXPECT_EQ(rows[1][1], "rate");
    EXPECT_DOUBLE_EQ(std::stod(rows[1][7]), 6);
    EXPECT_DOUBLE_EQ(std::stod(rows[1][8]), 5);
}

// Beyond the table there is nothing to compare with, and no row.
TEST(Numbers, haveNoRowWithoutAReference)
{
    Observed<Errors> object;
    object.folder.write("front.csv", "T,Z\n0,1\n2,3\n");
    EXPECT_TRUE(
        object
            .rowsOf(
                square(),
                "numbers { front { operation max; value \"$x\"; reference { type csv; file \"front.csv\"; columns { time T; value Z; } } } }")
            .empty());
}
