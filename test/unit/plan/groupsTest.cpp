/// Groups of a plan: what one finds of those before it, what it has to make anew, and the kinds of laws that run in them.
///
/// Sums of 21 numbers in another order, with reciprocals that -ffast-math may take: 1e-12 of them.
#include "Largest.hpp"
#include "Toy.hpp"
#include "base/CaseError.hpp"
#include "solver/models.hpp"
#include <cmath>

namespace sph::test
{
namespace
{

Geometry torus() { return domain(2, {1, 1, 0}, {true, true, false}); }
const Catalogue<2>& chain()
{
    static const auto terms = catalogue<2, Twice, Sum, Total, OtherSum>();
    return terms;
}
void expectTotals(Toy& toy)
{
    for (std::size_t i = 0; i < toy.n; ++i)
    {
        const double c = toy.sum(i, [&](std::size_t j) { return 2 * toy.of("a")[j]; });
        ASSERT_NEAR(toy.of("d")[i], c + toy.of("z")[i], 1e-12 * c) << i;
    }
}

// What a group before has left is there: the second group has its own term alone, and its providers neither run again nor are printed.
TEST(Groups, FindWhatThoseBeforeHaveLeft)
{
    Toy toy(torus(), chain(), {{"first", {"sum"}}, {"second", {"total"}}}, Fields<A, Z>{});
    toy.evaluate("first");
    toy.evaluate("second");
    toy.evaluate("second");
    EXPECT_EQ(toy.counts, (std::map<std::string, long>{{"first/twice", 1}, {"first/sum", 1}, {"second/total", 2}}));
    expectTotals(toy);
    std::ostringstream log;
    int pass = 0, operation = 0;
    toy.plan.printGroup(log, 1, pass, operation);
    EXPECT_EQ(operation, 1) << log.str();
}

// All that follows from a changed field is made anew, and nothing else: e follows from z.
TEST(Groups, MakeAnewWhatFollowsFromAChange)
{
    Toy toy(torus(), chain(), {{"first", {"sum", "otherSum"}}, {"second", {"total"}, {"a"}}}, Fields<A, Z>{});
    toy.evaluate("first");
    for (std::size_t i = 0; i < toy.n; ++i) toy.of("a")[i] = std::sin(7.0 * double(i));
    toy.evaluate("second");
    for (const char* term : {"twice", "sum", "total"}) EXPECT_EQ(toy.ran(std::string("second/") + term), 1) << term;
    EXPECT_EQ(toy.ran("second/otherSum"), 0);
    for (std::size_t i = 0; i < toy.n; ++i)
    {
        const double c = toy.sum(i, [&](std::size_t j) { return 2 * toy.of("a")[j]; });
        ASSERT_NEAR(toy.of("d")[i], c + toy.of("z")[i], 1e-12 * 2 * toy.kernel.W(0) * 21) << i;
    }
}

/// d_i = sum_j (b_j + 1000 z_j) W_ij
struct Mixed
{
    static constexpr auto name = "mixed";
    using Provides = D;
    using Reads = Fields<B, Z>;
    static constexpr bool readsKernel = true;
    double operator()(const auto& ij, const auto&, const auto& j) const { return (j.b + 1000 * j.z) * ij.W; }
};

// Images are refreshed where they are stale: of what has changed, and not of what has not. What is written to the images of z by hand between
// the groups is found there again; what is written to those of b is not.
TEST(Groups, RefreshStaleImagesAlone)
{
    Toy toy(torus(), catalogue<2, Twice, OtherSum, Sum, Mixed>(), {{"first", {"sum", "otherSum"}}, {"second", {"mixed"}, {"a"}}},
            Fields<A, Z>{});
    toy.evaluate("first");
    ASSERT_GT(toy.images.count(), 0u);
    for (std::size_t k = toy.n; k < toy.images.nullParticle(); ++k) toy.of("z")[k] = toy.of("b")[k] = 0;
    toy.evaluate("second");
    const std::size_t corner = 0; // at (0.05 0.05): more than half of its neighbours are images
    double expected = 0;
    for (std::size_t j = 0; j < toy.n; ++j)
        if (const double r = mag(positionOf(toy.store, corner) - positionOf(toy.store, j)); r < 0.25)
            expected += 1000 * toy.of("z")[j] * toy.kernel.W(r);
    expected += toy.sum(corner, [&](std::size_t j) { return 2 * toy.of("a")[j]; });
    EXPECT_NEAR(toy.of("d")[corner], expected, 1e-12 * expected);
    std::ostringstream log;
    int pass = 0, operation = 0;
    toy.plan.printGroup(log, 1, pass, operation);
    EXPECT_NE(log.str().find("images     positions b\n"), std::string::npos) << log.str();
}

/// c_i = sum_j a_j (dW_ij/dr)/r
struct SlopeOfA
{
    static constexpr auto name = "slopeOfA";
    using Provides = C;
    using Reads = Fields<A>;
    double operator()(const auto& ij, const auto&, const auto& j) const { return j.a * ij.dWdrOverR; }
};
/// d_i = sum_j c_j (dW_ij/dr) r
struct SlopeOfC
{
    static constexpr auto name = "slopeOfC";
    using Provides = D;
    using Reads = Fields<C>;
    double operator()(const auto& ij, const auto&, const auto& j) const { return j.c * ij.dWdrOverR * ij.rr; }
};
/// b_i = sum_j d_j (W_ij + (dW_ij/dr)/r)
struct SlopeOfD
{
    static constexpr auto name = "slopeOfD";
    using Provides = B;
    using Reads = Fields<D>;
    static constexpr bool readsKernel = true;
    double operator()(const auto& ij, const auto&, const auto& j) const { return j.d * (ij.W + ij.dWdrOverR); }
};

// Where at least two passes behind the first read gradW, the first keeps it, and says so; they find what they would have computed, a group that runs again behind
// one of another kernel too.
TEST(Groups, ReadTheSlopesThatTheFirstPassHasKept)
{
    Toy toy(torus(), catalogue<2, OtherSum, SlopeOfA, SlopeOfC, SlopeOfD>(),
            {{"first", {"slopeOfD"}},
             {.name = "wide", .terms = {"otherSum"}, .kernel = OwnKernel{"quinticSpline", 0.275}},
             {"again", {"slopeOfD"}, {"a"}}},
            Fields<A, Z>{});
    for (int run = 0; run < 2; ++run)
    {
        for (const char* group : {"first", "wide"}) toy.evaluate(group);
        for (std::size_t i = 0; i < toy.n; ++i) toy.of("a")[i] += 1;
        for (int repeated = 0; repeated < 2; ++repeated) toy.evaluate("again");
        const auto slope = [&](double r) { return toy.kernel.dWdrOverR(r); };
        for (std::size_t i = 0; i < toy.n; ++i)
        {
            const auto expect = [&](const char* field, double value)
            { EXPECT_NEAR(toy.of(field)[i], value, 1e-12 * std::fabs(value)) << field << " of " << i; };
            expect("c", toy.over(i, toy.kernel, [&](std::size_t j, double r) { return toy.of("a")[j] * slope(r); }));
            expect("d", toy.over(i, toy.kernel, [&](std::size_t j, double r) { return toy.of("c")[j] * slope(r) * sqr(r); }));
            expect("b", toy.over(i, toy.kernel, [&](std::size_t j, double r) { return toy.of("d")[j] * (toy.kernel.W(r) + slope(r)); }));
        }
    }
    std::ostringstream log;
    int pass = 0, operation = 0;
    toy.plan.printGroup(log, 0, pass, operation);
    const auto text = log.str(), keeps = std::string("keeps      neighbours (dW/dr)/r\n");
    EXPECT_LT(text.find(keeps), text.find("pass 2")) << text;
    EXPECT_EQ(text.find(keeps, text.find("pass 2")), std::string::npos) << text;
}

// One pass behind it is not worth eight bytes a pair.
TEST(Groups, KeepNeighboursAloneForOnePassMore)
{
    Toy toy(torus(), catalogue<2, SlopeOfA, SlopeOfC>(), {{"first", {"slopeOfC"}}}, Fields<A, Z>{});
    std::ostringstream log;
    toy.plan.print(log, toy.store);
    EXPECT_NE(log.str().find("keeps      neighbours\n"), std::string::npos) << log.str();
    toy.evaluate("first");
    const double value =
        toy.over(3, toy.kernel, [&](std::size_t j, double r) { return toy.of("c")[j] * toy.kernel.dWdrOverR(r) * sqr(r); });
    EXPECT_NEAR(toy.of("d")[3], value, 1e-12 * std::fabs(value));
}

/// c_i = sum_j (a_i - a_j) (dW_ij/dr)/r, whose sum over i is 0
struct DifferenceOfA
{
    static constexpr auto name = "differenceOfA";
    using Provides = C;
    using Reads = Fields<A>;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return (i.a - j.a) * ij.dWdrOverR; }
};
/// d_i = sum_j (c_i - c_j) (dW_ij/dr) r, likewise
struct DifferenceOfC
{
    static constexpr auto name = "differenceOfC";
    using Provides = D;
    using Reads = Fields<C>;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return (i.c - j.c) * ij.dWdrOverR * ij.rr; }
};
/// d_i = sum_j a_j W_ij, in either precision.
struct SmoothedA
{
    static constexpr auto name = "smoothedA";
    using Provides = D;
    using Reads = Fields<A>;
    static constexpr bool readsKernel = true;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto&, const auto& j) const { return j.a * ij.W; }
};

