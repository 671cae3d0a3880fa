/// What evolves is declared once: fields that only this test knows are allocated, loaded, sorted, stepped, let in, held, written and restarted by
/// the walks over the state, and their rates come from terms that the scene defines.
#include "base/CaseError.hpp"
#include "models/openings/RunningOpenings.hpp"
#include "periodicSquare.hpp"
#include "solver/Simulation.hpp"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace sph::test
{
namespace
{

struct Charge
{
    static constexpr FieldInfo info{"charge", "1"};
    template<int dim, class Real = double> struct At
    {
        Real q;
    };
};
struct ChargeRate
{
    static constexpr FieldInfo info{"dchargedt", "1/s"};
    template<int dim, class Real = double> struct At
    {
        Real dqdt;
    };
};
struct Spin
{
    static constexpr FieldInfo info{"spin", "1/s", Image::mirrored};
    template<int dim, class Real = double> struct At
    {
        Vector<dim, Real> w;
    };
};
struct SpinRate
{
    static constexpr FieldInfo info{"dspindt", "1/s^2", Image::mirrored};
    template<int dim, class Real = double> struct At
    {
        Vector<dim, Real> dwdt;
    };
};
/// Number of a particle: carried, without a rate.
struct Number
{
    static constexpr FieldInfo info{"number", "1"};
    template<int dim, class Real = double> struct At
    {
        Real number;
    };
};

/// dq/dt = -k q, k [1/s]
struct Decay
{
    using Provides = ChargeRate;
    using ReadsOwn = Fields<Charge>;
    double k;
    double operator()(const auto& i) const { return -k * i.q; }
};
/// dw/dt = -k w
struct SpinDecay
{
    using Provides = SpinRate;
    using ReadsOwn = Fields<Spin>;
    double k;
    auto operator()(const auto& i) const { return -k * i.w; }
};

/// dt/dt = 1 of what is free: how long ago it was let in.
struct Ageing
{
    using Provides = ChargeRate;
    using ReadsOwn = Fields<Charge>;
    double operator()(const auto&) const { return 1; }
};

constexpr double k1 = 30, k2 = 11, k3 = 5; ///< of charge, of salt, which is a charge of another name, and of spin [1/s]

/// One more declaration each, and one term: nothing else names these fields.
void addToys(Settings& settings)
{
    Evolving charge{stateField(Charge{}), stateField(ChargeRate{})},
        salt{stateField(Charge{}, "salt"), stateField(ChargeRate{}, "dsaltdt")}, spin{stateField(Spin{}), stateField(SpinRate{})},
        number{stateField(Number{})}, hidden{stateField(Number{}, "hidden")};
    charge.inlet = [](const Dictionary& d, std::size_t) { return d.getPositive("charge", units::none, 1); };
    charge.missing = [](const Loading& loading)
    {
        if (loading.restarted) throw CaseError("the charge is lost");
        for (std::size_t i = 0; i < loading.size(); ++i) loading.values[0][i] = 1 + double(i);
    };
    charge.check = [](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i)
            if (!(loading.values[0][i] > 0)) throw CaseError(loading.cloud.particle(i) + " has no charge");
    };
    salt.missing = charge.missing;
    salt.onDisk = "saltOnDisk";
    spin.missing = [](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i)
            for (std::size_t c = 0; c < loading.values.size(); ++c) loading.values[c][i] = double(c + 1) * (1 + double(i));
    };
    number.missing = [](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i) loading.values[0][i] = double(i);
    };
    hidden.written = false;
    for (const auto& each : {charge, salt, spin, number, hidden}) settings.state.push_back(each);
    settings.define<Decay>("decay", [](const Coefficients&) { return Decay{k1}; });
    settings.define<Decay>("decay of salt", [](const Coefficients&) { return Decay{k2}; }, {{"charge", "salt"}, {"dchargedt", "dsaltdt"}});
    settings.define<SpinDecay>("spin decay", [](const Coefficients&) { return SpinDecay{k3}; });
    for (const char* term : {"decay", "decay of salt", "spin decay"}) settings.terms.push_back(term);
}

