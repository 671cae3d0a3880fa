/// What openings hold, let in and take away, and the account of it.
#include "models/openings/Openings.hpp"
#include "Duct.hpp"
#include "Largest.hpp"
#include "base/CaseError.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

namespace sph::test
{
namespace
{

constexpr double dx = 0.1, H = 0.25, depth = 2 * H + dx;

Coefficients coefficients()
{
    Coefficients c;
    c.dimension = 2;
    c.spacing = dx;
    c.support = H;
    c.restDensity = {2};
    return c;
}

/// Positions, velocities, masses and powder, which is counted and migrates in steps of its own.
State stateOfPowder()
{
    Evolving powder{stateField(PowderFraction{}), stateField(PowderRate{})};
    powder.advancedByModel = true;
    powder.amount = "Powder";
    return {{stateField(Position{})}, {stateField(Velocity{}), stateField(Acceleration{})}, {stateField(Mass{})}, powder};
}
/// An inlet through which particles of that mass come in.
Opening gateOf(double phi)
{
    auto gate = inlet();
    gate.stream.values = {{"m", coefficients().restDensity[0] * dx * dx}, {"phi", phi}};
    return gate;
}

struct Scene
{
    Coefficients c = coefficients();
    Geometry geometry = channel(1);
    State evolving = stateOfPowder();
    FieldStore<2> store;
    std::size_t owned = 0;