// A group that bears single precision sums what it would, to the round-off of floats, wherever the domain lies; what a pair exerts on one of its two
// particles and on the other cancels as doubles do, across the periods too.
TEST(Groups, BearSinglePrecision)
{
    for (const double place : {0., 1e5})
    {
        auto geometry = torus();
        for (auto* corner : {&geometry.low, &geometry.high}) *corner += Vector<3>{place, place, 0};
        const auto terms = catalogue<2, DifferenceOfA, DifferenceOfC>();
        Toy toy(geometry, terms,
                {{"first", {"differenceOfC"}},
                 {.name = "again", .terms = {"differenceOfC"}, .changed = {"a"}, .repeats = true, .bearsSingle = true}},
                Fields<A, Z>{});
        toy.evaluate("first");
        const auto slope = [&](double r) { return toy.kernel.dWdrOverR(r); };
        const auto differenceOfA = [&](std::size_t i)
        { return toy.over(i, toy.kernel, [&](std::size_t j, double r) { return (toy.of("a")[i] - toy.of("a")[j]) * slope(r); }); };
        const auto differenceOfC = [&](std::size_t i)
        { return toy.over(i, toy.kernel, [&](std::size_t j, double r) { return (toy.of("c")[i] - toy.of("c")[j]) * slope(r) * sqr(r); }); };
        for (std::size_t i = 0; i < toy.n; ++i) toy.of("a")[i] += 0.1 * std::sin(double(i));
        toy.evaluate("again");
        double sumOfC = 0, sumOfD = 0, scaleOfC = 0, scaleOfD = 0;
        Largest furthest;
        for (std::size_t i = 0; i < toy.n; ++i)
        {
            sumOfC += toy.of("c")[i];
            sumOfD += toy.of("d")[i];
            scaleOfC += std::fabs(toy.of("c")[i]);
            scaleOfD += std::fabs(toy.of("d")[i]);
            furthest(toy.of("c")[i] - differenceOfA(i));
        }
        EXPECT_LT(std::fabs(sumOfC), 1e-13 * scaleOfC);
        EXPECT_LT(std::fabs(sumOfD), 1e-13 * scaleOfD);
        const double roundOff = 1e-6 * scaleOfC / double(toy.n);
        EXPECT_LT(furthest.value(), 20 * roundOff);
        EXPECT_GT(furthest.value(), 1e-3 * roundOff) << "sums of doubles";
        for (std::size_t i = 0; i < toy.n; ++i) EXPECT_NEAR(toy.of("d")[i], differenceOfC(i), 20e-6 * scaleOfD / double(toy.n)) << i;
        std::ostringstream log;
        toy.plan.print(log, toy.store);
        EXPECT_NE(log.str().find("keeps      neighbours (dW/dr)/r in single precision\n"), std::string::npos) << log.str();
        EXPECT_NE(log.str().find("gathers    positions c in single precision\n"), std::string::npos) << log.str();
    }
}

