/// Water in the pores: the Laplacian below free surfaces, consolidation beside Terzaghi's series, undrained soil, water at rest, seepage, a water table, water that stands on soil, mistakes.
#include "CaseScene.hpp"
#include "Largest.hpp"
#include "messages.hpp"
#include "models/soil/PoreWaterStep.hpp"
#include "models/soil/Seepage.hpp"
#include "models/soil/SoilFields.hpp"
#include "runTo.hpp"
#include "scene/Particles.hpp"
#include "solver/models.hpp"
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test
{
namespace
{

/// Soil that an engineer would call dense silt, in a column 1 m high, endless sideways, on a base that nothing passes: E_oed 1e7 Pa.
struct Column
{
    int across = 16;
    double permeability = 7e-4, load = 1e3, bulkModulus = 2.2e9;
    std::string ofWater = "", gravity = "", initial = "type isotropic; pressure 0;", more = "soil { correctedFrom 0.3; }";

    static constexpr double modulus = 1e7, porosity = 0.4, unitWeight = 9810;
    /// n E/K_w
    double ratio() const { return porosity * modulus / bulkModulus; }
    /// Pore pressure at the start [Pa], and the coefficient of consolidation [m^2/s]: Terzaghi's with compressible water.
    double start() const { return load / (1 + ratio()); }
    double diffusivity() const { return permeability / unitWeight * modulus / (1 + ratio()); }
    Files files() const
    {
        auto files = soilCase();
        files.erase("constant/g");
        if (!gravity.empty()) files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 " + gravity + " 0);\n";
        files["system/sphSchemes"] = fmt::format("resolution {{ spacing {}; support 3.05; kernel wendlandC2; }}\n{}\n", 1.0 / across, more);
        files["constant/geometry"] = fmt::format("dimension 2; domain {{ min (0 0 0); max ({} 1 0); periodic (x); }}\n"
                                                 "walls {{ base {{ type plane; point (0 0 0); normal (0 1 0); slip yes; }} }}\n",
                                                 8.0 / across);
        files["constant/phaseProperties"] = "phases (soil);\nsoil { rho 2000; stress constitutiveLaw; }\n";
        files["constant/soilProperties"] =
            fmt::format("rho 2000;\nlaw elastic;\nelasticCoeffs {{ E {}; nu 0.3; }}\n{}initialStress {{ {} }}\n"
                        "poreWater {{ permeability {}; porosity 0.4; bulkModulus {}; {} }}\n",
                        modulus * 1.3 * 0.4 / 0.7, load > 0 ? fmt::format("confiningPressure {}; ", load) : "", initial, permeability,
                        bulkModulus, ofWater);
        return files;
    }
};

/// u/u_0 at a depth of Z drainage paths, T = c_v t/H^2.
double terzaghi(double Z, double T)
{
    double sum = 0;
    for (int m = 0; m < 100; ++m)
    {
        const double M = (m + 0.5) * std::numbers::pi;
        sum += 2 / M * std::sin(M * Z) * std::exp(-sqr(M) * T);
    }
    return sum;
}

/// L2 error of the pore pressure over that of f(y).
double pressureError(const CaseScene& scene, const std::function<double(double)>& f)
{
    const auto* const p = scene["porePressure"];
    const auto* const y = scene.simulation->positions().component[1];
    double off = 0, all = 0;
    for (std::size_t i = 0; i < scene.simulation->size(); ++i)
    {
        off += sqr(p[i] - f(y[i]));
        all += sqr(f(y[i]));
    }
    return std::sqrt(off / all);
}

double consolidationError(Column column, double T, bool twoWay = false)
{
    if (twoWay) column.ofWater = "walls { base { porePressure 0; } }";
    const CaseScene scene(column.files());
    EXPECT_EQ(scene.errors, "");
    const double H = twoWay ? 0.5 : 1;
    runTo(*scene.simulation, T * sqr(H) / column.diffusivity());
    return pressureError(scene, [&](double y) { return column.start() * terzaghi((1 - y) / H, T); });
}

// One- and two-way drained, beside the series. What is left in time is of first order, in the depth of second (the next test).
TEST(PoreWater, ConsolidatesAsTerzaghiHasIt)
{
    for (const double T : {0.05, 0.2}) EXPECT_LT(consolidationError({}, T), 0.01) << T;
    EXPECT_LT(consolidationError({}, 0.2, true), 0.01);
}

// Soft water has the start and the diffusivity of its storage: u/q = 1/(1 + n E/K_w) = 0.833, and all lower by 15 %.
TEST(PoreWater, IsAsSoftAsItIsGiven) { EXPECT_LT(consolidationError({.bulkModulus = 2e7}, 0.2), 0.01); }

// A load that arrives at once is the water's: within 0.5 % in the lower half; undrained soil keeps it there. Beneath a closed surface the first rows are off (README).
TEST(PoreWater, TakesTheLoadAtOnce)
{
    const Column drained, undrained{.permeability = 0, .ofWater = "freeSurface closed;"};
    for (const auto* column : {&drained, &undrained})
    {
        const CaseScene scene(column->files());
        runTo(*scene.simulation, 0.01 / drained.diffusivity());
        const auto* const p = scene["porePressure"];
        const auto* const y = scene.simulation->positions().component[1];
        Largest off;
        for (std::size_t i = 0; i < scene.simulation->size(); ++i)
            if (y[i] < 0.5) off(p[i] / column->start() - 1);
        EXPECT_LT(off.value(), 0.005);
    }
}

// With the divergence of the forces the water takes it up to the first row beneath the membrane, on and off the lattice.
TEST(PoreWater, TakesTheLoadBeneathAMembrane)
{
    const Column undrained{.permeability = 0,
                           .ofWater = "freeSurface closed; projection exact;",
                           .more = "soil { correctedFrom 0.3; stressDivergence balanced; }\n"
                                   "integration { damping { rate 100; until 1; } }"};
    for (const double jitter : {0.0, 0.1})
    {
        const CaseScene scene(undrained.files(), jitter);
        ASSERT_EQ(scene.errors, "");
        runTo(*scene.simulation, 0.05);
        Largest off;
        for (std::size_t i = 0; i < scene.simulation->size(); ++i) off(scene["porePressure"][i] / undrained.start() - 1);
        EXPECT_LT(off.value(), jitter > 0 ? 0.05 : 0.005) << jitter;
    }
}

// Laplacians of a pressure that is linear in the depth below a drained surface are 0 at every particle, beside the surface too; of a parabola they are the curvature below the third row. Without
// a surface that drains pairs exchange what they lose: sum V lap p is 0 to round-off, off the lattice as well.
TEST(PoreWater, LaplacianBelowASurface)
{
    const Column column;
    const auto sumsOf = [&](const std::string& surface, double jitter, const std::function<double(double)>& p, const auto& visit)
    {
        auto with = column;
        with.ofWater = surface;
        const bool drains = surface.starts_with("freeSurface drained");
        const CaseScene scene(with.files());
        Particles<2> particles(scene.settings, scene.geometry, allTerms<2>(), scene.cloud(jitter), {});
        particles.evaluate();
        auto& store = particles.store();
        for (std::size_t i = 0; i < particles.size(); ++i) store.component("porePressure", 0)[i] = p(store.component("positions", 1)[i]);
        particles.evaluate(ofSeepage);
        for (std::size_t i = 0; i < particles.size(); ++i)
        {
            const double alpha = drains ? store.component(SurfaceDrainage::info.name, 0)[i] : 0;
            visit(store.component("positions", 1)[i], store.component("V", 0)[i],
                  store.component(PoreLaplacian::info.name, 0)[i] - alpha * store.component("porePressure", 0)[i]);
        }
    };
    Largest linear, curved;
    sumsOf(
        "freeSurface drained; walls { base { porePressure 1; } }", 0, [](double y) { return 1 - y; },
        [&](double, double, double lap) { linear(lap); });
    EXPECT_LT(linear.value(), 1e-9);
    sumsOf(
        "freeSurface drained;", 0, [](double y) { return 1 - sqr(y); },
        [&](double y, double, double lap)
        {
            if (y < 1 - 3.0 / 16) curved(lap + 2);
        });
    EXPECT_LT(curved.value(), 1e-9);
    double sum = 0, size = 0;
    sumsOf(
        "freeSurface closed; walls { base { porePressure 0; } }", 0.2, [](double y) { return y < 0.5 ? 0 : std::sin(40 * y); },
        [&](double, double V, double lap)
        {
            sum += V * lap;
            size += V * std::abs(lap);
        });
    EXPECT_LT(std::abs(sum), 1e-12 * size);
}

// Water at rest below its table in soil at rest: hydrostatic at each particle, with the soil's weight less that of the water on the grains; measured over 0.2 s, 20 times of sound through the column.
TEST(PoreWater, RestsInSoilOfBuoyantWeight)
{
    const Column column{.load = 0,
                        .ofWater = "initial { type hydrostatic; waterTable 1; }",
                        .gravity = "-9.81",
                        .initial = "type geostatic; surface 1; K0 0.428571;",
                        .more = "soil { correctedFrom 0.3; }\nintegration { damping { rate 100; until 1; } }"};
    const CaseScene scene(column.files());
    ASSERT_EQ(scene.errors, "");
    runTo(*scene.simulation, 0.2);
    EXPECT_LT(pressureError(scene, [](double y) { return 9810 * (1 - y); }), 0.005);
    const auto sigma = scene.simulation->field("sigma").component;
    const auto* const y = scene.simulation->positions().component[1];
    double mean = 0, count = 0;
    for (std::size_t i = 0; i < scene.simulation->size(); ++i)
        if (y[i] > 0.1 && y[i] < 0.8)
        {
            mean += sigma[3][i] / (-1000 * 9.81 * (1 - y[i]));
            ++count;
        }
    EXPECT_NEAR(mean / count, 1, 0.02);
}

// Water that a base lets in, 1e-5 m/s, and that leaves at the surface: p = j gamma_w/k (1 - y), whose gradient drives it.
TEST(PoreWater, SeepsAsMuchAsAWallLetsIn)
{
    const Column column{.across = 8, .permeability = 7e-3, .load = 0, .ofWater = "walls { base { flux 1e-5; } }"};
    const CaseScene scene(column.files());
    runTo(*scene.simulation, 3 / column.diffusivity());
    EXPECT_LT(pressureError(scene, [&](double y) { return 1e-5 * Column::unitWeight / column.permeability * (1 - y); }), 0.005);
}

// Gravel, whose water moves 100 times as far in a step as an explicit step would bear, 0.125 h^2/c_v: nothing rings, and the load is the grains' at once.
TEST(PoreWater, IsStableFarAboveTheLimitOfDiffusion)
{
    const Column gravel{.permeability = 0.1};
    const CaseScene scene(gravel.files());
    const double limit = 0.125 * sqr(1.525 / gravel.across) / gravel.diffusivity(), deltaT = scene.simulation->stepLimit().deltaT;
    EXPECT_GT(deltaT / limit, 40);
    runTo(*scene.simulation, 0.2);
    Largest left;
    for (std::size_t i = 0; i < scene.simulation->size(); ++i) left(scene["porePressure"][i] / gravel.load);
    EXPECT_LT(left.value(), 0.01);
}

/// A block of elastic soil, 1 m x 1 m, free at its top and on its right, water to its full height behind the left wall and 0.25 m deep before its right face.
struct Dam
{
    int across = 8;
    double level = 0.25, yield = 1e-4, jitter = 0;
    std::string ofWater = "walls { upstream { waterLevel 1; } }";

    Files files() const
    {
        auto files = Column{}.files();
        files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);\n";
        files["system/sphSchemes"] = fmt::format("resolution {{ spacing {}; support 3.05; kernel wendlandC2; }}\n"
                                                 "soil {{ correctedFrom 0.3; shown (seepageVelocity); }}\n"
                                                 "integration {{ damping {{ rate 30; until 100; }} }}\n",
                                                 1.0 / across);
        files["constant/geometry"] = "dimension 2; domain { min (0 0 0); max (1 1 0); }\n"
                                     "walls { base { type plane; point (0 0 0); normal (0 1 0); }\n"
                                     "        upstream { type plane; point (0 0 0); normal (1 0 0); slip yes; } }\n";
        files["system/packParticlesDict"] = "fill ( { region box; min (0 0 0); max (1 1 0); phase soil; } );\n";
        files["constant/soilProperties"] =
            fmt::format("rho 2000;\nlaw elastic;\nelasticCoeffs {{ E 1e7; nu 0.3; }}\n"
                        "poreWater {{ permeability 1e-3; porosity 0.4; waterLevel {}; initial {{ type hydrostatic; waterTable {}; }}\n"
                        "unsaturated {{ capillaryHead {}; specificYield {}; }} {} }}\n",
                        level, level, 1.0 / across, yield, ofWater);
        return files;
    }
};