Settings toySettings(const std::string& integrator)
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.6; kernel wendlandC4; }\nintegration { scheme " + integrator + "; }\n";
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 20; soundSpeed 8; exponent 1; }\n";
    files.erase("constant/g");
    auto settings = settingsOf(files);
    addToys(settings);
    return settings;
}
/// Value of q after n steps of an integrator with dq/dt = -k q, by its formula.
double left(const std::string& integrator, double k, double deltaT, int steps)
{
    double q = 1, rate = -k;
    for (int s = 0; s < steps; ++s)
    {
        if (integrator == "predictorCorrector") rate = -k * q;
        const double half = integrator == "symplecticEuler" || integrator == "semiImplicit" ? q : q + 0.5 * deltaT * rate;
        rate = -k * half;
        q += deltaT * rate;
    }
    return q;
}

// Predicted, kicked and corrected as the integrator has it, each by its own rate, on the same particle as at the start: round-off of 60 steps.
TEST(State, IsSteppedByEveryIntegrator)
{
    for (const std::string integrator : {"predictorCorrector", "leapfrog", "symplecticEuler", "semiImplicit"})
    {
        SCOPED_TRACE(integrator);
        const auto settings = toySettings(integrator);
        const auto g = periodicSquare();
        const auto simulation = makeSimulation(settings, g, vortexOf(2), {});
        const double deltaT = 0.002;
        for (int s = 0; s < 60; ++s) simulation->step(s * deltaT, deltaT);
        EXPECT_GT(simulation->rebuilds(), 3);
        const auto number = simulation->field("number"), charge = simulation->field("charge"), salt = simulation->field("salt"),
                   spin = simulation->field("spin");
        bool sorted = true;
        std::set<double> seen;
        for (std::size_t i = 0; i < simulation->size(); ++i)
        {
            const double n = number.component[0][i], start = 1 + n;
            sorted = sorted && n == double(i);
            seen.insert(n);
            ASSERT_NEAR(charge.component[0][i], start * left(integrator, k1, deltaT, 60), 1e-12 * start);
            ASSERT_NEAR(salt.component[0][i], start * left(integrator, k2, deltaT, 60), 1e-12 * start);
            for (std::size_t c = 0; c < 2; ++c)
                ASSERT_NEAR(spin.component[c][i], double(c + 1) * start * left(integrator, k3, deltaT, 60), 2e-12 * start);
        }
        EXPECT_EQ(seen.size(), 400u);
        EXPECT_FALSE(sorted) << "the particles stay where they are: nothing is shown";
        // Starts of a step and rates have arrays of their own where the integrator needs them.
        const bool predicts = integrator == "predictorCorrector" || integrator == "leapfrog";
        for (const char* start : {"charge_0", "salt_0", "spin_0"})
            EXPECT_EQ(simulation->field(start).component[0] != nullptr, predicts) << start;
        EXPECT_EQ(simulation->field("number_0").component[0], nullptr) << "what has no rate needs no start";
        std::ostringstream plan;
        simulation->printPlan(plan);
        for (const char* words :
             {"decay                            -> dchargedt", "decay of salt                    -> dsaltdt", "spin decay"})
            EXPECT_NE(plan.str().find(words), std::string::npos) << plan.str();
    }
}

/// What the solver writes, and reads again.
Cloud writtenAndRead(const AnySimulation& simulation)
{
    const TestCase folder(Files{});
    writeCloud(folder.folder() / "1", "sph", simulation.size(), simulation.positions(), simulation.fields(), {});
    Diagnostics diagnostics;
    auto cloud = readCloud(folder.folder(), "1", "sph", diagnostics);
    diagnostics.throwIfAny();
    return cloud;
}