// A pass that finds its neighbours and computes the kernel in single precision sums what the same pass in double does, to the round-off of floats; a term that does not bear it keeps
// its pass in double.
TEST(Groups, FindNeighboursInSinglePrecision)
{
    for (const bool bears : {true, false})
    {
        Toy toy(torus(), catalogue<2, DifferenceOfA, SmoothedA>(),
                {{.name = "first", .terms = {"differenceOfA", "smoothedA"}, .bearsSingle = bears}}, Fields<A, Z>{});
        toy.evaluate("first");
        Largest d, c, offOfD, offOfC;
        for (std::size_t i = 0; i < toy.n; ++i)
        {
            const double d_i = toy.over(i, toy.kernel, [&](std::size_t j, double r) { return toy.of("a")[j] * toy.kernel.W(r); });
            const double c_i =
                toy.over(i, toy.kernel,
                         [&](std::size_t j, double r) { return (toy.of("a")[i] - toy.of("a")[j]) * toy.kernel.dWdrOverR(r); });
            d(d_i);
            c(c_i);
            offOfD(toy.of("d")[i] - d_i);
            offOfC(toy.of("c")[i] - c_i);
        }
        EXPECT_LT(offOfD.value(), (bears ? 1e-6 : 1e-13) * d.value());
        EXPECT_LT(offOfC.value(), (bears ? 1e-5 : 1e-13) * c.value());
        EXPECT_TRUE(!bears || offOfD.value() > 1e-10 * d.value()) << "sums of doubles";
    }
    Toy mixed(torus(), catalogue<2, DifferenceOfA, OtherSum>(),
              {{.name = "first", .terms = {"differenceOfA", "otherSum"}, .bearsSingle = true}}, Fields<A, Z>{});
    std::ostringstream log;
    mixed.plan.print(log, mixed.store);
    EXPECT_EQ(log.str().find("single precision"), std::string::npos) << log.str();
}

