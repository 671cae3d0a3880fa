/// Terms that the planner takes in, leaves out, and refuses; and the laws that evaluations keep.
#include "Largest.hpp"
#include "Scene.hpp"
#include "base/CaseError.hpp"
#include <omp.h>
#include <sstream>

namespace sph::test
{
namespace
{

std::string errorOfPlan(const std::vector<std::string>& terms, const std::set<std::string>& given)
{
    try
    {
        Plan<2>(wholeCatalogue<2>(), terms, given);
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

TEST(Plan, SuggestsATermForAMisspeltOne)
{
    const auto error = errorOfPlan({"huAdamsPresure"}, {});
    EXPECT_EQ(error.find("term \"huAdamsPresure\" is unknown. Did you mean \"huAdamsPressure\"?"), 0u) << error;
}

TEST(Plan, NamesTheTermThatLacksAField)
{
    EXPECT_EQ(errorOfPlan({"numberDensity", "summedDensity"}, {"positions"}),
              "term \"summedDensity\" reads \"m\" [kg], which the scene does not give and no term provides");
}

TEST(Plan, RefusesTwoProvidersOfOneField)
{
    EXPECT_EQ(errorOfPlan({"tait", "taitOfPhase"}, {"m", "phase"}), "field \"p\" is provided by both tait and taitOfPhase: select one");
}

TEST(Plan, AsksWhereSeveralCouldProvide)
{
    EXPECT_EQ(
        errorOfPlan({"huAdamsPressure"}, {"m"}),
        "term \"huAdamsPressure\" reads \"p\": select one of taitOfPhaseOrAmbient, taitOfPhaseOrHeldOrAmbient, tait, taitOrHeld, taitOfPhase, taitOfPhaseOrHeld, meanPressure");
}

// The curvature form needs three more sums, which nobody selected: their one provider each is added, and the log says for whom. Of the gradient of
// colour there are two.
TEST(Plan, AddsTheOneProviderAndSaysWhy)
{
    const Plan<2> plan(wholeCatalogue<2>(), {"curvatureForce", "smoothedColourGradient", "numberDensity"},
                       {"positions", "U", "m", "phase"});
    for (const char* term : {"colourSmoothing", "interfaceCurvature", "curvatureSmoothing"}) EXPECT_TRUE(plan.has(term)) << term;
    FieldStore<2> store;
    plan.allocate(store);
    std::ostringstream log;
    plan.print(log, store);
    EXPECT_NE(log.str().find("(kappa for curvatureForce)"), std::string::npos) << log.str();
}

// A scene without a feature has neither its pass, nor its field, nor its images' refresh: one viscous phase without surface
// tension needs volume, density and pressure, the rates, and two loops over pairs.
TEST(Plan, LeavesOutWhatIsNotSelected)
{
    const Plan<3> plan(wholeCatalogue<3>(), {"numberDensity", "summedDensity", "tait", "huAdamsPressure", "singlePhaseViscosity"},
                       {"positions", "U", "m"});
    EXPECT_EQ(plan.pairPasses(), 2);
    FieldStore<3> store;
    plan.allocate(store);
    std::set<std::string> fields;
    for (const auto& [name, _] : store.fields()) fields.insert(name);
    EXPECT_EQ(fields, (std::set<std::string>{"positions", "U", "m", "V", "rho", "p", "dUdt"}));
    std::ostringstream log;
    plan.print(log, store);
    const auto leftOut = log.str().substr(log.str().find("left out"));
    for (const char* term : {"interfaceStress", "wallTension", "harmonicViscosity", "densityDiffusion", "particleShifting"})
        EXPECT_NE(leftOut.find(term), std::string::npos) << term;
}

// Two loops over pairs for the stress form beside pressure and viscosity: number density first, then stress, then all that is
// left in one.
TEST(Plan, MergesTermsThatCanShareAStencil)
{
    const Plan<3> plan(wholeCatalogue<3>(),
                       {"numberDensity", "summedDensity", "taitOfPhase", "huAdamsPressure", "harmonicViscosity", "interfaceStress",
                        "stressDivergence"},
                       {"positions", "U", "m", "phase", "mu"});
    EXPECT_EQ(plan.pairPasses(), 3);
}

// Several terms add to the stress, and what reads it runs after the last of them: with the wall tension beside the interface
// stress there is no loop over pairs more, as it runs over walls.
TEST(Plan, ReadsAFieldThatSeveralTermsAddTo)
{
    const std::vector<std::string> terms{"numberDensity",   "summedDensity", "taitOfPhase",
                                         "interfaceStress", "wallTension",   "stressDivergence"};
    const Plan<2> plan(wholeCatalogue<2>(), terms, {"positions", "U", "m", "phase"});
    EXPECT_EQ(plan.pairPasses(), 3);
    EXPECT_EQ(errorOfPlan({"numberDensity", "wallTension", "stressDivergence"}, {"positions", "U", "m"}),
              "term \"wallTension\" reads \"phase\" [1], which the scene does not give and no term provides");
}

// The solid as a phase of its own takes part in the passes that are there and has its two fields. A scene of the same phases without
// it has neither, nor a column more to gather; the image's wall is known only where it is asked for.
TEST(Plan, KnowsGhostsWallsOnlyForTheSolidPhase)
{
    const std::vector<std::string> common{"numberDensity", "summedDensity", "taitOfPhase", "huAdamsPressure", "stressDivergence"};
    const auto printed = [&](std::vector<std::string> terms, std::set<std::string>& fields)
    {
        terms.insert(terms.begin(), common.begin(), common.end());
        const Plan<2> plan(wholeCatalogue<2>(), terms, {"positions", "U", "m", "phase", "ghostWall"});
        EXPECT_EQ(plan.pairPasses(), 3);
        FieldStore<2> store;
        plan.allocate(store);
        for (const auto& [name, _] : store.fields()) fields.insert(name);
        std::ostringstream log;
        plan.print(log, store);
        return log.str().substr(0, log.str().find("left out"));
    };
    std::set<std::string> without, with;
    const auto plain = printed({"interfaceStress"}, without), solid = printed({"solidPhaseStress", "stressOfSolid"}, with);
    EXPECT_EQ(without, (std::set<std::string>{"positions", "m", "phase", "V", "rho", "p", "S", "dUdt"}));
    for (const char* word : {"ghostWall", "solid", "wallTension"}) EXPECT_EQ(plain.find(word), std::string::npos) << plain;
    without.insert({"ghostWall", "solidStress"});
    EXPECT_EQ(with, without);
    EXPECT_NE(solid.find("p V phase ghostWall\n"), std::string::npos) << solid;
}

// Antisymmetric pairs: the sum of all forces in a periodic scene is the round-off of adding some 10^5 pair forces, against the
// largest one.
template<int dim> void conserveMomentum(const std::vector<std::string>& forces)
{
    std::vector<std::string> terms{"gradientNormalisation", "numberDensity", "summedDensity", "taitOfPhase"};
    terms.insert(terms.end(), forces.begin(), forces.end());
    Scene<dim> s(periodicBox(dim), threePhases(dim, dim == 2 ? 0.05 : 0.12, 2.6), terms);
    Vector<dim> sum;
    Largest largest;
    for (std::size_t i = 0; i < s.n; ++i)
    {
        const auto force = s.at(Mass{}, i) * s.at(Acceleration{}, i);
        sum += force;
        largest(mag(force));
    }
    EXPECT_GT(largest.value(), 0);
    EXPECT_LT(mag(sum), 1e-12 * largest.value()) << forces[0];
}
TEST(Plan, ConservesLinearMomentumWithoutWalls)
{
    const std::vector<std::vector<std::string>> all{{"huAdamsPressure"},
                                                    {"monaghanPressure"},
                                                    {"densityWeightedPressure"},
                                                    {"singlePhaseViscosity"},
                                                    {"harmonicViscosity"},
                                                    {"singlePhaseClearyViscosity"},
                                                    {"clearyViscosity"},
                                                    {"transposedViscosity", "viscousGradient"},
                                                    {"transportStress"},
                                                    {"interfaceStress", "stressDivergence"},
                                                    {"interfaceStress", "densityWeightedStressDivergence"}};
    for (const auto& forces : all)
    {
        conserveMomentum<2>(forces);
        conserveMomentum<3>(forces);
    }
}

// Each particle sums only its own rates, in the order of its list: the same bits on one, two and three threads.
TEST(Plan, GivesTheSameBitsOnAnyNumberOfThreads)
{
    std::vector<double> first;
    for (int threads : {1, 2, 3})
    {
        omp_set_num_threads(threads);
        Scene<3> s(aroundABall(3, 0.33), threePhases(3, 0.07, 2.6),
                   {"numberDensity", "summedDensity", "taitOfPhase", "huAdamsPressure", "harmonicViscosity", "interfaceStress",
                    "stressDivergence"});
        std::vector<double> all;
        for (int c = 0; c < 3; ++c) all.insert(all.end(), s.store.component("dUdt", c), s.store.component("dUdt", c) + s.n);
        if (first.empty()) first = all;
        EXPECT_EQ(all, first) << threads << " threads";
    }
}

// Of the fields that passes gather images have no arrays: their values are computed as they are packed, the same bits. In the box the last of the viscosity's six columns, gradientScale, would be gathered by index.
TEST(Plan, ComputesValuesOfImagesWhereItPacksThem)
{
    const std::set<std::string> places{"positions", "volumeFactor", "ghostWall"};
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const auto& forces : {std::vector<std::string>{"huAdamsPressure", "harmonicViscosity", "transposedViscosity", "viscousGradient",
                                                        "interfaceStress", "stressDivergence"},
                               {"gradientNormalisation", "harmonicViscosity"}})
        for (const auto& geometry : {aroundABall(3, 0.33), periodicBox(3)})
        {
            std::vector<std::string> terms{"numberDensity", "summedDensity", "taitOfPhase"};
            terms.insert(terms.end(), forces.begin(), forces.end());
            Scene<3> all(geometry, threePhases(3, 0.07, 2.6), terms), few(geometry, threePhases(3, 0.07, 2.6), terms);
            // The room that is given up stays where it is, and must not tell.
            for (const auto& [name, field] : few.store.fields())
                for (int c = 0; c < int(field.component.size()) && !places.contains(name); ++c)
                {
                    double* const a = few.store.component(name, c);
                    std::fill(a + (field.state ? few.n : 0), a + few.store.size(), none);
                }
            few.store.keepImagesOf(few.plan->imaged(few.images));
            for (const auto& [name, field] : few.store.fields())
            {
                if (name == "ghostWall") continue; // has room where some pass reads it
                EXPECT_EQ(field.component[0].size(), places.contains(name) ? few.store.size() : few.n) << name;
            }
            few.plan->bind(few.store, few.coefficients);
            few.plan->evaluate(few.store, few.images, few.lists, few.kernel);
            for (const auto& [name, field] : all.store.fields())
                for (std::size_t c = 0; c < field.component.size(); ++c)
                    EXPECT_TRUE(std::equal(field.component[c].begin(), field.component[c].begin() + long(all.n),
                                           std::as_const(few.store).component(name, int(c))))
                        << name;
        }
}

// rho_0 of the second phase at 1.1 times its own rest density and n = 7: p = B (1.1^7 - 1) + p_b = 0.9487171 B + p_b, B = rho_0
// c^2/7.
TEST(Tait, HasTheHandValue)
{
    auto c = threePhases(2, 0.05, 2.6);
    Scene<2> s(periodicBox(2), c, {"integratedVolume", "taitOfPhase"}, true);
    const double B = 1000 * 225 / 7.0;
    for (std::size_t i = 0; i < s.n; ++i) s.store.component("rho", 0)[i] = 1.1 * c.restDensity[std::size_t(s.at(Phase{}, i))];
    s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
    for (std::size_t i = 0; i < s.n; ++i)
        EXPECT_NEAR(s.at(Phase{}, i) == 1 ? s.at(Pressure{}, i) : 0.9487171 * B + 37, 0.9487171 * B + 37, 1e-12 * B);
}

// Up to the tension p_min a fluid is as stiff as under pressure; beyond it gives way, and at twice that it has parted.
TEST(Tait, PartsBeyondItsTension)
{
    auto c = firstPhases(threePhases(2, 0.05, 2.6), 1);
    c.backgroundPressure = 0;
    c.stateEquation[0].n = 1;
    const double B = c.stateEquation[0].B;
    c.leastPressure = -0.1 * B;
    Scene<2> s(periodicBox(2), c, {"integratedVolume", "tait"}, true);
    const double strain[] = {0.05, -0.05, -0.1, -0.14, -0.2, -0.5}, expected[] = {0.05, -0.05, -0.1, -0.06, 0, 0};
    for (std::size_t i = 0; i < s.n; ++i) s.store.component("rho", 0)[i] = (1 + strain[i % 6]) * c.restDensity[0];
    s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
    for (std::size_t i = 0; i < s.n; ++i) EXPECT_NEAR(s.at(Pressure{}, i), expected[i % 6] * B, 1e-12 * B);
}

// v = e x in an unbounded medium expands it: drho/dt = -d e rho, up to the error of the sum on a jittered lattice (a few per
// cent of the kernel's second moment, 10 % allowed). Here away from the periodic faces, across which v jumps.
TEST(Continuity, OfUniformExpansion)
{
    auto c = firstPhases(threePhases(2, 0.05, 2.6), 1);
    Scene<2> s(periodicBox(2), c, {"integratedVolume", "continuity"}, true);
    for (std::size_t i = 0; i < s.n; ++i)
    {
        s.store.component("rho", 0)[i] = 800;
        s.store.component("m", 0)[i] = 800 * 0.05 * 0.05;
        for (int k = 0; k < 2; ++k) s.store.component("U", k)[i] = 3 * s.store.component("positions", k)[i];
    }
    s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
    double mean = 0;
    int count = 0;
    for (std::size_t i = 0; i < s.n; ++i)
        if (const auto x = positionOf(s.store, i); x.x > 0.2 && x.x < 0.8 && x.y > 0.2 && x.y < 0.8)
        {
            mean += s.store.component("drhodt", 0)[i];
            ++count;
        }
    EXPECT_NEAR(mean / count / (-2 * 3 * 800), 1, 0.05);
}

}
}