// The discharge of a dam with vertical faces is k (H_1^2 - H_2^2)/(2 L) = 4.6875e-4 m^2/s (Charny), with a water table that is not known before; each section passes it.
// What pores above the table pass, of the capillary head's thickness, is first order in it.
TEST(PoreWater, DischargeOfADam)
{
    const Dam dam;
    const CaseScene scene(dam.files());
    ASSERT_EQ(scene.errors, "");
    runTo(*scene.simulation, 1);
    const double exact = 1e-3 * (1 - sqr(dam.level)) / 2;
    EXPECT_NEAR(scene.simulation->summary().columns.at("surfaceOutflow"), exact, 0.06 * exact);
    const auto* const q = scene["seepageVelocity"];
    const auto* const x = scene.simulation->positions().component[0];
    for (int section = 0; section < dam.across; ++section)
    {
        double passes = 0;
        for (std::size_t i = 0; i < scene.simulation->size(); ++i)
            if (int(x[i] * dam.across) == section) passes += q[i] / dam.across;
        EXPECT_NEAR(passes, exact, 0.08 * exact) << section;
    }
}

// The same by the divergence of the forces, in which grains above the table, where suction does not act, have no share; on a smooth base (README).
TEST(PoreWater, ProjectsBelowAWaterTable)
{
    auto files = Dam{.ofWater = "projection exact; walls { upstream { waterLevel 1; } }"}.files();
    auto &schemes = files["system/sphSchemes"], &geometry = files["constant/geometry"];
    schemes.replace(schemes.find("correctedFrom 0.3;"), 18, "correctedFrom 0.3; stressDivergence balanced;");
    geometry.replace(geometry.find("normal (0 1 0);"), 15, "normal (0 1 0); slip yes;");
    const CaseScene scene(files);
    ASSERT_EQ(scene.errors, "");
    runTo(*scene.simulation, 1);
    EXPECT_NEAR(scene.simulation->summary().columns.at("surfaceOutflow"), 4.6875e-4, 0.06 * 4.6875e-4);
}