/// The sum of SmoothedA, of which a particle with z_i > 0.5 says that it is 0.
struct SmoothedAWhereZIsSmall : SmoothedA
{
    static constexpr auto name = "smoothedAWhereZIsSmall";
    using ReadsOwn = Fields<Z>;
    bool isNothingAt(const auto& i) const { return i.z > 0.5; }
};

// A pass whose terms are 0 by a particle's own values does not look at the neighbours of that particle, has 0 there, and says so; a term that needs them at each particle keeps the pass
// at all of them.
TEST(Groups, LeaveOutParticlesThatAreNothingByThemselves)
{
    for (const bool alone : {true, false})
    {
        using Terms = std::vector<std::string>;
        const auto terms = catalogue<2, SmoothedAWhereZIsSmall, OtherSum>();
        Toy toy(torus(), terms, {{"first", alone ? Terms{"smoothedAWhereZIsSmall"} : Terms{"smoothedAWhereZIsSmall", "otherSum"}}},
                Fields<A, Z>{});
        for (std::size_t i = 0; i < toy.n; ++i) toy.of("z")[i] = i % 3 == 0 ? 1 : 0;
        toy.evaluate("first");
        for (std::size_t i = 0; i < toy.n; ++i)
        {
            const double all = toy.sum(i, [&](std::size_t j) { return toy.of("a")[j]; });
            if (alone && i % 3 == 0) EXPECT_EQ(toy.of("d")[i], 0) << i;
            else EXPECT_NEAR(toy.of("d")[i], all, 1e-12 * all) << i;
        }
        std::ostringstream log;
        toy.plan.print(log, toy.store);
        EXPECT_EQ(log.str().find("leaves out particles where all terms are 0 by their own values\n") != std::string::npos, alone)
            << log.str();
    }
}

// Who evaluates a group may mark particles whose sums are taken for 0: those of others are what they are without.
TEST(Groups, LeaveOutMarkedParticles)
{
    Toy toy(torus(), catalogue<2, SmoothedA, OtherSum>(), {{"first", {"smoothedA", "otherSum"}}}, Fields<A, Z>{});
    toy.evaluate("first");
    const std::vector<double> all(toy.of("d"), toy.of("d") + toy.n);
    std::vector<std::uint8_t> leftOut(toy.n, 0);
    for (std::size_t i = 0; i < toy.n; i += 3) leftOut[i] = 1;
    toy.plan.evaluate(toy.store, toy.images, toy.lists, toy.kernel, 0, 0, leftOut);
    for (std::size_t i = 0; i < toy.n; ++i) EXPECT_EQ(toy.of("d")[i], leftOut[i] ? 0 : all[i]) << i;
    EXPECT_GT(all[0], 0);
}