    Scene()
    {
        const auto state = [&](auto... tags) { (store.allocateState(tags), ...); };
        state(Position{}, Velocity{}, Mass{}, PowderFraction{}, Holder{});
        store.allocate(HeldPressure{});
        store.allocate(Pressure{});
        store.allocate(Acceleration{});
        store.allocate(PowderRate{});
        store.resize(0);
    }
    void exchange(Openings<2>& openings)
    {
        owned = openings.exchange(store, owned);
        openings.locate(store, owned);
    }
    /// Moves all by their velocities.
    void drift(double deltaT)
    {
        for (int k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < owned; ++i) store.component("positions", k)[i] += deltaT * store.component("U", k)[i];
    }
    /// A square lattice with velocity (u 0) between two x.
    void fill(double from, double to, double u, double phi)
    {
        for (double x = from + dx / 2; x < to; x += dx)
            for (double y = dx / 2; y < 1; y += dx)
            {
                store.resize(owned + 1);
                store.component("positions", 0)[owned] = x;
                store.component("positions", 1)[owned] = y;
                store.component("U", 0)[owned] = u;
                store.component("m", 0)[owned] = c.restDensity[0] * dx * dx;
                store.component("phi", 0)[owned++] = phi;
            }
    }
    double freeMass()
    {
        double sum = 0;
        for (std::size_t i = 0; i < owned; ++i)
            if (store.component("heldBy", 0)[i] == 0) sum += store.component("m", 0)[i];
        return sum;
    }
};

Opening outlet(double pressure)
{
    Opening opening;
    opening.name = "vent";
    opening.inlet = false;
    opening.point = {1, 0, 0};
    opening.normal = {-1, 0, 0};
    opening.pressure = pressure;
    return opening;
}

TEST(Openings, FillAnEmptyDuctAndLetInWhatTheyAreTold)
{
    Scene scene;
    auto gate = gateOf(0.3);
    gate.velocity = 0.5;
    Openings<2> openings({gate}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    ASSERT_EQ(scene.owned, 60u); // six rows of ten
    EXPECT_EQ(openings.held().size(), 60u);
    EXPECT_EQ(scene.freeMass(), 0);
    for (std::size_t i = 0; i < scene.owned; ++i)
    {
        EXPECT_LT(scene.store.component("positions", 0)[i], 0);
        EXPECT_EQ(scene.store.component("U", 0)[i], 0.5);
        EXPECT_EQ(scene.store.component("phi", 0)[i], 0.3);
    }
    double time = 0;
    for (int step = 0; step < 200; ++step)
    {
        scene.drift(0.01);
        time += 0.01;
        scene.exchange(openings);
        openings.drive(scene.store, 0.01);
    }
    // rho U A t, to within a row
    EXPECT_NEAR(scene.freeMass(), 2 * 0.5 * time, 2 * dx);
    const auto flow = openings.flows().at(0);
    EXPECT_NEAR(flow.mass.at(0), scene.freeMass(), 1e-13);
    EXPECT_NEAR(flow.amounts.at(0), 0.3 * scene.freeMass() / 2, 1e-13);
    EXPECT_NEAR(flow.flowRate, 0.5, 1e-12);
    EXPECT_LT(std::abs(openings.imbalance(scene.store).mass.at(0)), 1e-14);
    EXPECT_LT(std::abs(openings.imbalance(scene.store).amounts.at(0)), 1e-13);
}

TEST(Openings, TakeAwayWhatHasLeft)
{
    Scene scene;
    scene.fill(0, 1, 1, 0.2);
    Openings<2> openings({outlet(0)}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    for (int step = 0; step < 50; ++step)
    {
        scene.drift(0.01);
        scene.exchange(openings);
        openings.drive(scene.store, 0.01);
    }
    EXPECT_NEAR(scene.freeMass(), 2 * 0.5, 1e-12);
    EXPECT_NEAR(openings.flows().at(0).mass.at(0), -2 * 0.5, 1e-12);
    EXPECT_EQ(openings.held().size(), 50u); // none is further than the outlet reaches yet
    for (int step = 0; step < 30; ++step)
    {
        scene.drift(0.01);
        scene.exchange(openings);
        openings.drive(scene.store, 0.01);
    }
    EXPECT_EQ(scene.owned, 20u + 60u);
    EXPECT_LT(std::abs(openings.imbalance(scene.store).mass.at(0)), 1e-14);
    EXPECT_LT(std::abs(openings.imbalance(scene.store).amounts.at(0)), 1e-14);
}

// A particle that passes a plane is free, or held, at once, whenever lists are rebuilt: every step, or every seventh, with a row passing every twentieth.
TEST(Openings, LetPassAtTheMomentOfPassing)
{
    struct Duct
    {
        Scene scene;
        std::vector<Opening> both = []
        {
            auto gate = gateOf(0.3);
            gate.velocity = 0.5;
            return std::vector{gate, outlet(0)};
        }();
        Openings<2> openings{both, scene.geometry, scene.c, scene.evolving, {}};
        Duct()
        {
            scene.fill(0, 1, 0.5, 0.2);
            scene.exchange(openings);
        }
        void step(bool sorts)
        {
            scene.drift(0.01);
            if (sorts) scene.exchange(openings);
            else openings.follow(scene.store, false);
            openings.drive(scene.store, 0.01);
        }
        std::multiset<double> free()
        {
            std::multiset<double> x;
            for (std::size_t i = 0; i < scene.owned; ++i)
                if (scene.store.component("heldBy", 0)[i] == 0) x.insert(scene.store.component("positions", 0)[i]);
            return x;
        }
    };
    Duct always, seldom;
    for (int step = 1; step <= 100; ++step)
    {
        always.step(true);
        seldom.step(step % 7 == 0);
        EXPECT_EQ(always.free(), seldom.free()) << "step " << step;
        for (int k = 0; k < 2; ++k)
        {
            const auto a = always.openings.flows().at(std::size_t(k)), b = seldom.openings.flows().at(std::size_t(k));
            EXPECT_NEAR(a.mass.at(0), b.mass.at(0), 1e-15);
            EXPECT_NEAR(a.amounts.at(0), b.amounts.at(0), 1e-15);
            EXPECT_NEAR(a.flowRate, b.flowRate, 1e-14);
        }
    }
    EXPECT_GT(always.openings.flows().at(0).mass.at(0), 0.8);
    EXPECT_LT(always.openings.flows().at(1).mass.at(0), -0.8);
}

// A domain that goes on beyond what is held: the rest of the duct is emptied at the start, which counts as taken away and not as passed.
TEST(Openings, EmptyTheDuctFarBeyond)
{
    Scene scene;
    scene.fill(-3, 4, 0, 0);
    Openings<2> openings({gateOf(0), outlet(0)}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    EXPECT_EQ(scene.owned, 220u); // ten rows, and six beyond each plane
    EXPECT_EQ(openings.held().size(), 120u);
    EXPECT_EQ(openings.flows().at(1).mass.at(0), 0);
    EXPECT_NEAR(openings.flows().at(0).taken.at(0), 2 * (3 - depth), 1e-12);
    EXPECT_NEAR(openings.flows().at(1).taken.at(0), 2 * (3 - depth), 1e-12);
    EXPECT_LT(std::abs(openings.imbalance(scene.store).mass.at(0)), 1e-15);
    // A restart knows it, and a particle that is lost shows.
    Openings<2> restarted({gateOf(0), outlet(0)}, scene.geometry, scene.c, scene.evolving, openings.state());
    EXPECT_EQ(restarted.flows().at(0).taken.at(0), openings.flows().at(0).taken.at(0));
    EXPECT_EQ(restarted.imbalance(scene.store).mass.at(0), openings.imbalance(scene.store).mass.at(0));
    const double *holder = scene.store.component("heldBy", 0), particle = 2 * dx * dx;
    scene.store.component("m", 0)[std::find(holder, holder + scene.owned, 0) - holder] = 0;
    EXPECT_NEAR(openings.imbalance(scene.store).mass.at(0), -particle / (2 * (7 - 2 * depth)), 1e-15);
}

// A stream that fills three tenths of a drain in lumps: its flow is that of what is there and not of the whole section, and over the time that lumps take to pass
// what has passed, to the rule by which steps are summed.
TEST(Openings, MeasureTheFlowOfAStreamThatFillsThemInPart)
{
    Scene scene;
    for (const double from : {0.0, 0.3}) scene.fill(from, from + 0.2, 1, 0);
    for (std::size_t i = 0; i < scene.owned; ++i)
        if (scene.store.component("positions", 1)[i] > 0.3) scene.store.component("m", 0)[i] = 0;
    Openings<2> openings({outlet(0)}, scene.geometry, scene.c, scene.evolving, {}, 2, true);
    scene.exchange(openings);
    double volume = 0;
    Largest largest;
    for (int step = 0; step < 1100; ++step)
    {
        scene.drift(0.001);
        scene.exchange(openings);
        openings.drive(scene.store, 0.001);
        const auto flow = openings.flows().at(0);
        EXPECT_NEAR(flow.flowRate, flow.flowRates.at(0), 1e-15);
        volume += 0.001 * flow.flowRate;
        largest(flow.flowRate);
    }
    EXPECT_NEAR(openings.flows().at(0).mass.at(0), -2 * 0.3 * 0.4, 1e-12);
    EXPECT_NEAR(volume, -0.3 * 0.4, 1e-4 * 0.3 * 0.4);
    EXPECT_LT(largest.value(), 1.05 * 0.3);
}

void refuses(const Opening& opening, const Geometry& geometry, const std::string& word)
{
    try
    {
        Openings<2>({opening}, geometry, coefficients(), stateOfPowder(), {});
        FAIL() << "no error with " << word;
    }
    catch (const CaseError& e)
    {
        EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
    }
}

// Normals to the wrong side: beyond the one opening lies the other, and the end of the domain is nearer than what would be held reaches.
TEST(Openings, PointIntoTheScene)
{
    auto gate = gateOf(0);
    gate.normal = {-1, 0, 0};
    const auto refused = [&](const std::vector<Opening>& openings, double x, const std::string& word)
    {
        Scene scene;
        scene.geometry.low.x = x;
        try
        {
            Openings<2>(openings, scene.geometry, scene.c, scene.evolving, {});
            ADD_FAILURE() << word;
        }
        catch (const CaseError& e)
        {
            EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    auto far = outlet(0);
    far.point.x = 1.4;
    refused({gate, far}, -1, "has \"vent\" beyond its plane");
    refused({gate}, -0.4, "has 0.4 m of scene before its plane, less than the 0.6 m that it holds beyond");
}

// A gate in a runner between the end of a mould and that of the domain: pointed out of the mould it has as much scene before it as it holds, and is refused all the same; so is one at
// whose rear the domain cuts the runner shorter than what is held reaches, by less than a spacing.
TEST(Openings, PointOutOfARunner)
{
    const auto mould = [](double runner)
    {
        auto geometry = duct(
            "dimension 2; domain { min (-1 0 0); max (2 1 0); } walls { low { type plane; point (0 0 0); normal (0 1 0); } high { type "
            "plane; point (0 1 0); normal (0 -1 0); } end { type plane; point (1.9 0 0); normal (-1 0 0); } }");
        geometry.low.x = -runner;
        return geometry;
    };
    auto gate = gateOf(0);
    EXPECT_EQ(Openings<2>({gate}, mould(1), coefficients(), stateOfPowder(), {}).flows().size(), 1u);
    refuses(gate, mould(depth - H - 0.05),
            "needs 0.35 m of domain beyond its plane, for the particles that are held there: the domain of "
            "constant/geometry, (-0.3 0 0) to (2 1 1), ends before");
    gate.normal = {-1, 0, 0};
    refuses(gate, mould(1),
            "has the normal (-1 0 0), which points out of the scene: before the plane a straight duct leads out of the domain, and "
            "beyond it none does. It must point into the scene: (1 0 0)");
}

// Density of buffer particles, where density is integrated, by Tait's law for the held pressure: rho = rho_0 (1 + p/B)^(1/n).
TEST(Openings, HoldTheDensityOfTheirPressure)
{
    Scene scene;
    scene.store.allocateState(Density{});
    scene.evolving.push_back({stateField(Density{}), stateField(DensityRate{})});
    scene.c.stateEquation = {{2, 40, 7}};
    scene.fill(-0.6, 1.6, 1, 0);
    Openings<2> openings({outlet(5)}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    const double expected = 2 * std::pow(1 + 5 / 40.0, 1 / 7.0);
    EXPECT_EQ(openings.held().size(), 60u);
    for (const int i : openings.held()) EXPECT_NEAR(scene.store.component("rho", 0)[i], expected, 1e-12);
}

// Particles beyond the planes continue a linear pressure, and the outlet's own pressure is that at its plane.
TEST(Openings, ContinueThePressure)
{
    Scene scene;
    scene.fill(-0.6, 1.6, 1, 0);
    Openings<2> openings({gateOf(0), outlet(5)}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    const auto pressureAt = [](double x) { return 5 + 8 * (1 - x); };
    for (std::size_t i = 0; i < scene.owned; ++i) scene.store.component("p", 0)[i] = pressureAt(scene.store.component("positions", 0)[i]);
    openings.drive(scene.store, 0.01);
    EXPECT_EQ(openings.held().size(), 120u);
    for (const int i : openings.held())
        EXPECT_NEAR(scene.store.component("heldPressure", 0)[i], pressureAt(scene.store.component("positions", 0)[i]), 1e-12);
    EXPECT_NEAR(openings.flows().at(0).pressure, 13, 1e-12);
    EXPECT_NEAR(openings.flows().at(1).flowRate, -1, 1e-12);
}

// dU/dt = (p_in - a)/(rho l), never beyond the given velocity, never backwards.
TEST(Openings, AreDrivenByPressure)
{
    Scene scene;
    auto gate = gateOf(0);
    gate.velocity = 0.4;
    gate.pressure = 6;
    Openings<2> openings({gate}, scene.geometry, scene.c, scene.evolving, {});
    scene.fill(0, 1, 0, 0);
    scene.exchange(openings);
    const auto speed = [&] { return openings.flows().at(0).flowRate; };
    EXPECT_EQ(speed(), 0);
    openings.drive(scene.store, 0.01);
    EXPECT_NEAR(speed(), 0.01 * 6 / (2 * depth), 1e-12);
    for (int step = 0; step < 100; ++step) openings.drive(scene.store, 0.01);
    EXPECT_NEAR(speed(), 0.4, 1e-12);
    std::fill_n(scene.store.component("p", 0), scene.owned, 10.0);
    openings.drive(scene.store, 0.06);
    EXPECT_NEAR(speed(), 0.4 - 0.06 * 4 / (2 * depth), 1e-9);
    for (int step = 0; step < 100; ++step) openings.drive(scene.store, 0.01);
    EXPECT_EQ(speed(), 0);
}

TEST(Openings, HoldWhatIsBeyondThem)
{
    Scene scene;
    scene.fill(-0.6, 1, 0, 0);
    Openings<2> openings({gateOf(0)}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    for (double* a : scene.store.pointers(Acceleration{})) std::fill_n(a, scene.owned, 3.0);
    openings.hold(scene.store);
    for (std::size_t i = 0; i < scene.owned; ++i)
        EXPECT_EQ(scene.store.component("dUdt", 0)[i], scene.store.component("positions", 0)[i] < 0 ? 0 : 3);
}

TEST(Openings, GoOnFromTheNumbersOfTheirState)
{
    Scene scene;
    scene.fill(0, 1, 0, 0.25);
    const auto gate = gateOf(0.3);
    Openings<2> first({gate}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(first);
    std::fill_n(scene.store.component("dphidt", 0), scene.owned, 0.02);
    first.withholdRate(scene.store, "phi", 0.5);
    EXPECT_NEAR(first.state().at("openingsHeldPowder"), double(first.held().size()) * 0.01 * dx * dx, 1e-15);
    for (std::size_t i = 0; i < scene.owned; ++i)
        EXPECT_EQ(scene.store.component("dphidt", 0)[i], scene.store.component("positions", 0)[i] < 0 ? 0 : 0.02);
    scene.drift(0.3);
    scene.exchange(first);
    Openings<2> second({gate}, scene.geometry, scene.c, scene.evolving, first.state());
    std::fill_n(scene.store.component("heldBy", 0), scene.owned, 0.0); // is not on disk
    scene.exchange(second);
    EXPECT_GT(first.flows().at(0).mass.at(0), 0);
    EXPECT_EQ(second.flows().at(0).mass.at(0), first.flows().at(0).mass.at(0));
    EXPECT_EQ(second.imbalance(scene.store).mass.at(0), first.imbalance(scene.store).mass.at(0));
    EXPECT_EQ(second.state(), first.state());
}

/// Water of density 2 and gas of density 0.5, the water below.
struct TwoPhases : Scene
{
    TwoPhases()
    {
        c.phases = {"water", "gas"};
        c.restDensity = {2, 0.5};
        evolving.push_back({stateField(Phase{})});
        evolving.push_back({stateField(EntryTime{})});
        store.allocateState(Phase{});
        store.allocateState(EntryTime{});
        store.resize(0);
    }
    Stream streamOf(std::size_t phase) const
    {
        return {phase, {{"m", c.restDensity[phase] * dx * dx}, {"phi", 0}, {"phase", double(phase)}}};
    }
    void fillWithBoth(double from, double to, double u)
    {
        const auto first = owned;
        fill(from, to, u, 0);
        for (std::size_t i = first; i < owned; ++i)
        {
            const auto phase = std::size_t(store.component("positions", 1)[i] > 0.5);
            for (const auto& [field, value] : streamOf(phase).values) store.component(field, 0)[i] = value;
            store.component("enteredAt", 0)[i] = EntryTime::notMarked;
        }
    }
    Opening gateOfBoth() const
    {
        auto gate = inlet();
        gate.velocity = 0.5;
        gate.stream = streamOf(0);
        gate.layers = {{{{-9, 0.5, -9}, {9, 9, 9}}, streamOf(1)}};
        return gate;
    }
};

// Round-off aside, by counts: what of each phase is there, has come in and has left.
TEST(Openings, LetInPhasesByLayers)
{
    TwoPhases scene;
    scene.fillWithBoth(0, 1, 0.5);
    Openings<2> openings({scene.gateOfBoth(), outlet(0)}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    for (int step = 0; step < 200; ++step)
    {
        scene.drift(0.01);
        if (step % 7 == 0) scene.exchange(openings);
        else openings.follow(scene.store, false);
        openings.drive(scene.store, 0.01, 0.01 * (step + 1));
        for (std::size_t i = 0; i < scene.owned; ++i)
            ASSERT_EQ(scene.store.component("phase", 0)[i], scene.store.component("positions", 1)[i] > 0.5 ? 1 : 0);
    }
    const auto gate = openings.flows().at(0), vent = openings.flows().at(1);
    EXPECT_NEAR(gate.mass.at(0), 2 * 0.5, 0.5 * 2 * dx); // rho U t by half of the width, to a row
    EXPECT_NEAR(gate.mass.at(1), 0.5 * 0.5, 0.5 * 0.5 * dx);
    EXPECT_NEAR(gate.mass.at(0), -vent.mass.at(0), 1e-12);
    EXPECT_NEAR(gate.mass.at(1), -vent.mass.at(1), 1e-12);
    EXPECT_NEAR(gate.flowRates.at(0), 0.25, 1e-12);
    EXPECT_NEAR(vent.flowRates.at(1), -0.25, 1e-12);
    for (const double off : openings.imbalance(scene.store).mass) EXPECT_LT(std::abs(off), 1e-14);
    EXPECT_NEAR(openings.account().volume(), 0, 1e-14);

    // The state survives a restart.
    Openings<2> second({scene.gateOfBoth(), outlet(0)}, scene.geometry, scene.c, scene.evolving, openings.state());
    scene.exchange(second);
    EXPECT_EQ(second.state(), openings.state());
}

// Plug flow: all that is marked takes L/U from plane to plane, to a step; what was there before, and came in before, does not count.
TEST(Openings, TellHowLongWhatTheyMarkTakes)
{
    TwoPhases scene;
    scene.fillWithBoth(0, 1, 0.5);
    auto gate = scene.gateOfBoth();
    gate.markFrom = 0.5;
    Openings<2> openings({gate, outlet(0)}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    const double deltaT = 0.01;
    const auto run = [&](int from, int to)
    {
        for (int step = from; step < to; ++step)
        {
            scene.drift(deltaT);
            if (step % 7 == 0) scene.exchange(openings);
            else openings.follow(scene.store, false);
            openings.drive(scene.store, deltaT, deltaT * (step + 1));
        }
    };
    run(0, 245);
    EXPECT_EQ(openings.flows().at(1).marked->mass, 0);
    run(245, 400);
    const auto marked = openings.flows().at(1).marked.value();
    EXPECT_NEAR(openings.flows().at(0).marked->mass, (2 + 0.5) * 0.5 * 0.5 * 3.5, 2 * 2.5 * 0.5 * dx);
    EXPECT_NEAR(marked.mass, (2 + 0.5) * 0.5 * 0.5 * 1.5, 2 * 2.5 * 0.5 * dx);
    EXPECT_NEAR(marked.mean(), 1 / 0.5, deltaT);
    EXPECT_LT(marked.deviation(), deltaT);
}

// p = 5 + 8 (1 - x) in water, 5 + 3 (1 - x) in gas: each held particle continues that of its phase.
TEST(Openings, ContinueThePressureOfEachPhase)
{
    TwoPhases scene;
    scene.fillWithBoth(-0.6, 1.6, 0.5);
    Openings<2> openings({scene.gateOfBoth(), outlet(5)}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    const auto pressureAt = [&](std::size_t i)
    { return 5 + (scene.store.component("phase", 0)[i] > 0 ? 3 : 8) * (1 - scene.store.component("positions", 0)[i]); };
    for (std::size_t i = 0; i < scene.owned; ++i) scene.store.component("p", 0)[i] = pressureAt(i);
    openings.drive(scene.store, 0.01);
    EXPECT_EQ(openings.held().size(), 120u);
    for (const int i : openings.held()) EXPECT_NEAR(scene.store.component("heldPressure", 0)[i], pressureAt(std::size_t(i)), 1e-12);
}

// Gas is drawn in through the upper half of an outlet while water leaves through the lower one; then the flow of the water turns too: it stands.
TEST(Openings, LetComeBackWhatMay)
{
    TwoPhases scene;
    scene.fillWithBoth(0, 1.6, 0.5);
    auto vent = outlet(0);
    vent.backflow = true;
    vent.stream = scene.streamOf(1);
    Openings<2> openings({vent}, scene.geometry, scene.c, scene.evolving, {});
    scene.exchange(openings);
    const auto flowAt = [&](double ofWater, double ofGas)
    {
        for (std::size_t i = 0; i < scene.owned; ++i)
            if (scene.store.component("heldBy", 0)[i] == 0)
                scene.store.component("U", 0)[i] = scene.store.component("phase", 0)[i] > 0 ? ofGas : ofWater;
    };
    for (int step = 0; step < 54; ++step)
    {
        flowAt(0.5, -0.5);
        openings.drive(scene.store, 0.01);
        scene.drift(0.01);
        scene.exchange(openings);
    }
    const double half = 3 * dx * 0.5; // three rows have passed either way
    EXPECT_NEAR(openings.flows().at(0).mass.at(0), -2 * half, 1e-12);
    EXPECT_NEAR(openings.flows().at(0).mass.at(1), 0.5 * half, 1e-12);
    EXPECT_NEAR(openings.account().volume(), 0, 1e-13);
    for (const double off : openings.imbalance(scene.store).mass) EXPECT_LT(std::abs(off), 1e-13);
    EXPECT_EQ(openings.held().size(), 60u); // filled up from behind
    for (const int i : openings.held())
        EXPECT_EQ(scene.store.component("phase", 0)[i], scene.store.component("positions", 1)[i] > 0.5 ? 1 : 0);
    EXPECT_NEAR(openings.flows().at(0).pressure, -0.5 * 0.5 * sqr(0.5), 1e-12); // what it has cost to come in
    flowAt(-0.5, -0.5);
    openings.drive(scene.store, 0.01);
    for (const int i : openings.held()) EXPECT_EQ(scene.store.component("U", 0)[i], scene.store.component("phase", 0)[i] > 0 ? -0.5 : 0);
    // Gas comes along all lines: what is held of the water is gone.
    for (std::size_t i = 0; i < scene.owned; ++i)
        if (scene.store.component("heldBy", 0)[i] == 0) scene.store.component("phase", 0)[i] = 1;
    openings.drive(scene.store, 0.01);
    openings.follow(scene.store, false);
    for (const int i : openings.held())
    {
        EXPECT_EQ(scene.store.component("phase", 0)[i], 1);
        EXPECT_EQ(scene.store.component("m", 0)[i], 0.5 * dx * dx);
    }
}

// A strip of water in a plane that is open to gas: each holds its part, and their areas make up the plane's.
TEST(Openings, CutADripOutOfAnOpenPlane)
{
    TwoPhases scene;
    scene.fillWithBoth(0, 2, 0);
    auto drip = scene.gateOfBoth();
    drip.name = "drip1";
    drip.layers.clear();
    drip.point = {0, 0.5, 0};
    drip.radius = 0.2;
    auto sky = outlet(0);
    sky.point = {0, 0, 0};
    sky.normal = {1, 0, 0};
    sky.backflow = true;
    sky.stream = scene.streamOf(1);
    sky.without = {drip};
    Openings<2> openings({sky, drip}, scene.geometry, scene.c, scene.evolving, {});
    scene.fillWithBoth(-0.6, 0, 0);
    scene.exchange(openings);
    EXPECT_NEAR(openings.flows().at(0).area, 0.6, 1e-9);
    EXPECT_NEAR(openings.flows().at(1).area, 0.4, 1e-9);
    EXPECT_EQ(openings.flows().at(0).held, 36u);
    EXPECT_EQ(openings.flows().at(1).held, 24u);
    for (const int i : openings.held())
    {
        const bool inside = std::abs(scene.store.component("positions", 1)[i] - 0.5) < 0.2;
        EXPECT_EQ(scene.store.component("heldBy", 0)[i], inside ? 2 : 1);
        EXPECT_EQ(scene.store.component("phase", 0)[i], inside || scene.store.component("positions", 1)[i] < 0.5 ? 0 : 1);
    }
}

// A round drip in three dimensions: its lines lie within the radius, and as many particles come in as its area says.
TEST(Openings, DripRoundInThreeDimensions)
{
    auto drip = inlet();
    drip.point = {0, 0.5, 0.5};
    drip.radius = 0.3;
    const Section section(drip, squareDuct(), 0.1);
    EXPECT_NEAR(section.area(), std::numbers::pi * 0.09, 0.01 * std::numbers::pi * 0.09);
    for (const auto& line : section.lines()) EXPECT_LT(mag(line.foot - drip.point), 0.3);
    EXPECT_NEAR(section.rowSpacing() * section.area() / double(section.lines().size()), 1e-3, 1e-15);
    auto sky = outlet(0);
    sky.without = {drip};
    EXPECT_FALSE(sky.opensAt({0, 0.5, 0.6}, 3));
    EXPECT_TRUE(sky.opensAt({0, 0.9, 0.9}, 3));
}

// An inlet over a part of a duct that is packed on both sides of the plane, at any offset from that lattice: the rate asked for within 1 %, 200 rows and what one of
// them, which may have passed or not, is of it. A part that was open to a spacing beside its edges let in 10 to 40 % more, packed rows 0 to 20 %.
TEST(Openings, LetInTheRateAskedFor)
{
    for (const double offset : {0.0, 0.03, 0.05, 0.08})
        for (const double width : {0.3, 0.43, 0.55})
        {
            SCOPED_TRACE(std::to_string(offset) + " " + std::to_string(width));
            Scene scene;
            auto gate = gateOf(0);
            gate.velocity = 0.5;
            gate.extent.low.y = 0.2 + offset;
            gate.extent.high.y = gate.extent.low.y + width;
            Openings<2> openings({gate}, scene.geometry, scene.c, scene.evolving, {});
            scene.fill(-0.6 + offset, 1, 0.5, 0);
            scene.exchange(openings);
            const double deltaT = 0.04, time = 200 * dx / 0.5;
            for (int step = 0; step < std::lround(time / deltaT); ++step)
            {
                scene.drift(deltaT);
                scene.exchange(openings);
                openings.drive(scene.store, deltaT);
            }
            const auto flow = openings.flows().at(0);
            EXPECT_NEAR(flow.asked.value(), 0.5 * width, 1e-9);
            EXPECT_NEAR(flow.flowRate, 0.5 * width, 1e-9);
            EXPECT_NEAR(flow.mass.at(0) / (2 * time) / flow.asked.value(), 1, 0.01);
        }
}

/// sum_j W(|x_i - x_j|) dx^2, Wendland C2 of support H.
double numberSum(const Scene& scene, std::size_t i)
{
    const auto& fields = scene.store.fields().at("positions").component;
    double sum = 0;
    for (std::size_t j = 0; j < scene.owned; ++j)
        if (const double q = std::hypot(fields[0][i] - fields[0][j], fields[1][i] - fields[1][j]) / H; q < 1)
            sum += sqr(sqr(1 - q)) * (1 + 4 * q);
    return sum * 7 / (std::numbers::pi * sqr(H)) * sqr(dx);
}

// A drip of 2.6 to 5.4 spacings in a plane that is open to gas, at any offset from the lattice that the duct was packed with: what is held is one lattice with the gas beside
// it and before the plane, 2 % from even where all neighbours are there, and the drip's rate that asked for. Two lattices in one another were 46 % too dense.
TEST(Openings, HoldOneLatticeFromTheStart)
{
    const double perfect = 1.0112; // of the lattice itself at this support
    for (const double shift : {0.0, 0.03, 0.05, 0.08})
        for (const double radius : {0.13, 0.175, 0.22, 0.27})
            for (const double centre : {0.5, 0.53, 0.575})
            {
                SCOPED_TRACE(std::to_string(shift) + " " + std::to_string(radius) + " " + std::to_string(centre));
                TwoPhases scene;
                auto drip = scene.gateOfBoth();
                drip.name = "drip1";
                drip.layers.clear();
                drip.velocity.reset();
                drip.flowRate = 0.1;
                drip.point = {0, centre, 0};
                drip.radius = radius;
                auto sky = outlet(0);
                sky.point = {0, 0, 0};
                sky.normal = {1, 0, 0};
                sky.backflow = true;
                sky.stream = scene.streamOf(1);
                sky.without = {drip};
                scene.fillWithBoth(-0.6 + shift, 2, 0);
                for (std::size_t i = 0; i < scene.owned; ++i)
                    for (const auto& [field, value] : scene.streamOf(1).values) scene.store.component(field, 0)[i] = value;
                Openings<2> openings({sky, drip}, scene.geometry, scene.c, scene.evolving, {});
                scene.exchange(openings);
                int looked = 0;
                for (const int i : openings.held())
                {
                    const double x = scene.store.component("positions", 0)[i], y = scene.store.component("positions", 1)[i];
                    EXPECT_EQ(scene.store.component("phase", 0)[i], std::abs(y - centre) < radius ? 0 : 1);
                    if (x < -H || y < H || y > 1 - H) continue;
                    ++looked;
                    EXPECT_NEAR(numberSum(scene, std::size_t(i)) / perfect, 1, 0.02) << x << ' ' << y;
                }
                EXPECT_GT(looked, 8);
                EXPECT_NEAR(openings.flows().at(1).flowRate, 0.1, 1e-12);
                EXPECT_NEAR(openings.flows().at(1).area, 2 * radius, 1e-9);
                for (const double off : openings.imbalance(scene.store).mass) EXPECT_LT(std::abs(off), 1e-14);
            }
}

TEST(Openings, MustFitTheirScene)
{
    auto empty = inlet();
    empty.layers = {{{{-1, 0.5, -1}, {1, 1, 1}}, {}}, {{{-1, 0.7, -1}, {1, 0.8, 1}}, {}}};
    refuses(empty, channel(1), "no fluid in the part 2 of its layers");
    auto narrow = inlet();
    narrow.point = {0, 0.5, 0};
    narrow.radius = 0.1;
    refuses(narrow, channel(1), "less than the support of the kernel");
    auto inWall = inlet();
    inWall.extent = {{-1, 1.2, -1}, {1, 1.5, 1}};
    refuses(inWall, channel(1), "inside a wall");
    refuses(inlet(), channel(0.2), "less than the support of the kernel");
    auto atTheEdge = inlet();
    atTheEdge.point = {-0.9, 0, 0};
    refuses(atTheEdge, channel(1), "of domain beyond its plane");
    auto developed = inlet();
    developed.developed = true;
    auto slips = channel(1);
    slips.walls[1].slips = true;
    refuses(developed, slips, "wall \"high\" slips: take profile uniform");
    auto oblique = inlet();
    oblique.normal = unitVector(Vector<3>{1, 0.5, 0});
    refuses(oblique, channel(1), "must go on straight");
    auto close = outlet(0);
    close.point = {H / 2, 0, 0};
    EXPECT_THROW(Openings<2>({inlet(), close}, channel(1), coefficients(), stateOfPowder(), {}), CaseError);
}

}
}