// Water at rest in soil within water at rest, 0.2 spacings off the lattice: nothing seeps, through surfaces neither, and pressures move no particle.
TEST(PoreWater, RestsBelowWaterThatStandsOnTheSoil)
{
    const Dam dam{.level = 1.5, .ofWater = "walls { upstream { waterLevel 1.5; } }"};
    const CaseScene scene(dam.files());
    ASSERT_EQ(scene.errors, "");
    Particles<2> particles(scene.settings, scene.geometry, allTerms<2>(), scene.cloud(0.2), {});
    particles.evaluate();
    particles.evaluate(ofSeepage);
    auto& store = particles.store();
    Largest seeps, acts;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        const auto of = [&](const char* name) { return store.component(name, 0)[i]; };
        const double through = of(SurfaceOutflow::info.name) * (of("porePressure") - of(SurfaceTarget::info.name));
        seeps((of(PoreLaplacian::info.name) - through) / (9810 * dam.across));
        acts(of(ActingStress::info.name) / 9810);
    }
    EXPECT_LT(seeps.value(), 1e-9);
    EXPECT_LT(acts.value(), 1e-12);
}

// Soil below water bears its buoyant weight, the surface nothing, at whatever level above it.
TEST(PoreWater, WaterThatStandsOnSoilLiftsIt)
{
    for (const double level : {1.5, 3.0})
    {
        const Column column{.load = 0,
                            .ofWater = fmt::format("waterLevel {}; initial {{ type hydrostatic; waterTable {}; }}", level, level),
                            .gravity = "-9.81",
                            .initial = "type geostatic; surface 1; K0 0.428571;",
                            .more = "soil { correctedFrom 0.3; }\nintegration { damping { rate 100; until 1; } }"};
        const CaseScene scene(column.files());
        ASSERT_EQ(scene.errors, "");
        runTo(*scene.simulation, 0.2);
        const auto sigma = scene.simulation->field("sigma").component;
        const auto* const y = scene.simulation->positions().component[1];
        Largest off;
        for (std::size_t i = 0; i < scene.simulation->size(); ++i)
            if (y[i] > 0.1 && y[i] < 0.8) off(sigma[3][i] / (-1000 * 9.81 * (1 - y[i])) - 1);
        EXPECT_LT(off.value(), 0.02) << level;
        EXPECT_LT(pressureError(scene, [&](double depth) { return 9810 * (level - depth); }), 0.005) << level;
    }
}