// A group with a kernel of its own sums over what that kernel reaches, farther than the scene's or less far, images too; groups behind it find the pairs of
// the scene's kernel as they were.
TEST(Groups, SeeNeighboursByAKernelOfTheirOwn)
{
    const OwnKernel wide{"quinticSpline", 0.275}, narrow{"wendlandC4", 0.15};
    Toy toy(torus(), catalogue<2, Twice, OtherSum, Sum, Mixed>(),
            {{"first", {"sum"}},
             {.name = "wide", .terms = {"otherSum"}, .kernel = wide},
             {.name = "narrow", .terms = {"mixed"}, .kernel = narrow},
             {"again", {"sum"}, {"a"}}},
            Fields<A, Z>{});
    for (const char* group : {"first", "wide", "narrow"}) toy.evaluate(group);
    for (std::size_t i = 0; i < toy.n; ++i) toy.of("a")[i] += 1;
    toy.evaluate("again");
    for (std::size_t i = 0; i < toy.n; ++i)
    {
        const auto expect = [&](const char* field, const OwnKernel& by, const auto& f)
        {
            const double value = toy.sum(i, f, Kernel<2>(by.name, by.support));
            EXPECT_NEAR(toy.of(field)[i], value, 1e-12 * value) << field << " of " << i;
        };
        expect("e", wide, [&](std::size_t j) { return toy.of("z")[j]; });
        expect("d", narrow, [&](std::size_t j) { return 2 * (toy.of("a")[j] - 1) + 1000 * toy.of("z")[j]; });
        expect("c", {"wendlandC2", 0.25}, [&](std::size_t j) { return 2 * toy.of("a")[j]; });
    }
    std::ostringstream log;
    int pass = 0, operation = 0;
    toy.plan.printGroup(log, 1, pass, operation);
    EXPECT_NE(log.str().find("pass 1 over pairs, quinticSpline of support 0.275 m"), std::string::npos) << log.str();
    toy.plan.printGroup(log, 3, pass, operation);
    EXPECT_EQ(log.str().find("wendlandC2"), std::string::npos) << log.str();
}

/// (d, e) = (a + z, a - z)
struct Both
{
    static constexpr auto name = "both";
    using Provides = Fields<D, E>;
    using ReadsOwn = Fields<A, Z>;
    auto operator()(const auto& i) const { return Values<Fields<D, E>, 2>{{i.a + i.z}, {i.a - i.z}}; }
};

/// b = d e
struct Product
{
    static constexpr auto name = "product";
    using Provides = B;
    using ReadsOwn = Fields<D, E>;
    double operator()(const auto& i) const { return i.d * i.e; }
};

// Who reads either result gets the one law that gives both; it runs once.
TEST(Groups, HaveLawsWithSeveralResults)
{
    Toy toy(torus(), catalogue<2, Both, Product>(), {{"only", {"product"}}}, Fields<A, Z>{});
    toy.evaluate("only");
    EXPECT_EQ(toy.ran("only/both"), 1);
    for (std::size_t i = 0; i < toy.n; ++i)
    {
        const double a = toy.of("a")[i], z = toy.of("z")[i];
        EXPECT_EQ(toy.of("d")[i], a + z);
        EXPECT_EQ(toy.of("e")[i], a - z);
        EXPECT_EQ(toy.of("b")[i], (a + z) * (a - z));
    }
}

/// da/dt = -k a, in substeps, each by the midpoint rule (1 - q/2)/(1 + q/2), q = k dt/n; k = 0 where z is negative.
struct Relaxation
{
    static constexpr auto name = "relaxation";
    using Advances = A;
    using ReadsOwn = Fields<A, Z>;
    double operator()(const auto& i, double deltaT) const
    {
        const int n = 1000;
        const double q = (i.z < 0 ? 0 : 3) * deltaT / n;
        double a = i.a;
        for (int k = 0; k < n; ++k) a *= (1 - q / 2) / (1 + q / 2);
        return a;
    }
};

// The step that a group is run with is the law's: a(t + dt) = a exp(-k dt) of each particle alone, within (k dt)^3/(12 n^2) by the rule. Twice half a
// step is one step; a step of 0 changes nothing.
TEST(Groups, HaveLawsThatAdvanceAState)
{
    Toy toy(torus(), catalogue<2, Twice, Sum, Relaxation>(), {{"first", {"sum"}}, {"relax", {"relaxation"}}}, Fields<A, Z>{});
    toy.of("z")[5] = -1;
    const std::vector<double> before(toy.of("a"), toy.of("a") + toy.n);
    toy.evaluate("first");
    toy.evaluate("relax", 0);
    EXPECT_EQ(std::vector<double>(toy.of("a"), toy.of("a") + toy.n), before);
    toy.evaluate("relax", 0.2);
    toy.evaluate("relax", 0.2);
    for (std::size_t i = 0; i < toy.n; ++i) EXPECT_NEAR(toy.of("a")[i], (i == 5 ? 1 : std::exp(-1.2)) * before[i], 1e-6 * before[i]) << i;
    EXPECT_EQ(toy.ran("relax/relaxation"), 3);
}