// Written under the name that it has on disk, without what is not to be written; a run from there ends with the same bits as one that went on.
TEST(State, IsWrittenAndRestarted)
{
    for (const std::string integrator : {"predictorCorrector", "leapfrog", "symplecticEuler"})
    {
        SCOPED_TRACE(integrator);
        const auto settings = toySettings(integrator);
        const auto g = periodicSquare();
        const auto whole = makeSimulation(settings, g, vortexOf(2), {});
        for (int s = 0; s < 20; ++s) whole->step(0, 0.002);
        whole->settle();
        const auto cloud = writtenAndRead(*whole);
        for (const char* name : {"charge", "saltOnDisk", "spin", "number"}) EXPECT_TRUE(cloud.fields.contains(name)) << name;
        for (const char* name : {"salt", "hidden", "charge_0"}) EXPECT_FALSE(cloud.fields.contains(name)) << name;
        for (const char* rate : {"dchargedt", "dsaltdt", "dspindt"})
            EXPECT_EQ(cloud.fields.contains(rate), settings.integration.keepsRates) << rate;
        const auto again = makeSimulation(settings, g, cloud, whole->state());
        for (auto* simulation : {whole.get(), again.get()})
        {
            for (int s = 0; s < 20; ++s) simulation->step(0, 0.002);
            simulation->settle();
        }
        for (const char* name : {"charge", "salt", "spin", "number", "U"})
            for (std::size_t c = 0; c < whole->field(name).component.size(); ++c)
                for (std::size_t i = 0; i < whole->size(); ++i)
                    if (const auto* const other = again->field(name).component[c])
                    {
                        ASSERT_EQ(whole->field(name).component[c][i], other[i]) << name << i;
                    }
    }
}