// A level that falls is that of the step's middle, goes on after a restart, and takes the water in the pores along: quick drainage, so that it follows.
TEST(PoreWater, FollowsALevelThatFalls)
{
    const Column column{.across = 8,
                        .permeability = 0.1,
                        .load = 0,
                        .ofWater = "waterLevel \"3 - 10*min($t, 0.1)\"; initial { type hydrostatic; waterTable 3; }",
                        .gravity = "-9.81",
                        .more = "soil { correctedFrom 0.3; }\nintegration { damping { rate 100; until 1; } }"};
    const CaseScene scene(column.files());
    ASSERT_EQ(scene.errors, "");
    runTo(*scene.simulation, 0.05);
    EXPECT_NEAR(scene.simulation->state().at("waterLevelTime"), 0.05, 1e-12);
    runTo(*scene.simulation, 0.3);
    EXPECT_LT(pressureError(scene, [](double y) { return 9810 * (2 - y); }), 0.01);
}

// Dry soil has none of this.
TEST(PoreWater, IsOnRequest)
{
    auto files = Column{}.files();
    auto& properties = files["constant/soilProperties"];
    properties = properties.substr(0, properties.find("confiningPressure")) + "initialStress { type isotropic; pressure 0; }\n";
    const CaseScene scene(files);
    ASSERT_EQ(scene.errors, "");
    EXPECT_EQ(scene.simulation->field("porePressure").component[0], nullptr);
    EXPECT_FALSE(scene.settings.coefficients.has<PoreWater>());
}