// What a law has advanced is a change for the groups behind it, which nobody has to name.
TEST(Groups, MakeAnewWhatFollowsFromAnAdvancedState)
{
    Toy toy(torus(), catalogue<2, Twice, Sum, Total, Relaxation>(), {{"first", {"sum"}}, {"relax", {"relaxation"}}, {"after", {"total"}}},
            Fields<A, Z>{});
    toy.evaluate("first");
    toy.evaluate("relax", 0.5);
    toy.evaluate("after");
    EXPECT_EQ(toy.ran("after/twice"), 1);
    expectTotals(toy);
}

/// -a d n of each wall within reach, d the distance and n the normal: Adds
struct Push
{
    static constexpr bool atWalls = true;
    static constexpr auto name = "push";
    using Adds = Acceleration;
    using ReadsOwn = Fields<A>;
    static double wallReach() { return Box::infinity; }
    auto operator()(auto dvdt, const auto& i, const auto& foot) const { return dvdt += -i.a * foot.distance * foot.normal; }
};
/// z = the number of walls within reach: Provides
struct Walls
{
    static constexpr bool atWalls = true;
    static constexpr auto name = "walls";
    using Provides = Z;
    static double wallReach() { return Box::infinity; }
    double operator()(double count, const auto&, const auto&) const { return count + 1; }
};
/// dv/dt = (1 0)
struct Wind
{
    static constexpr auto name = "wind";
    using Adds = Acceleration;
    using ReadsOwn = Fields<Z>;
    Vector<2> operator()(const auto&) const { return {1, 0}; }
};

// Between planes 0.3 apart, nearer than twice the reach of 0.28: a wall law that provides runs before what reads it, one that adds to a rate runs
// last, onto what is there.
TEST(Groups, HaveLawsAtWalls)
{
    Geometry g = domain(2, {1, 0.3, 0}, {true, false, false});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    addWall(g, Plane({0, 0.3, 0}, {0, -1, 0}));
    Toy toy(g, catalogue<2, Push, Walls, Wind, OtherSum>(), {{"only", {"push", "wind", "otherSum"}}}, Fields<A>{});
    toy.evaluate("only");
    ASSERT_EQ(toy.n, 30u);
    for (std::size_t i = 0; i < toy.n; ++i)
    {
        const double y = positionOf(toy.store, i).y;
        EXPECT_EQ(toy.of("z")[i], 2);
        EXPECT_EQ(toy.store.component("dUdt", 0)[i], 1);
        EXPECT_NEAR(toy.store.component("dUdt", 1)[i], -toy.of("a")[i] * (y - (0.3 - y)), 1e-14 * toy.of("a")[i]);
    }
    std::ostringstream log;
    int pass = 0, operation = 0;
    toy.plan.printGroup(log, 0, pass, operation);
    const auto text = log.str();
    for (const auto& [before, after] : {std::pair("walls  ", "wind  "), {"wind  ", "otherSum  "}, {"otherSum  ", "push  "}})
        EXPECT_LT(text.find(before), text.find(after)) << text;
}