std::string errorOf(const Settings& settings, const Cloud& cloud, const StateNumbers& restored = {})
{
    try
    {
        const auto g = periodicSquare();
        makeSimulation(settings, g, cloud, restored);
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

TEST(State, SaysWhatAMissingFileMeansAndWhatCannotBe)
{
    const auto settings = toySettings("leapfrog");
    auto cloud = vortexOf(2);
    EXPECT_EQ(errorOf(settings, cloud), "");
    EXPECT_EQ(errorOf(settings, cloud, {{"densityScale", 1.0}}), "the charge is lost");
    auto& charge = cloud.fields["charge"].component;
    charge.assign(1, std::vector<double>(cloud.size(), 4));
    const auto g = periodicSquare();
    EXPECT_EQ(makeSimulation(settings, g, cloud, {})->field("charge").component[0][7], 4);
    charge[0][3] = 0;
    EXPECT_EQ(errorOf(settings, cloud), "particle 3 at (0.025 0.175 0) has no charge");
}

// A pressure at the start, by masses where the positions decide the density: it is there before the first step, above the background's.
TEST(State, HasThePressureOfTheStart)
{
    for (const char* density : {"numberDensity", "continuity"})
    {
        auto files = channelCase();
        files["system/sphSchemes"] =
            std::string("resolution { spacing 0.05; support 2.6; }\nbackgroundPressure 70;\ndensity ") + density + ";\n";
        files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 20; soundSpeed 8; }\n";
        files.erase("constant/g");
        const auto settings = settingsOf(files);
        auto cloud = vortexOf(2);
        auto& p = cloud.fields["p"].component;
        p.assign(1, {});
        for (std::size_t i = 0; i < cloud.size(); ++i) p[0].push_back(500 + 300 * cloud.y[i]);
        cloud.fields["m"].component.assign(1, std::vector<double>(cloud.size(), 1000 * 0.05 * 0.05));
        const auto g = periodicSquare();
        const auto simulation = makeSimulation(settings, g, cloud, {});
        const auto found = simulation->field("p"), x = simulation->field("positions");
        for (std::size_t i = 0; i < cloud.size(); ++i)
            ASSERT_NEAR(found.component[0][i], 570 + 300 * x.component[1][i], 1e-3 * 500) << density;
    }
}

// A rate that nobody gives is an error that names the term which reads the field, and a term of an unknown name one that names the terms.
TEST(State, NeedsTermsThatAreDefined)
{
    auto settings = toySettings("leapfrog");
    settings.terms.push_back("dekay");
    EXPECT_NE(errorOf(settings, vortexOf(2)).find("term \"dekay\" is unknown. Did you mean \"decay\"?"), std::string::npos)
        << errorOf(settings, vortexOf(2));
}

// An inlet asks for the value of what comes in by its own entry. What it holds keeps that; what has come in decays from there.
TEST(State, ComesInThroughInletsAndIsHeldThere)
{
    auto files = channelCase();
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\nintegration { scheme leapfrog; }\n";
    files["constant/geometry"] =
        "dimension 2; domain { min (-0.2 0 0); max (1.2 1 0); }\nwalls\n{\n    bottom { type plane; point (0 0 0); normal "
        "(0 1 0); }\n    top { type plane; point (0 1 0); normal (0 -1 0); }\n}\n";
    const std::string gate = "gate\n{\n    type inlet;\n    point (0 0 0);\n    normal (1 0 0);\n    velocity 3;\n";
    files["constant/openings"] = gate + "}\n";
    const TestCase folder(files);
    const Case c(folder.folder());
    const auto geometry = readGeometry(c.dictionary("constant/geometry"), 0.2);
    auto settings = readSettings(c, geometry);
    c.diagnostics().throwIfAny();
    addToys(settings);
    settings.state.push_back({stateField(Charge{}, "age"), stateField(ChargeRate{}, "dagedt")});
    settings.define<Ageing>("ageing", [](const Coefficients&) { return Ageing{}; }, {{"charge", "age"}, {"dchargedt", "dagedt"}});
    settings.terms.push_back("ageing");
    folder.write("constant/openings", gate + "    charge 3;\n}\n");
    const Case withCharge(folder.folder());
    const auto openings = readOpenings(withCharge, geometry, settings.coefficients, settings.state);
    withCharge.diagnostics().throwIfAny();
    EXPECT_EQ(openings.at(0).stream.values.at("charge"), 3);
    EXPECT_FALSE(openings.at(0).stream.values.contains("salt"));
    settings.runningModels.front() = running<RunningOpenings>(openings);

    const auto simulation = makeSimulation(settings, geometry, {}, {});
    EXPECT_GT(simulation->size(), 0u);
    double time = 0;
    while (time < 0.1)
    {
        const double deltaT = simulation->stepLimit().deltaT;
        EXPECT_LT(k1 * deltaT, 0.05);
        simulation->step(time, deltaT);
        time += deltaT;
    }
    simulation->settle();
    const auto holder = simulation->field("heldBy"), charge = simulation->field("charge"), start = simulation->field("charge_0"),
               salt = simulation->field("salt"), age = simulation->field("age");
    int held = 0, free = 0;
    double least = 3;
    for (std::size_t i = 0; i < simulation->size(); ++i)
    {
        EXPECT_EQ(salt.component[0][i], 0) << "what has no entry comes in as 0";
        if (holder.component[0][i] > 0)
        {
            EXPECT_EQ(charge.component[0][i], 3);
            EXPECT_EQ(age.component[0][i], 0);
            ++held;
            continue;
        }
        ++free;
        // k dt is at most 0.05: (k dt)^2/2 of what there is by the first step, whose rate nothing predicts, and as much by all that follow
        EXPECT_NEAR(charge.component[0][i], 3 * std::exp(-k1 * age.component[0][i]), 0.01);
        EXPECT_LE(age.component[0][i], time);
        least = std::min(least, charge.component[0][i]);
    }
    EXPECT_NE(start.component[0], nullptr);
    EXPECT_GT(held, 50);
    EXPECT_GT(free, 50);
    EXPECT_LT(least, 0.5);
}

}
}