TEST(PoreWater, LevelThatEndsMeanwhileIsNamed)
{
    const CaseScene scene(Column{.load = 0, .ofWater = "waterLevel \"1 + sqrt(0.005 - $t)\";", .gravity = "-9.81"}.files());
    ASSERT_EQ(scene.errors, "");
    EXPECT_PRED2(sph::says, messageOf([&] { runTo(*scene.simulation, 0.02); }),
                 "constant/soilProperties: waterLevel \"1 + sqrt(0.005 - $t)\" at 0.0");
}

// Pores that hold next to nothing would drain and fill in turns.
TEST(PoreWater, WaterTableThatWouldLeapIsRefused)
{
    const CaseScene scene(Dam{.yield = 1e-8}.files());
    ASSERT_EQ(scene.errors, "");
    const auto failure = messageOf([&] { runTo(*scene.simulation, 0.01); });
    EXPECT_PRED2(sph::says, failure, "constant/soilProperties: specificYield 1e-08");
    EXPECT_PRED2(sph::says, failure, "Choose ");
}

TEST(PoreWater, MistakesSayWhereAndWhat)
{
    const auto with = [](const std::string& from, const std::string& to)
    {
        auto files = Column{}.files();
        auto& text = files["constant/soilProperties"];
        text.replace(text.find(from), from.size(), to);
        return CaseScene(files).errors;
    };
    const std::string here = "constant/soilProperties:5: ";
    EXPECT_EQ(with("porosity 0.4", "porosity 0.3"), "");
    EXPECT_PRED2(sph::says, with("porosity 0.4;", ""), here);
    EXPECT_PRED2(sph::says, with("porosity 0.4;", ""), "\"porosity\"");
    EXPECT_PRED2(sph::says, with("porosity 0.4", "porosity 1"), here + "\"porosity\"");
    EXPECT_PRED2(sph::says, with("permeability 0.0007", "permeability -1"), here + "\"permeability\"");
    EXPECT_PRED2(sph::says, with("bulkModulus 2200000000", "bulkModulus 0"), here);
    EXPECT_PRED2(sph::says, with("porosity 0.4;", "porosity 0.4; freeSurface closed;"), here + "no boundary drains");
    EXPECT_PRED2(sph::says, with("porosity 0.4;", "porosity 0.4; walls { floor { porePressure 0; } }"), here + "wall \"floor\" is unknown");
    EXPECT_PRED2(sph::says, with("porosity 0.4;", "porosity 0.4; walls { base { porePressure 0; flux 1; } }"),
                 here + "the wall has a porePressure already");
    EXPECT_PRED2(sph::says, with("permeability 0.0007;", "permeability 0; walls { base { flux 1; } }"),
                 here + "a flux needs a permeability");
    EXPECT_PRED2(sph::says, with("porosity 0.4;", "porosity 0.4; initial { type hydrostatic; waterTable 1; }"),
                 here + "hydrostatic needs gravity");
    EXPECT_PRED2(sph::says, with("porosity 0.4;", "porosity 0.4; projection exact;"),
                 "`projection exact;` of poreWater solves for a divergence");
    EXPECT_PRED2(sph::says, with("porosity 0.4;", "porosity 0.4; waterLevel 1;"), here + "a level of water needs gravity");
    EXPECT_PRED2(sph::says, with("porosity 0.4;", "porosity 0.4; walls { base { waterLevel 1; flux 1e-6; } }"),
                 here + "the wall has a porePressure or a flux already");
    EXPECT_PRED2(sph::says, with("porosity 0.4;", "porosity 0.4; unsaturated { capillaryHead 1; specificYield 0.1; }"),
                 here + "there is no water table without gravity");
    const auto withDam = [](const std::string& from, const std::string& to)
    {
        auto ofDam = Dam{}.files();
        auto& text = ofDam["constant/soilProperties"];
        text.replace(text.find(from), from.size(), to);
        return CaseScene(ofDam).errors;
    };
    EXPECT_PRED2(sph::says, withDam("specificYield 0.0001;", "specificYield 0.5;"),
                 "constant/soilProperties:5: 0.5 is more than the porosity, 0.4");
    EXPECT_PRED2(sph::says, withDam("waterLevel 0.25;", "waterLevel \"vector(1, 0, 0)\";"),
                 "constant/soilProperties:4: \"vector(1, 0, 0)\"");
    EXPECT_PRED2(sph::says, withDam("waterLevel 0.25;", "waterLevel \"1 - $time\";"), "$time is unknown here. Known: $t");
    EXPECT_PRED2(sph::says, withDam("waterLevel 0.25;", "waterLevel \"1 - $x\";"), "$x is unknown here. Known: $t");
    auto dry = Column{.load = 0, .more = "soil { shown (seepageVelocity); }"}.files();
    auto& properties = dry["constant/soilProperties"];
    properties.erase(properties.find("poreWater"));
    EXPECT_PRED2(sph::says, CaseScene(dry).errors, "seepageVelocity is that of `poreWater`");
    auto files = Column{.more = "integration { scheme verlet; }"}.files();
    EXPECT_PRED2(sph::says, CaseScene(files).errors, "take scheme symplecticEuler");
}

}
}