// One equation for two scalars: the same term twice in one plan, each with fields of its own name.
TEST(Groups, HaveATermForEachOfSeveralFields)
{
    const auto make = [](const Coefficients&) { return Sum{}; };
    const Catalogue<2> terms{termEntry<2, Sum>("sum of salt", make, {{"b", "salt"}, {"c", "saltAround"}}),
                             termEntry<2, Sum>("sum of heat", make, {{"b", "heat"}, {"c", "heatAround"}})};
    const std::vector<std::string> names{"sum of salt", "sum of heat"};
    Plan<2> plan(terms, names, {"positions", "salt", "heat"});
    EXPECT_EQ(plan.pairPasses(), 1);
    EXPECT_TRUE(plan.provides("saltAround"));
    EXPECT_FALSE(plan.provides("c"));
    FieldStore<2> store;
    const auto g = torus();
    plan.allocate(store);
    for (const char* name : {"salt", "heat"}) store.allocateState(name, B::info, valueType<double>);
    std::vector<Vector<2>> points;
    for (int k = 0; k < 100; ++k) points.push_back({0.05 + 0.1 * (k / 10), 0.05 + 0.1 * (k % 10)});
    setPositions(store, points);
    for (std::size_t i = 0; i < 100; ++i)
    {
        store.component("salt", 0)[i] = 1;
        store.component("heat", 0)[i] = double(i % 10);
    }
    Images<2> images(g, 0.28, 0.1);
    images.build(store, 100);
    NeighbourLists<2> lists;
    lists.build(positions(store), 100, images.nullParticle(), 0.28);
    plan.bind(store, {});
    const Kernel<2> kernel("wendlandC2", 0.25);
    plan.evaluate(store, images, lists, kernel);
    EXPECT_EQ(store.has("c"), false);
    for (std::size_t i = 0; i < 100; ++i)
    {
        double salt = 0, heat = 0;
        for (std::size_t j = 0; j < 100; ++j)
        {
            auto x = points[i] - points[j];
            x.x -= std::round(x.x);
            x.y -= std::round(x.y);
            if (mag(x) >= 0.25) continue;
            salt += kernel.W(mag(x));
            heat += double(j % 10) * kernel.W(mag(x));
        }
        ASSERT_NEAR(store.component("saltAround", 0)[i], salt, 1e-12 * salt);
        ASSERT_NEAR(store.component("heatAround", 0)[i], heat, 1e-12 * heat);
    }
}

std::string errorOf(const std::vector<Group>& groups, const std::set<std::string>& state, const Catalogue<2>& terms = chain(),
                    const std::map<std::string, std::vector<FieldUse<2>>>& rules = {})
{
    try
    {
        Plan<2>(terms, groups, state, rules);
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

TEST(Groups, NameTheReaderOfAFieldThatNobodyGives)
{
    EXPECT_EQ(errorOf({{"first", {"sum"}}, {"second", {"total"}}}, {"positions", "a"}),
              "term \"total\" reads \"z\" [1], which the scene does not give and no term provides");
    // Two scalars under names of their own: the reader is called by its own name, too.
    const Catalogue<2> renamed{termEntry<2, Sum>("sum of salt", [](const Coefficients&) { return Sum{}; }, {{"b", "salt"}})};
    EXPECT_EQ(errorOf({{"first", {"sum of salt"}}}, {"positions"}, renamed),
              "term \"sum of salt\" reads \"salt\" [1], which the scene does not give and no term provides");
}

// Ghosts continue the pressure with the density of their sources: who reads the pressure at neighbours reads the density, too.
TEST(Groups, CountWhatTheRuleOfAnImageReadsAsRead)
{
    const auto rules = std::map<std::string, std::vector<FieldUse<2>>>{{"p", uses<2>(Fields<Density>{})}};
    const std::vector<Group> pressure{{"evaluate", {"huAdamsPressure"}}};
    EXPECT_EQ(errorOf(pressure, {"positions", "p", "V", "m"}, allTerms<2>()), "");
    EXPECT_EQ(errorOf(pressure, {"positions", "p", "V"}, allTerms<2>(), rules).substr(0, 44),
              "term \"huAdamsPressure\" reads \"m\" [kg], which");
    Catalogue<2> pressureAlone;
    for (const auto& term : allTerms<2>())
        if (term.name == "huAdamsPressure") pressureAlone.push_back(term);
    EXPECT_EQ(errorOf(pressure, {"positions", "p", "V", "m"}, pressureAlone, rules),
              "term \"huAdamsPressure\" reads \"rho\" [kg/m^3], which the scene does not give and no term provides");

    // Its provider is added, and runs before.
    const Plan<2> plan(allTerms<2>(), pressure, {"positions", "p", "V", "m"}, rules);
    EXPECT_TRUE(plan.has("summedDensity"));
    std::ostringstream log;
    int pass = 0, operation = 0;
    plan.printGroup(log, 0, pass, operation);
    EXPECT_NE(log.str().find("(rho for huAdamsPressure)"), std::string::npos) << log.str();
    EXPECT_LT(log.str().find("summedDensity"), log.str().find("huAdamsPressure ")) << log.str();
}

}
}
