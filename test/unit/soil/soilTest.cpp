/// Soil by SPH: beside one element of it, in rotation, at rest under gravity; what it conserves; mistakes.
#include "Largest.hpp"
#include "base/CaseError.hpp"
#include "elementTests/ElementTest.hpp"
#include "geometry/makeWallLayers.hpp"
#include "models/soil/ContinuedStress.hpp"
#include "models/soil/SoilFields.hpp"
#include "operators/BalancedGradient.hpp"
#include "periodicSquare.hpp"
#include "scene/Particles.hpp"
#include "scenes.hpp"
#include "soilLaws/soilLaws.hpp"
#include "solver/Simulation.hpp"
#include "solver/models.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <random>

namespace sph::test
{
namespace
{

constexpr double spacing = 0.05;

/// A lone block, without gravity.
Files blockCase(const std::string& initial = "type isotropic; pressure 1e4;", const std::string& ofSoil = "")
{
    auto files = soilCase();
    files.erase("constant/g");
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 3; kernel wendlandC2; }\nsoil { " + ofSoil + " }\n";
    auto& properties = files["constant/soilProperties"];
    properties.replace(properties.find("type geostatic; surface 0.5;"), 28, initial);
    return files;
}

/// n x n (x n) particles about (3 3 3), each put off its place in a lattice by up to `jitter` spacings along each axis.
template<int dim> Cloud block(int n, double jitter)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> any(-jitter, jitter);
    Cloud cloud;
    const auto at = [&](int k) { return 3 + (k + 0.5 - 0.5 * n + any(random)) * spacing; };
    for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b)
            for (int c = 0; c < (dim == 3 ? n : 1); ++c)
            {
                cloud.x.push_back(at(a));
                cloud.y.push_back(at(b));
                cloud.z.push_back(dim == 3 ? at(c) : 0);
            }
    return cloud;
}

void give(Cloud& cloud, const std::string& name, FieldClass type, const std::function<std::vector<double>(std::size_t)>& value)
{
    auto& field = cloud.fields[name];
    field.type = type;
    field.component.resize(std::size_t(componentsOf(type)));
    for (std::size_t i = 0; i < cloud.size(); ++i)
        for (std::size_t c = 0; c < field.component.size(); ++c) field.component[c].push_back(value(i)[c]);
}

Geometry emptySpace(int dimension) { return domain(dimension, {6, 6, dimension == 3 ? 6.0 : 0.0}); }

Settings settingsIn(const Files& files, const Geometry& geometry)
{
    const TestCase folder(files);
    const Case c(folder.folder());
    auto settings = readSettings(c, geometry);
    c.diagnostics().throwIfAny();
    return settings;
}

template<int dim> SymmTensor<3> stressOf(const Particles<dim>& particles, std::size_t i)
{
    StressTensor<dim> sigma;
    const auto arrays = particles.store().pointers(SoilStress{});
    fetch(sigma, [&](int c) { return arrays[std::size_t(c)][i]; });
    return in3D(sigma);
}

/// Moves a block by prescribed velocities L x about its middle, the stress by the model's own stage: x = F(dt) x in each step. `visit(particles, i)` of those whose
/// support was inside.
template<int dim>
void deform(Cloud cloud, const Files& files, double half, Tensor<dim> L, Tensor<dim> F, double deltaT, int steps,
            const std::function<void(const Particles<dim>&, std::size_t)>& visit)
{
    const auto geometry = emptySpace(dim);
    const auto settings = settingsIn(files, geometry);
    give(cloud, "m", FieldClass::scalar,
         [&](std::size_t i) { return std::vector{1850 * std::pow(spacing, dim) * (1 + 1e-9 * double(i))}; }); // numbers them
    Particles<dim> particles(settings, geometry, allTerms<dim>(), cloud, {});
    auto& store = particles.store();
    const auto stages = particles.stages(JoinPoint::afterKick);
    ASSERT_EQ(stages.size(), 1u);
    Vector<dim> middle;
    fetch(middle, [](int) { return 3.0; });
    const double speed = 2 * half * std::sqrt(doubleDot(L, L));
    for (int step = 0; step < steps; ++step)
    {
        particles.evaluate();
        const auto x = store.pointers(Position{}), v = store.pointers(Velocity{});
        for (std::size_t i = 0; i < particles.size(); ++i)
            sph::store(L * (positionOf(store, i) - middle), [&](int c, double q) { v[std::size_t(c)][i] = q; });
        stages[0].run(particles, {0, deltaT, deltaT});
        for (std::size_t i = 0; i < particles.size(); ++i)
            sph::store(middle + F * (positionOf(store, i) - middle), [&](int c, double q) { x[std::size_t(c)][i] = q; });
        particles.moved(speed * deltaT);
    }
    const double reach = settings.resolution.H() + 1.5 * spacing;
    const double* m = store.component("m", 0);
    int inside = 0;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        const auto number = std::size_t(std::lround((m[i] / (1850 * std::pow(spacing, dim)) - 1) * 1e9));
        const double off =
            std::max({std::abs(cloud.x[number] - 3), std::abs(cloud.y[number] - 3), dim == 3 ? std::abs(cloud.z[number] - 3) : 0.0});
        if (off > half - reach) continue;
        ++inside;
        visit(particles, i);
    }
    EXPECT_GT(inside, 20);
}

/// A stress and the state variables that the law has, and both after a strain.
struct ElementOfSoil
{
    SymmTensor<3> stress;
    std::vector<double> variables = {};

    ElementOfSoil after(const Soil& soil, Tensor<3> deformation) const
    {
        return std::visit(
            [&]<class Law>(const Law& law) -> ElementOfSoil
            {
                const auto step = integrateStress(law, stateFrom<StateOf<Law>>(stress, variables), deformation, soil.integration);
                return {step.stress, numbersOf(step.variables)};
            },
            soil.law);
    }
};

ElementOfSoil element(const Files& files, const ElementOfSoil& start, Tensor<3> deformation)
{
    const TestCase folder(files);
    auto soil = readSoil(Case(folder.folder()).dictionary(soilProperties));
    soil.integration.tolerance = 1e-11;
    soil.integration.turning = Turning::within;
    return start.after(soil, deformation);
}

template<int dim> double elementError(int n, double jitter, const Files& files)
{
    Tensor<dim> L{};
    L.yy = -0.01; // oedometer: strain of 1 % in 1 s
    auto F = full(identity(symm(L)));
    const int steps = 20;
    F += 1.0 / steps * L;
    const auto expected = element(files, {{-1e4, 0, 0, -1e4, 0, -1e4}}, in3D(L)).stress;
    Largest worst;
    deform<dim>(block<dim>(n, jitter), files, 0.5 * n * spacing, L, F, 1.0 / steps, steps,
                [&](const auto& particles, std::size_t i) { worst(norm(stressOf(particles, i) - expected) / norm(expected)); });
    return worst.value();
}
// One element of soil within a block of disordered particles, strained alike by 1 % in 20 steps: measured 1.3e-9, the tolerance of the steps that both are made of. Where the correction ends at a
// least eigenvalue of 0.9 some interior particles of 0.2 spacings of disorder are 14 % off, without correction 20 %.
TEST(SoilBlock, UnderHomogeneousStrainIsAnElementTest)
{
    EXPECT_LT(elementError<2>(24, 0, blockCase()), 1e-4);
    EXPECT_LT(elementError<2>(24, 0.2, blockCase()), 1e-4);
    EXPECT_LT(elementError<3>(14, 0.2, blockCase()), 1e-4);
    EXPECT_GT(elementError<2>(24, 0.2, blockCase("type isotropic; pressure 1e4;", "correctedFrom 2;")), 1e-2);
}

/// Sand with void ratio and intergranular strain, fully mobilised by isotropic compression, in place of Wu and Bauer's.
Files ofVoidRatio(Files files, const std::string& start = "voidRatio 0.7; intergranularStrain isotropic;")
{
    files["constant/soilProperties"] =
        "rho 1850;\nlaw vonWolffersdorff;\nvonWolffersdorffCoeffs { phi_c 30; h_s 5.8e9; n 0.28; e_d0 0.53; e_c0 0.84; e_i0 1; alpha 0.13; beta 1.05;\n"
        "intergranularStrain { R 1e-4; m_R 5; m_T 2; beta_r 0.5; chi 6; } }\ninitialStress { type isotropic; pressure 1e4; " +
        start + " }\n";
    return files;
}

// The same with state variables, sheared as well: each is that of the element, its axes turning with the material, and the density goes with the void ratio. The directions of a step are in
// error by the square of its angle, 2.5e-4.
template<int dim> void expectElementOfVoidRatio(int n)
{
    const auto files = ofVoidRatio(blockCase());
    Tensor<dim> L{};
    L.yy = -0.01;
    L.xy = 0.005;
    const int steps = 20;
    auto F = full(identity(symm(L)));
    F += 1.0 / steps * L;
    const double h = -1e-4 / std::numbers::sqrt3;
    const auto expected = element(files, {{-1e4, 0, 0, -1e4, 0, -1e4}, {0.7, h, 0, 0, h, 0, h}}, in3D(L));
    Largest stress, voidRatio, strain, density;
    deform<dim>(block<dim>(n, 0.2), files, 0.5 * n * spacing, L, F, 1.0 / steps, steps,
                [&](const auto& particles, std::size_t i)
                {
                    const auto& store = particles.store();
                    stress(norm(stressOf(particles, i) - expected.stress) / norm(expected.stress));
                    const double e = store.component("voidRatio", 0)[i];
                    voidRatio(e - expected.variables[0]);
                    density(store.component("rho", 0)[i] * (1 + e) / (1850 * 1.7) - 1);
                    StressTensor<dim> of;
                    fetch(of, [&](int c) { return store.component("intergranularStrain", c)[i]; });
                    SymmTensor<3> its;
                    fetch(its, [&](int c) { return expected.variables[std::size_t(c) + 1]; });
                    strain(norm(in3D(of) - its) / 1e-4);
                });
    EXPECT_LT(stress.value(), 1e-3);
    EXPECT_LT(voidRatio.value(), 1e-6);
    EXPECT_LT(strain.value(), 1e-3);
    EXPECT_LT(density.value(), 1e-12);
}
TEST(SoilBlock, WithStateVariablesIsAnElementTest)
{
    expectElementOfVoidRatio<2>(24);
    expectElementOfVoidRatio<3>(14);
}

// Half a run, written and read, then the other half, is the run: state variables, and what the balanced gradient carries, are in time folders with all their components.
TEST(SoilBlock, GoesOnWithItsStateVariables)
{
    auto files = ofVoidRatio(soilCase());
    auto& properties = files["constant/soilProperties"];
    properties.replace(properties.find("type isotropic; pressure 1e4;"), 29, "type geostatic; surface 0.5; K0 0.5;");
    files["system/controlDict"] = "application sphFoamLike; startFrom startTime; startTime 0; stopAt endTime; endTime 0.02;\n"
                                  "adjustTimeStep yes; writeControl adjustableRunTime; writeInterval 0.01; writeFormat binary;\n";
    files["system/sphSchemes"] += "soil { stressDivergence balanced; hourglassStiffness 0.5; }\n";
    const TestCase whole(files);
    for (const auto* application : {"packParticles", "meshToGhost", "sphFoamLike"}) whole.runWell(application);
    whole.replace("system/controlDict", "startTime 0;", "startTime 0.01;");
    const auto read = [&]
    {
        std::string all;
        for (const auto* field : {"voidRatio", "intergranularStrain", "sigma", "rho", "gradientOffset", "unstrainedMotion", "positions"})
            all += whole.read(std::string("0.02/lagrangian/sph/") + field);
        return all;
    };
    const auto once = read();
    std::filesystem::remove_all(whole.folder() / "0.02");
    whole.runWell("sphFoamLike");
    EXPECT_EQ(read(), once);
}

// A stress of unequal principal values turns with the block, at 90 steps a turn: by the exact angle of each step; measured 2e-13.
TEST(SoilBlock, TurnedOnceHasTheStressItHad)
{
    const int steps = 90;
    const double angle = 2 * std::numbers::pi / steps;
    const Tensor<2> L{0, -1, 1, 0}, Q{std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)};
    auto cloud = block<2>(24, 0.2);
    give(cloud, "sigma", FieldClass::symmTensor, [](std::size_t) { return std::vector<double>{-1e4, 1e3, 0, -2e4, 0, -8e3}; });
    const SymmTensor<3> expected{-1e4, 1e3, 0, -2e4, 0, -8e3};
    for (const auto* ofSoil : {"", "stressDivergence balanced; hourglassStiffness 0.5;"})
    {
        SCOPED_TRACE(ofSoil);
        Largest worst, ofNorm;
        deform<2>(cloud, blockCase("type isotropic; pressure 1e4;", ofSoil), 12 * spacing, L, Q, angle, steps,
                  [&](const auto& particles, std::size_t i)
                  {
                      worst(norm(stressOf(particles, i) - expected) / norm(expected));
                      ofNorm(norm(stressOf(particles, i)) / norm(expected) - 1);
                  });
        EXPECT_LT(worst.value(), 1e-6);
        EXPECT_LT(ofNorm.value(), 1e-6);
    }
}

/// A smooth flow about (3 3): everything is compressed by 1 in 1 s at first, and some of it more than the rest. v [m/s] and grad v [1/s].
constexpr double waves = std::numbers::pi;
Vector<2> flowAt(Vector<2> x)
{
    const double k = waves;
    return {-0.6 * (x.x - 3) + 0.2 / k * std::sin(k * x.x) * std::cos(k * x.y),
            -0.8 * (x.y - 3) + 0.3 / k * std::cos(k * x.x) * std::sin(k * x.y)};
}
Tensor<2> gradientAt(Vector<2> x)
{
    const double k = waves, sx = std::sin(k * x.x), cx = std::cos(k * x.x), sy = std::sin(k * x.y), cy = std::cos(k * x.y);
    return {-0.6 + 0.2 * cx * cy, -0.2 * sx * sy, -0.3 * sx * sy, -0.8 + 0.3 * cx * cy};
}
/// Position carried by the flow, fourth order in dt [s].
Vector<2> carried(Vector<2> x, double dt)
{
    const auto a = flowAt(x), b = flowAt(x + 0.5 * dt * a), c = flowAt(x + 0.5 * dt * b), d = flowAt(x + dt * c);
    return x + dt / 6 * (a + 2 * b + 2 * c + d);
}

/// A square block about (3 3) of particles dx apart, off their lattice by up to `jitter` spacings along each axis; `inner` is half the side of what is looked at, two of the widest supports inside.
struct SmoothBlock
{
    static constexpr double inner = 0.4, outer = inner + 0.45;
    Geometry geometry = emptySpace(2);
    Settings settings;
    Cloud cloud;
    std::unique_ptr<Particles<2>> particles;
    double mass;

    SmoothBlock(const std::string& properties, double dx, double jitter, const std::string& ofSoil) : mass(1850 * dx * dx)
    {
        auto files = blockCase();
        files["constant/soilProperties"] = properties;
        files["system/sphSchemes"] = fmt::format("resolution {{ spacing {}; support 3; kernel wendlandC2; }}\nsoil {{ {} }}\n", dx, ofSoil);
        settings = settingsIn(files, geometry);
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> any(-jitter * dx, jitter * dx);
        const int n = int(std::lround(2 * outer / dx));
        for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b)
            {
                cloud.x.push_back(3 + (a + 0.5 - 0.5 * n) * dx + any(random));
                cloud.y.push_back(3 + (b + 0.5 - 0.5 * n) * dx + any(random));
                cloud.z.push_back(0);
            }
        give(cloud, "m", FieldClass::scalar, [&](std::size_t i) { return std::vector{mass * (1 + 1e-9 * double(i))}; }); // numbers them
        particles = std::make_unique<Particles<2>>(settings, geometry, allTerms<2>(), cloud, Numbers{});
    }
    /// Calls f(particle, where it was at the start) for those inside.
    void forEachInside(const std::function<void(std::size_t, Vector<2>)>& f) const
    {
        const double* const m = particles->store().component("m", 0);
        for (std::size_t i = 0; i < particles->size(); ++i)
        {
            const auto number = std::size_t(std::lround((m[i] / mass - 1) * 1e9));
            const Vector<2> x{cloud.x[number], cloud.y[number]};
            if (std::max(std::abs(x.x - 3), std::abs(x.y - 3)) < inner) f(i, x);
        }
    }
};

/// Soil at rest until its gradient is balanced, where the scene balances it.
void balance(Particles<2>& particles)
{
    if (!particles.store().has(GradientOffset{})) return;
    for (int sweep = 0; sweep < 30; ++sweep)
    {
        particles.evaluate();
        particles.stages(JoinPoint::afterKick)[0].run(particles, {0, 0, 0});
    }
}

/// Carried by the flow for 0.01 s, in 20 steps; the stress is advanced by the model's own stage in the middle of each. What it is off, over its change, both in the mean of squares; it is compared
/// with the law along the path of each particle, in 200 steps of constant grad v.
double stressError(const std::string& law, double dx, double jitter, const std::string& ofSoil = "")
{
    const SmoothBlock block("rho 1850; " + law + "initialStress { type isotropic; pressure 1e4; }\n", dx, jitter, ofSoil);
    auto& particles = *block.particles;
    auto& store = particles.store();
    const auto stages = particles.stages(JoinPoint::afterKick);
    const int steps = 20, ofPath = 10;
    const double dt = 0.01 / steps, fine = dt / ofPath;
    const auto carry = [&](double by)
    {
        const auto x = store.pointers(Position{});
        for (std::size_t i = 0; i < particles.size(); ++i)
            sph::store(carried(positionOf(store, i), by), [&](int c, double q) { x[std::size_t(c)][i] = q; });
        particles.moved(2 * by);
    };
    carry(0.5 * dt);
    for (int step = 0; step < steps; ++step)
    {
        particles.evaluate();
        const auto v = store.pointers(Velocity{});
        for (std::size_t i = 0; i < particles.size(); ++i)
            sph::store(flowAt(positionOf(store, i)), [&](int c, double q) { v[std::size_t(c)][i] = q; });
        stages[0].run(particles, {0, dt, dt});
        carry(dt);
    }
    const auto& soil = block.settings.coefficients.of<Soil>();
    double off = 0, change = 0;
    block.forEachInside(
        [&](std::size_t i, Vector<2> x)
        {
            const SymmTensor<3> start{-1e4, 0, 0, -1e4, 0, -1e4};
            auto expected = start;
            for (int k = 0; k < steps * ofPath; ++k)
            {
                const auto L = fine * in3D(gradientAt(carried(x, 0.5 * fine)));
                expected = ElementOfSoil{expected}.after(soil, L).stress;
                x = carried(x, fine);
            }
            off += sqr(norm(stressOf(particles, i) - expected));
            change += sqr(norm(expected - start));
        });
    return std::sqrt(off / change);
}

/// What the acceleration by a smooth stress is off, over div(sigma)/rho, both in the mean of squares.
double divergenceError(double dx, double jitter, const std::string& ofSoil = "")
{
    const SmoothBlock block("rho 1850; law elastic; elasticCoeffs { E 2e7; nu 0.3; }\n", dx, jitter, ofSoil);
    auto& particles = *block.particles;
    balance(particles);
    auto& store = particles.store();
    const auto sigma = store.pointers(SoilStress{});
    const double k = waves;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        const auto x = positionOf(store, i);
        const double a = 3e3 * std::sin(k * x.x) * std::cos(k * x.y);
        sph::store(stressIn<2>({a - 1e4, 0.5 * a, 0, -a - 1e4, 0, -1e4}), [&](int c, double q) { sigma[std::size_t(c)][i] = q; });
    }
    particles.evaluate();
    const auto acceleration = std::as_const(store).pointers(Acceleration{});
    double off = 0, all = 0;
    block.forEachInside(
        [&](std::size_t i, Vector<2> x)
        {
            const double a_x = 3e3 * k * std::cos(k * x.x) * std::cos(k * x.y), a_y = -3e3 * k * std::sin(k * x.x) * std::sin(k * x.y);
            const Vector<2> expected{(a_x + 0.5 * a_y) / 1850, (0.5 * a_x - a_y) / 1850};
            off += sqr(mag(Vector<2>{acceleration[0][i], acceleration[1][i]} - expected));
            all += sqr(mag(expected));
        });
    return std::sqrt(off / all);
}

/// Order of the errors at 0.1, 0.05 and 0.025.
double orderOf(const std::function<double(double)>& error) { return 0.5 * std::log2(error(0.1) / error(0.025)); }

// Order with the corrected gradient, measured: 1.89 on a lattice, 1.89 and 1.75 at 0.1 and 0.2 spacings off it (elastic; hypoplastic 1.87, 1.88, 1.71), errors at 0.025 of 1.1e-3 to 1.5e-3 (2.2e-3 to 3e-3). Off the lattice
// it is first order in the end: 1.69 and 1.00 from 0.025 to 0.0125. Without correction 1.0 on the lattice, and 0.2 and 0 off it, where 2 to 4 % of the stress (4 to 9 %) are lost at any spacing.
TEST(SoilBlock, StressOfASmoothFlowIsOfSecondOrder)
{
    for (const std::string law :
         {"law elastic; elasticCoeffs { E 2e7; nu 0.3; }\n", "law wuBauer; wuBauerCoeffs { c1 -69.4; c2 -673.1; c3 -655.9; c4 699.6; }\n"})
        for (const double jitter : {0.0, 0.1, 0.2})
        {
            SCOPED_TRACE(law + std::to_string(jitter));
            EXPECT_GT(orderOf([&](double dx) { return stressError(law, dx, jitter); }), 1.5);
            if (jitter == 0) continue;
            EXPECT_LT(orderOf([&](double dx) { return stressError(law, dx, jitter, "correctedFrom 2;"); }), 0.5);
        }
}

// The symmetric form conserves momentum, and has no order where particles are off a lattice: a uniform stress then accelerates them, by its size times the disorder over the spacing. Measured 1.64 on
// the lattice, -1.04 and -1.06 at 0.1 and 0.2 spacings off it.
TEST(SoilBlock, DivergenceOfASmoothStressConvergesOnALatticeAlone)
{
    EXPECT_GT(orderOf([](double dx) { return divergenceError(dx, 0); }), 1.5);
    EXPECT_NEAR(orderOf([](double dx) { return divergenceError(dx, 0.1); }), -1, 0.2);
}
// The form of differences converges: measured orders 1.98, 1.87 and 1.68, errors of 0.4 to 0.6 % at 0.025.
TEST(SoilBlock, CorrectedDivergenceOfASmoothStressConverges)
{
    for (const double jitter : {0.0, 0.1, 0.2})
    {
        SCOPED_TRACE(jitter);
        EXPECT_GT(orderOf([&](double dx) { return divergenceError(dx, jitter, "stressDivergence corrected;"); }), 1.5);
        EXPECT_LT(divergenceError(0.025, jitter, "stressDivergence corrected;"), 0.01);
    }
}

// The balanced form, which is the adjoint of a gradient and conserves momentum, is of second order on a lattice. Off it single forces are 8 and 15 % off at any spacing, where those of the symmetric form are
// off the more the finer it is; what converges is the weak form, and with it the solution (SoilColumn.IsCalmOffItsLattice). Measured orders 1.97, 0.13 and -0.06.
TEST(SoilBlock, BalancedDivergenceOfASmoothStressIsBounded)
{
    const auto error = [](double dx, double jitter) { return divergenceError(dx, jitter, "stressDivergence balanced;"); };
    EXPECT_GT(orderOf([&](double dx) { return error(dx, 0); }), 1.8);
    for (const double jitter : {0.1, 0.2})
    {
        SCOPED_TRACE(jitter);
        EXPECT_NEAR(orderOf([&](double dx) { return error(dx, jitter); }), 0, 0.2);
        EXPECT_LT(error(0.025, jitter), jitter);
    }
}

/// A lone block of 16 x 16 particles 0.2 spacings off their lattice with random velocities and stresses.
Cloud shakenBlock()
{
    auto cloud = block<2>(16, 0.2);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    give(cloud, "U", FieldClass::vector, [&](std::size_t) { return std::vector<double>{any(random), 1 + any(random), 0}; });
    give(cloud, "sigma", FieldClass::symmTensor,
         [&](std::size_t) {
             return std::vector<double>{-1e4 * (2 + any(random)), 3e3 * any(random), 0, -1e4 * (2 + any(random)), 0,
                                        -1e4 * (2 + any(random))};
         });
    return cloud;
}

// The balanced divergence is the adjoint of its gradient, whatever stress and velocity are: the power of its forces is minus that of the stress. The symmetric one differs by a tenth.
TEST(SoilBlock, BalancedForcesHaveThePowerOfTheStrain)
{
    const auto geometry = emptySpace(2);
    const auto misfit = [&](const std::string& form)
    {
        const auto settings =
            settingsIn(blockCase("type isotropic; pressure 1e4;", "artificialViscosity 0; stressDivergence " + form + ";"), geometry);
        Particles<2> particles(settings, geometry, allTerms<2>(), shakenBlock(), {});
        balance(particles);
        particles.evaluate();
        particles.evaluate(ofStrain);
        const auto& store = std::as_const(particles.store());
        const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{});
        const auto S = store.pointers(ActingStress{});
        const auto L = store.pointers(VelocityGradient{});
        const double *m = store.component("m", 0), *V = store.component("V", 0);
        double ofForces = 0, ofStress = 0;
        for (std::size_t i = 0; i < particles.size(); ++i)
        {
            ofForces += m[i] * (v[0][i] * a[0][i] + v[1][i] * a[1][i]);
            ofStress -= V[i] * (S[0][i] * L[0][i] + S[1][i] * (L[1][i] + L[2][i]) + S[2][i] * L[3][i]);
        }
        return std::abs(ofForces / ofStress - 1);
    };
    EXPECT_LT(misfit("balanced"), 1e-12);
    EXPECT_GT(misfit("symmetric"), 0.01);
}

/// Largest acceleration of a block 0.2 spacings off its lattice, free of stress, by a displacement that is linear in space but for one particle of `more` [m].
double hourglassAcceleration(double more)
{
    auto cloud = block<2>(16, 0.2);
    give(cloud, "unstrainedMotion", FieldClass::vector,
         [&](std::size_t i) {
             return std::vector<double>{0.03 * (cloud.x[i] - 3) + 0.07 * (cloud.y[i] - 3) + (i == 100) * more, -0.04 * (cloud.y[i] - 3), 0};
         });
    auto files = blockCase("type isotropic; pressure 1e4;", "artificialViscosity 0; stressDivergence balanced; hourglassStiffness 0.2;");
    files["constant/soilProperties"] = "rho 1850; law elastic; elasticCoeffs { E 1e7; nu 0.3; }\n";
    const auto geometry = emptySpace(2);
    const auto settings = settingsIn(files, geometry);
    const auto simulation = makeSimulation(settings, geometry, cloud, {});
    simulation->step(0, 1e-12);
    const auto& a = simulation->field("dUdt").component;
    Largest largest;
    for (std::size_t i = 0; i < simulation->size(); ++i) largest(std::hypot(a[0][i], a[1][i]));
    return largest.value();
}
// A displacement that is linear in space meets no hourglass stiffness, up to the surface; that of one particle does.
TEST(Hourglass, LeavesALinearDisplacementAlone)
{
    const double alone = hourglassAcceleration(0.01 * spacing);
    EXPECT_GT(alone, 100);
    EXPECT_LT(hourglassAcceleration(0), 1e-9 * alone);
}

// A lone block with random velocities and stresses, which artificial viscosity and stress divergence act on: pairs exchange what they lose.
TEST(SoilBlock, KeepsItsMomentum)
{
    const auto geometry = emptySpace(2);
    for (const auto* ofSoil : {"viscosityActs onApproach;", "viscosityActs always;", "viscosityActs onNoise;",
                               "stressDivergence balanced; hourglassStiffness 0.2; viscosityActs onNoise;"})
    {
        SCOPED_TRACE(ofSoil);
        const auto settings = settingsIn(blockCase("type isotropic; pressure 1e4;", ofSoil), geometry);
        const auto simulation = makeSimulation(settings, geometry, shakenBlock(), {});
        const auto before = simulation->summary().momentum;
        const double energy = simulation->summary().kineticEnergy;
        for (int step = 0; step < 50; ++step) simulation->step(0, simulation->stepLimit().deltaT);
        EXPECT_LT(mag(simulation->summary().momentum - before), 1e-12 * mag(before));
        EXPECT_LT(simulation->summary().kineticEnergy, energy);
        EXPECT_GT(simulation->summary().columns.at("maxSoundSpeed"), 10);
    }
}

/// Largest acceleration inside of a block of 16 x 16 particles 0.2 spacings off their lattice, free of stress, with velocities of up to 1 m/s that are linear in space, but for one particle of `more`: by viscosity alone.
double viscousAcceleration(const std::string& acts, double more)
{
    auto cloud = block<2>(16, 0.2);
    std::size_t one = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (std::hypot(cloud.x[i] - 3, cloud.y[i] - 3) < std::hypot(cloud.x[one] - 3, cloud.y[one] - 3)) one = i;
    const double half = 8 * spacing;
    give(cloud, "U", FieldClass::vector,
         [&](std::size_t i)
         {
             return std::vector<double>{(0.3 * (cloud.x[i] - 3) + 0.7 * (cloud.y[i] - 3)) / half + (i == one) * more,
                                        -0.4 * (cloud.y[i] - 3) / half, 0};
         });
    auto files = blockCase("type isotropic; pressure 1e4;", "viscosityActs " + acts + ";");
    files["constant/soilProperties"] = "rho 1850; law elastic; elasticCoeffs { E 1e7; nu 0.3; }\n";
    const auto geometry = emptySpace(2);
    const auto settings = settingsIn(files, geometry);
    const auto simulation = makeSimulation(settings, geometry, cloud, {});
    simulation->step(0, 1e-9);
    const auto &x = simulation->positions().component, &a = simulation->field("dUdt").component;
    Largest inside;
    for (std::size_t i = 0; i < simulation->size(); ++i)
        if (std::max(std::abs(x[0][i] - 3), std::abs(x[1][i] - 3)) < half - 4 * 3.6 * spacing / 2) inside(std::hypot(a[0][i], a[1][i]));
    EXPECT_GT(inside.value(), 0);
    return inside.value();
}

// Of viscosity on noise a smooth flow feels rounding alone, and a particle that goes its own way as much as by the other kind.
TEST(SoilViscosity, OnNoiseLeavesALinearVelocityAlone)
{
    EXPECT_LT(viscousAcceleration("onNoise", 0), 1e-9 * viscousAcceleration("always", 0));
    EXPECT_GT(viscousAcceleration("onNoise", 1), 0.5 * viscousAcceleration("always", 1));
}

/// A lone block of Drucker and Prager's soil with random velocities, free of stress at the start, after 50 steps: the largest shear strain,
/// and the largest and the least plastic one; and how much the latter is beyond the former.
struct ShakenBlock
{
    Largest shear, plastic, beyond;
    double leastPlastic = 1;

    explicit ShakenBlock(double cohesion)
    {
        auto files = blockCase("type isotropic; pressure 1e4;", "shown ( shearStrain plasticShearStrain );");
        files["constant/soilProperties"] =
            fmt::format("rho 1850; law druckerPrager; druckerPragerCoeffs {{ E 2e6; nu 0.3; frictionAngle 30; cohesion {}; }}\n"
                        "initialStress {{ type isotropic; pressure 0; }}\n",
                        cohesion);
        auto cloud = block<2>(16, 0.1);
        std::mt19937_64 random(8);
        std::uniform_real_distribution<double> any(-1, 1);
        give(cloud, "U", FieldClass::vector, [&](std::size_t) { return std::vector<double>{any(random), any(random), 0}; });
        const auto geometry = emptySpace(2);
        const auto settings = settingsIn(files, geometry);
        const auto simulation = makeSimulation(settings, geometry, cloud, {});
        for (int step = 0; step < 50; ++step) simulation->step(0, simulation->stepLimit().deltaT);
        const double *gamma = simulation->field("shearStrain").component[0],
                     *gamma_p = simulation->field("plasticShearStrain").component[0];
        for (std::size_t i = 0; i < simulation->size(); ++i)
        {
            shear(gamma[i]);
            plastic(gamma_p[i]);
            beyond(std::max(0.0, gamma_p[i] - gamma[i]));
            leastPlastic = std::min(leastPlastic, gamma_p[i]);
        }
    }
};
// Strong soil that swings has shear strain, and of it no plastic part but for rounding; weak soil yields everywhere, and what is plastic of
// its strain is positive. A path that turns back can have more plastic than total strain by what the elastic part gives back, which here is
// at most the strength over G, 3e-4, a turn.
TEST(SoilBlock, ElasticOscillationIsNoPlasticStrain)
{
    const ShakenBlock strong(1e7), weak(100);
    EXPECT_GT(strong.shear.value(), 0.01);
    EXPECT_LT(strong.plastic.value(), 1e-14);
    EXPECT_GT(weak.plastic.value(), 0.01);
    EXPECT_GT(weak.leastPlastic, 0);
    EXPECT_LT(weak.beyond.value(), 50 * 3e-4);
}
// A scene that does not ask for it has no such field.
TEST(SoilBlock, PlasticStrainIsOnRequest)
{
    const auto geometry = emptySpace(2);
    const auto settings = settingsIn(blockCase(), geometry);
    const auto simulation = makeSimulation(settings, geometry, block<2>(4, 0), {});
    EXPECT_EQ(simulation->field("plasticShearStrain").component[0], nullptr);
}

/// A block of soil whose stress is sigma(x, y, number of the particle), after `steps` of the model's own stage at rest, or sheared at 1/s; f(particles, i, sigma at the start).
void smoothed(const std::string& ofSoil, int steps, double deltaT, double shear,
              const std::function<SymmTensor<3>(double, double, std::size_t)>& sigma,
              const std::function<void(SymmTensor<3>, SymmTensor<3>)>& visit)
{
    auto cloud = block<2>(20, 0.2);
    give(cloud, "sigma", FieldClass::symmTensor,
         [&](std::size_t i)
         {
             const auto s = sigma(cloud.x[i], cloud.y[i], i);
             return std::vector{s.xx, s.xy, s.xz, s.yy, s.yz, s.zz};
         });
    const auto geometry = emptySpace(2);
    const auto settings = settingsIn(blockCase("type isotropic; pressure 1e4;", ofSoil), geometry);
    Particles<2> particles(settings, geometry, allTerms<2>(), cloud, {});
    std::vector<SymmTensor<3>> start;
    particles.evaluate();
    for (std::size_t i = 0; i < particles.size(); ++i) start.push_back(stressOf(particles, i));
    const auto v = particles.store().pointers(Velocity{});
    for (std::size_t i = 0; i < particles.size(); ++i) v[0][i] = shear * positionOf(particles.store(), i).y;
    for (int step = 0; step < steps; ++step) particles.stages(JoinPoint::afterKick)[0].run(particles, {0, deltaT, deltaT});
    for (std::size_t i = 0; i < particles.size(); ++i) visit(start[i], stressOf(particles, i));
}
// A stress that is linear in space stays as it is, at every particle, those at the edge of the block included.
TEST(StressSmoothing, LeavesALinearStressAlone)
{
    Largest worst;
    smoothed(
        "stressSmoothing 0.5; smoothingActs always;", 10, 1e-3, 0,
        [](double x, double y, std::size_t)
        { return SymmTensor<3>{-1e4 + 3e3 * (x - 3), 1e3 * (y - 3), 0, -2e4 + 8e3 * (y - 3), 0, -1e4}; },
        [&](SymmTensor<3> before, SymmTensor<3> after) { worst(norm(after - before) / norm(before)); });
    EXPECT_LT(worst.value(), 1e-12);
}
// Noise of 20 % in stripes of a spacing: left as it is in soil at rest, unless smoothing acts `always`, delta c t/h = 5, and smoothed where soil is strained, by a turn of 1/(250 delta).
TEST(StressSmoothing, TakesNoiseWhereSoilIsStrained)
{
    const auto left = [](const std::string& ofSoil, double shear)
    {
        double noise = 0, n = 0;
        smoothed(
            ofSoil, 50, 1e-3, shear,
            [](double, double, std::size_t i) { return (1 + (i % 2 ? 0.2 : -0.2)) * SymmTensor<3>{-1e4, 0, 0, -1e4, 0, -1e4}; },
            [&](SymmTensor<3> before, SymmTensor<3> after)
            {
                noise += (trace(after) / -3e4 - 1) * (trace(before) < -3e4 ? 1 : -1);
                ++n;
            });
        return noise / n;
    };
    EXPECT_NEAR(left("stressSmoothing 0.1;", 0), 0.2, 1e-12);
    EXPECT_LT(std::abs(left("stressSmoothing 0.1; smoothingActs always;", 0)),
              0.03); // measured 0.020: a slope across the block is no noise
    const double strained = left("", 0.8), smoothed = left("stressSmoothing 0.1;", 0.8);
    EXPECT_LT(smoothed, 0.5 * strained) << strained;
}

// Soil that its flow has made denser than 1.05 of its density at rest pushes itself apart by c^2 (rho - 1.05 rho_0); nothing of it below.
TEST(SoilBlock, DenserThanAtRestPushesItselfApart)
{
    const auto geometry = emptySpace(2);
    const auto settings = settingsIn(blockCase("type isotropic; pressure 1e4;", "compactionSpeed 30;"), geometry);
    auto cloud = block<2>(10, 0);
    give(cloud, "rho", FieldClass::scalar, [](std::size_t i) { return std::vector{1850 * (i < 50 ? 1.1 : 1.04)}; });
    Particles<2> particles(settings, geometry, allTerms<2>(), cloud, {});
    particles.evaluate();
    const auto S = particles.store().pointers(ActingStress{});
    const double* rho = particles.store().component("rho", 0);
    for (std::size_t i = 0; i < particles.size(); ++i)
        EXPECT_NEAR(S[0][i], -1e4 + 10 - (rho[i] > 1.05 * 1850 ? 900 * 0.05 * 1850 : 0), 1e-6);
}

/// The block's case under a confining pressure of 10 kPa.
Files confinedCase(const std::string& ofSoil = "")
{
    auto files = blockCase("type isotropic; pressure 1e4;", ofSoil);
    files["constant/soilProperties"] += "confiningPressure 1e4;\n";
    return files;
}

// Under the pressure that its free surfaces carry a block is at rest, however its particles lie; without it, it flies apart.
TEST(ConfiningPressure, HoldsAFreeBlock)
{
    const auto geometry = emptySpace(2);
    for (const std::string ofSoil : {"", "stressDivergence corrected;", "stressDivergence balanced; hourglassStiffness 0.2;"})
    {
        const auto energy = [&](const Files& files)
        {
            const auto settings = settingsIn(files, geometry);
            const auto simulation = makeSimulation(settings, geometry, block<2>(12, 0.2), {});
            for (int step = 0; step < 50; ++step) simulation->step(0, simulation->stepLimit().deltaT);
            return simulation->summary().kineticEnergy;
        };
        EXPECT_LT(energy(confinedCase(ofSoil)), 1e-20);
        EXPECT_GT(energy(blockCase("type isotropic; pressure 1e4;", ofSoil)), 1);
    }
}

/// A specimen 0.5 m wide and high between smooth platens that have come together by 2 %.
struct Pressed
{
    std::vector<SymmTensor<3>> stress;
    double highest = 0, widening = 0, energy = 0, supplied = 0; ///< [m], -, [J]

    Pressed(const Files& files, double speed)
    {
        auto geometry = emptySpace(2);
        addWall(geometry, Plane({0, 2.75, 0}, {0, 1, 0}));
        addWall(geometry, Plane({0, 3.25, 0}, {0, -1, 0}));
        for (auto& wall : geometry.walls) wall.slips = true;
        geometry.walls[1].velocity = {0, -speed, 0};
        repeatPeriodically(geometry, 1.5 * 3 * spacing);
        const auto settings = settingsIn(files, geometry);
        const auto cloud = block<2>(10, 0);
        const auto simulation = makeSimulation(settings, geometry, cloud, {});
        for (double time = 0; time < 0.01 / speed - 1e-12;)
        {
            const double deltaT = std::min(simulation->stepLimit().deltaT, 0.01 / speed - time);
            simulation->step(time, deltaT);
            time += deltaT;
        }
        const auto sigma = simulation->field("sigma").component;
        const auto x = simulation->positions().component;
        for (std::size_t i = 0; i < simulation->size(); ++i)
        {
            SymmTensor<3> s;
            fetch(s, [&](int c) { return sigma[std::size_t(c)] ? sigma[std::size_t(c)][i] : 0.0; });
            stress.push_back(s);
        }
        const auto extent = std::ranges::minmax_element(x[0], x[0] + simulation->size());
        highest = *std::ranges::max_element(x[1], x[1] + simulation->size());
        widening = (*extent.max - *extent.min) / (9 * spacing) - 1;
        energy = simulation->energy().held();
        supplied = simulation->energy().supplied;
    }
};

// Platens that come together slowly make each particle of a specimen under confining pressure a biaxial test.
TEST(ConfiningPressure, BetweenPlatensIsABiaxialTest)
{
    const auto files = confinedCase("correctedFrom 0.3;");
    const TestCase folder(files);
    const auto soil = readSoil(Case(folder.folder()).dictionary(soilProperties));
    ElementTest biaxial{
        .name = "biaxial", .type = "biaxial", .pathAxis = "", .stress = {-1e4, 0, 0, -1e4, 0, -1e4}, .legs = {}, .where = {}};
    biaxial.legs.push_back({{0, 0, 0, 0, std::log(0.98), 0, 0, 0, 0}, 0.02, {heldComponent(&SymmTensor<3>::xx)}});
    const auto expected = runElementTest(soil, biaxial).back();
    const Pressed pressed(files, 0.02);
    Largest worst;
    for (const auto& s : pressed.stress) worst(norm(s - expected.stress) / norm(expected.stress));
    EXPECT_LT(worst.value(), 0.02);
    EXPECT_NEAR(pressed.widening / std::expm1(expected.strain.xx), 1, 0.02);
    EXPECT_NEAR(pressed.highest, 3.24 - 0.5 * spacing * 0.98, 0.02 * spacing);
    EXPECT_LT(pressed.energy, pressed.supplied) << "what platens do is supplied";
}

// A lone grain on the floor has no neighbours to rub at: without slip it stays where it touches it, else it slides on. On layers, too, which it feels as bumps where they slip.
TEST(SoilWall, StopsALoneGrain)
{
    for (const auto& [slips, layered] : {std::pair{false, false}, {true, false}, {false, true}})
    {
        auto geometry = emptySpace(2);
        addWall(geometry, Plane({0, 0, 0}, {0, 1, 0}));
        geometry.walls[0].slips = slips;
        repeatPeriodically(geometry, 5 * spacing);
        Diagnostics none;
        if (layered) geometry.layers = makeWallLayers(geometry, 3 * spacing, spacing, none);
        auto files = blockCase("type isotropic; pressure 10;");
        files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);\n";
        if (layered) files["system/sphSchemes"] += "walls layers;\n";
        Cloud cloud;
        cloud.x = {3};
        cloud.y = {0.1 * spacing};
        cloud.z = {0};
        give(cloud, "U", FieldClass::vector, [](std::size_t) { return std::vector<double>{1, -1, 0}; });
        const auto settings = settingsIn(files, geometry);
        const auto simulation = makeSimulation(settings, geometry, cloud, {});
        for (int step = 0; step < 50; ++step) simulation->step(0, simulation->stepLimit().deltaT);
        const auto p = simulation->summary().momentum;
        EXPECT_NEAR(p.x, slips ? 1850 * sqr(spacing) : 0, 1e-3);
    }
}

// A platen that comes up takes a lone grain along, at its own speed.
TEST(SoilWall, ThatMovesLiftsALoneGrain)
{
    auto geometry = emptySpace(2);
    addWall(geometry, Plane({0, 0, 0}, {0, 1, 0}));
    geometry.walls[0].slips = true;
    geometry.walls[0].velocity = {0, 1, 0};
    repeatPeriodically(geometry, 1.5 * spacing);
    Cloud cloud;
    cloud.x = {3};
    cloud.y = {0.1 * spacing};
    cloud.z = {0};
    const auto settings = settingsIn(blockCase("type isotropic; pressure 10;"), geometry);
    const auto simulation = makeSimulation(settings, geometry, cloud, {});
    double time = 0;
    while (time < spacing)
    {
        const double deltaT = std::min(simulation->stepLimit().deltaT, 0.02 * spacing);
        simulation->step(time, deltaT);
        time += deltaT;
    }
    EXPECT_NEAR(simulation->summary().momentum.y / (1850 * sqr(spacing)), 1, 0.01);
    EXPECT_NEAR(simulation->positions().component[1][0], time + 0.02 * spacing, 0.01 * spacing);
}

// A grain that is thrown at a floor of friction mu loses mu times of its velocity along it what the floor gives it across, until it stops: mu (v_y + 1 m/s + g t).
TEST(SoilWall, SlowsALoneGrainByCoulombsLaw)
{
    for (const int steps : {20, 2000})
    {
        auto geometry = emptySpace(2);
        addWall(geometry, Plane({0, 0, 0}, {0, 1, 0}));
        geometry.walls[0].frictionAngle = 20;
        repeatPeriodically(geometry, 1.5 * spacing);
        auto files = blockCase("type isotropic; pressure 10;", "artificialViscosity 0;");
        files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);\n";
        Cloud cloud;
        cloud.x = {3};
        cloud.y = {0.03 * spacing};
        cloud.z = {0};
        give(cloud, "U", FieldClass::vector, [](std::size_t) { return std::vector<double>{1, -1, 0}; });
        const auto settings = settingsIn(files, geometry);
        const auto simulation = makeSimulation(settings, geometry, cloud, {});
        double time = 0;
        for (int step = 0; step < steps; ++step)
        {
            const double deltaT = simulation->stepLimit().deltaT;
            simulation->step(time, deltaT);
            time += deltaT;
        }
        const double mu = std::tan(20 * std::numbers::pi / 180), mass = 1850 * sqr(spacing);
        const auto p = simulation->summary().momentum;
        EXPECT_NEAR(p.x / mass, std::max(0.0, 1 - mu * (p.y / mass + 1 + 9.81 * time)), 0.02) << time;
    }
}

/// Mean acceleration along a floor of friction angle 20 degrees, inclined by `degrees`, of an endless layer of elastic soil.
double sliding(double degrees)
{
    Geometry geometry = domain(2, {0.5, 1, 0});
    geometry.periodic[0] = true;
    addWall(geometry, Plane({0, 0, 0}, {0, 1, 0}));
    geometry.walls[0].frictionAngle = 20;
    repeatPeriodically(geometry, 5 * spacing);
    auto files = blockCase();
    files["constant/soilProperties"] = "rho 1850; law elastic; elasticCoeffs { E 2e6; nu 0.3; }\n";
    const double slope = degrees * std::numbers::pi / 180;
    files["constant/g"] = fmt::format("dimensions [0 1 -2 0 0 0 0]; value ({} {} 0);\n", 9.81 * std::sin(slope), -9.81 * std::cos(slope));
    Cloud cloud;
    for (int a = 0; a < 10; ++a)
        for (int b = 0; b < 6; ++b)
        {
            cloud.x.push_back((a + 0.5) * spacing);
            cloud.y.push_back((b + 0.5) * spacing);
            cloud.z.push_back(0);
        }
    const auto settings = settingsIn(files, geometry);
    const auto simulation = makeSimulation(settings, geometry, cloud, {});
    double time = 0, from = 0, atFrom = 0;
    while (time < 0.6)
    {
        const double deltaT = simulation->stepLimit().deltaT;
        simulation->step(time, deltaT);
        time += deltaT;
        if (from == 0 && time > 0.3)
        {
            from = time;
            atFrom = simulation->summary().momentum.x;
        }
    }
    return (simulation->summary().momentum.x - atFrom) / (60 * 1850 * sqr(spacing)) / (time - from);
}
// g (sin - tan 20 cos) on a steep floor; on a gentle one the layer stands.
TEST(SoilWall, SlidesByCoulombsLaw)
{
    const double slope = 30 * std::numbers::pi / 180, mu = std::tan(20 * std::numbers::pi / 180);
    const double expected = 9.81 * (std::sin(slope) - mu * std::cos(slope));
    EXPECT_NEAR(sliding(30) / expected, 1, 0.02);
    EXPECT_NEAR(sliding(15), 0, 0.01 * expected);
}

// Values by hand: rho = 1000 kg/m^3, d = 0.1 m, g = 10 m/s^2 into a floor whose ghost lies 0.2 m deeper.
TEST(ContinuedStress, HasTheWeightOfTheSoilBetween)
{
    Geometry geometry = domain(2, {1, 1, 0});
    addWall(geometry, Plane({0, 0, 0}, {0, 1, 0}));
    FieldStore<2> store;
    store.allocateState(Density{});
    store.resize(1);
    store.component("rho", 0)[0] = 1000;
    Coefficients c;
    c.g = {0, -10, 0};
    const SymmTensor<2> S{-500, 70, -900};
    Reflection<2> r{0.1, 1, {0, 1}, 0, {}};
    const auto beyond = [&](const std::string& word, SymmTensor<2> of)
    {
        ContinuedStress<2> rule(geometry, store, c, false, word);
        rule.bind();
        return rule(of, 0, r);
    };
    EXPECT_EQ(beyond("hydrostatic", S).yy, -900 - 2000);
    EXPECT_EQ(beyond("hydrostatic", S).xx, -500);
    EXPECT_EQ(beyond("hydrostatic", S).xy, 70) << "soil that is held passes shear stress on";
    EXPECT_EQ(beyond("mirrored", S).yy, -900);
    geometry.walls[0].slips = true;
    EXPECT_EQ(beyond("hydrostatic", S).xy, -70) << "no shear stress where soil slips";
    geometry.walls[0].slips = false;
    geometry.walls[0].frictionAngle = 30;
    store.allocateState(WallShear{});
    store.resize(1);
    store.component("rho", 0)[0] = 1000;
    store.component("wallShear", 1)[0] = 50;
    EXPECT_EQ(beyond("hydrostatic", S).xy, 30) << "70 Pa here, 50 Pa on the wall";
    EXPECT_EQ(beyond("hydrostatic", S).yy, -900 - 2000);
    geometry.walls[0].frictionAngle.reset();
    r.normal = {0, -1}; // a lid: its weight would hang the soil up
    EXPECT_EQ(beyond("hydrostatic", S).yy, -900 + 2000);
    EXPECT_EQ(beyond("detaching", S).yy, 0);
}

/// 12 x 12 particles in the corner of a floor and a wall on the left, both of layers, under their own weight: rho g depth below y = 0.6 m, and K_0 of it.
struct LayeredCorner
{
    Geometry geometry = emptySpace(2);
    std::unique_ptr<Particles<2>> particles;

    LayeredCorner(bool slips, double jitter, const std::string& words)
    {
        addWall(geometry, Plane({0, 0, 0}, {0, 1, 0}));
        addWall(geometry, Plane({0, 0, 0}, {1, 0, 0}));
        for (auto& wall : geometry.walls) wall.slips = slips;
        repeatPeriodically(geometry, 5 * spacing);
        Diagnostics none;
        geometry.layers = makeWallLayers(geometry, 3 * spacing, spacing, none);
        auto files = blockCase("type geostatic; surface 0.6;");
        files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);\n";
        files["system/sphSchemes"] += "walls layers; " + words + "\n";
        auto cloud = block<2>(12, jitter);
        for (auto* x : {&cloud.x, &cloud.y})
            for (double& q : *x) q -= 3 - 6 * spacing;
        particles = std::make_unique<Particles<2>>(settingsIn(files, geometry), geometry, allTerms<2>(), cloud, Numbers{});
    }
    /// The largest error of the velocity gradient over |L|, of particles whose support does not reach the surface, in v = L x.
    double gradientError(Tensor<2> L)
    {
        auto& store = particles->store();
        const auto v = store.pointers(Velocity{});
        for (std::size_t i = 0; i < particles->size(); ++i)
            sph::store(L * positionOf(store, i), [&](int c, double q) { v[std::size_t(c)][i] = q; });
        particles->evaluate(ofStrain);
        Largest worst;
        const auto found = std::as_const(store).pointers(VelocityGradient{});
        forEachInside(
            [&](std::size_t i, Vector<2>)
            {
                Tensor<2> G;
                fetch(G, [&](int c) { return found[std::size_t(c)][i]; });
                worst(std::sqrt(doubleDot(G - L, G - L) / doubleDot(L, L)));
            });
        return worst.value();
    }
    /// The largest acceleration over g.
    double unrest()
    {
        Largest worst;
        const auto a = std::as_const(particles->store()).pointers(Acceleration{});
        forEachInside([&](std::size_t i, Vector<2>) { worst(std::hypot(a[0][i], a[1][i]) / 9.81); });
        return worst.value();
    }
    void forEachInside(const std::function<void(std::size_t, Vector<2>)>& f) const
    {
        for (std::size_t i = 0; i < particles->size(); ++i)
            if (const auto x = positionOf(particles->store(), i); std::max(x.x, x.y) < 8 * spacing) f(i, x);
    }
};
// A linear flow that slips along both walls has its exact gradient at each particle beside them on a lattice. 0.2 spacings off it the deepest of a layer see one particle alone, of next to no weight: measured 2.5e-5.
TEST(SoilLayers, ContinueALinearVelocity)
{
    const Tensor<2> L{0.7, 0, 0, -1.1};
    EXPECT_LT(LayeredCorner(true, 0, "").gradientError(L), 1e-9);
    EXPECT_LT(LayeredCorner(true, 0.2, "").gradientError(L), 1e-4);
}
// Vertical stresses in layers are those of soil at rest: under the floor with the weight between, behind the wall as high up. So are the lateral ones behind the wall.
TEST(SoilLayers, HaveTheStressOfSoilAtRest)
{
    const LayeredCorner corner(true, 0.2, "");
    auto& p = *corner.particles;
    const auto& images = p.images();
    const auto S = p.store().pointers(ActingStress{});
    Largest worst;
    int seen = 0;
    const double K = S[0][0] / S[2][0];
    for (std::size_t k = images.nullParticle() - images.layers()->count(); k < images.nullParticle(); ++k)
    {
        const auto x = positionOf(p.store(), k);
        if (std::max(x.x, x.y) > 8 * spacing || std::min(x.x, x.y) < -2 * spacing) continue; // deeper ones see one particle or none
        const double expected = -1850 * 9.81 * (0.6 - x.y);
        worst((S[2][k] - expected) / (1850 * 9.81 * 0.6));
        if (x.y > 0 && x.x < 0) worst((S[0][k] - K * expected) / (1850 * 9.81 * 0.6));
        ++seen;
    }
    EXPECT_GT(seen, 30);
    EXPECT_LT(worst.value(), 0.002); // floorPressure, and K of one particle
}
TEST(SoilLayers, HoldSoilAtRest)
{
    EXPECT_LT(LayeredCorner(true, 0, "").unrest(), 0.03);
    EXPECT_GT(LayeredCorner(false, 0, "layerValues byPair;").unrest(), 0.2);
}

/// The mean of K = sigma_xx/sigma_yy and the largest part by which one is off `target`, over the middle 80 % of the height of a column.
struct EarthPressure
{
    double mean = 0, worst = 0, tensile = 0;
};
EarthPressure earthPressure(const TestCase& c, const std::string& time, double target)
{
    const Case theCase(c.folder());
    const auto cloud = readCloud(c.folder(), time, "sph", theCase.diagnostics());
    const auto& sigma = cloud.fields.at("sigma").component;
    const double top = *std::ranges::max_element(cloud.y);
    EarthPressure all;
    Largest worst;
    double n = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        all.tensile += principalValues(SymmTensor<3>{sigma[0][i], sigma[1][i], 0, sigma[3][i], 0, sigma[5][i]})[0] > 0;
        if (cloud.y[i] < 0.1 * top || cloud.y[i] > 0.9 * top) continue;
        const double K = sigma[0][i] / sigma[3][i];
        all.mean += K;
        worst(K / target - 1);
        ++n;
    }
    all.mean /= n;
    all.worst = worst.value();
    return all;
}
/// Sand 0.5 m wide and 1 m high between smooth walls, from 5 % of gravity and an isotropic stress to all of it in 2 s.
Files columnOfSand(const std::string& integration)
{
    auto files = soilCase();
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (0.5 1.2 0); }\nwalls\n{\n    base { type plane; point (0 0 0); normal (0 1 0); slip yes; }\n    left { type "
        "plane; point (0 0 0); normal (1 0 0); slip yes; }\n    right { type plane; point (0.5 0 0); normal (-1 0 0); slip yes; }\n}\n";
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -0.4905 0); shaking \"vector(0, -9.3195*min($t/2, 1), 0)\";\n";
    auto& properties = files["constant/soilProperties"];
    properties.replace(properties.find("surface 0.5;"), 12, "surface 1; K0 1;");
    files["system/packParticlesDict"] = "lattice cubic;\nfill ( { region box; min (0 0 0); max (0.5 1 0); phase sand; } );\n";
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.4; kernel cubicSpline; }\nsoil { artificialViscosity 0.1; }\nintegration { damping { rate 400; until 10; } " +
        integration + " }\n";
    files["system/controlDict"] =
        "application sphFoamLike; startFrom startTime; startTime 0; stopAt endTime; endTime 2.3; adjustTimeStep yes; writeControl adjustableRunTime; "
        "writeInterval 2.3; writeFormat binary;\n";
    return files;
}
// Monotonic compression by 20 without lateral strain brings K from 1 to 0.5135. The bounds are 1 % on the mean and 3 % on each particle; measured 0.5136 and 0.2 %.
void expectEarthPressureOfItsHistory(const std::string& integration, const std::string& words = "")
{
    auto files = columnOfSand(integration);
    files["system/sphSchemes"] += words + "\n";
    const TestCase c(files);
    for (const char* program : {"packParticles", "meshToGhost"}) c.runWell(program);
    const auto log = c.runWell("sphFoamLike");
    const auto K = earthPressure(c, "2.3", 0.5135);
    EXPECT_NEAR(K.mean / 0.5135, 1, 0.01);
    EXPECT_LT(K.worst, 0.03);
    EXPECT_EQ(K.tensile, 0);
    EXPECT_NE(log.find("\nStep bound by sound in soil: particle "), std::string::npos);
    EXPECT_NE(log.find(" 0 particles stress-free, 0 with a stress that the law does not admit, 0 not resolved"), std::string::npos);
}
TEST(SoilColumn, ReachesTheEarthPressureOfItsHistory) { expectEarthPressureOfItsHistory(""); }
/// A column 0.1 spacings off its lattice.
EarthPressure ofDisorder(const std::string& ofSoil)
{
    auto files = columnOfSand("");
    files["system/packParticlesDict"] += "jitter 0.1;\n";
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 3.6; kernel wendlandC2; }\nsoil { artificialViscosity 1; " + ofSoil +
                                 " }\nintegration { damping { rate 400; until 10; } }\n";
    const TestCase c(files);
    for (const char* program : {"packParticles", "meshToGhost", "sphFoamLike"}) c.runWell(program);
    return earthPressure(c, "2.3", 0.5135);
}
// Off the lattice each particle finds its own stress by the symmetric form, at any spacing (15 % at the worst); the balanced one keeps the bound of 3 % (tutorials/geomechanics/sandColumn).
TEST(SoilColumn, IsCalmOffItsLattice)
{
    EXPECT_LT(ofDisorder("stressDivergence balanced; hourglassStiffness 0.2;").worst, 0.02);
    EXPECT_GT(ofDisorder("").worst, 0.1);
}
TEST(SoilColumn, ReachesItBetweenLayers) { expectEarthPressureOfItsHistory("", "walls layers;"); }
// Measured
TEST(SoilColumn, ReachesItByVerlet) { expectEarthPressureOfItsHistory("scheme verlet;"); }

// Sides of friction angle 15 degrees carry a part of the weight (Janssen 1895): the mean vertical stress at depth z between sides B apart is rho g B/(2 mu K) (1 - exp(-2 mu K z/B)). Measured up to 2.1 % off;
// tutorials/geomechanics/sandColumn has it at three spacings.
TEST(SoilColumn, HangsOnSidesOfFriction)
{
    auto files = columnOfSand("");
    auto& geometry = files["constant/geometry"];
    for (const std::string side : {"normal (1 0 0); ", "normal (-1 0 0); "})
        geometry.replace(geometry.find(side) + side.size(), 9, "frictionAngle 15;");
    const TestCase c(files);
    for (const char* program : {"packParticles", "meshToGhost", "sphFoamLike"}) c.runWell(program);
    const Case theCase(c.folder());
    const auto cloud = readCloud(c.folder(), "2.3", "sph", theCase.diagnostics());
    const double top = *std::ranges::max_element(cloud.y) + 0.025, mu = std::tan(15 * std::numbers::pi / 180), B = 0.5, K = 0.5135;
    for (double z = 0.25; z < 0.8; z += 0.05)
    {
        double stress = 0, rho = 0, n = 0;
        for (std::size_t i = 0; i < cloud.size(); ++i)
        {
            const double off = std::abs(top - cloud.y[i] - z) / 0.05, weight = std::max(0.0, 1 - off);
            stress -= weight * cloud.fields.at("sigma").component[3][i];
            rho += weight * cloud.fields.at("rho").component[0][i];
            n += weight;
        }
        const double janssen = rho / n * 9.81 * B / (2 * mu * K) * (1 - std::exp(-2 * mu * K * z / B));
        EXPECT_NEAR(stress / n / janssen, 1, 0.025) << z;
    }
}

/// Settlement of the surface row of a layer 0.5 m high with smooth sides, under its own weight.
double settlement(const std::string& properties)
{
    auto files = soilCase();
    files["constant/soilProperties"] = properties;
    auto& geometry = files["constant/geometry"];
    geometry.replace(geometry.find("normal (0 1 0);"), 15, "normal (0 1 0); slip yes;");
    files["system/packParticlesDict"] = "lattice cubic;\nfill ( { region box; min (0 0 0); max (1 0.5 0); phase sand; } );\n";
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 3.6; kernel wendlandC2; }\nintegration { damping { rate 200; until 10; } }\n";
    auto& control = files["system/controlDict"];
    control.replace(control.find("endTime 0.08"), 12, "endTime 0.4");
    const TestCase c(files);
    for (const char* program : {"packParticles", "meshToGhost", "sphFoamLike"}) c.runWell(program);
    const Case theCase(c.folder());
    const auto highest = [&](const char* time) { return std::ranges::max(readCloud(c.folder(), time, "sph", theCase.diagnostics()).y); };
    return highest("0") - highest("0.4");
}
// An elastic layer of height H settles by rho g H^2/(2 M) at its surface, M = E (1 - nu)/((1 + nu)(1 - 2 nu)), less (dx/(2 H))^2 of it in the middle of the first row; from no stress at the start. With a
// strength that is not reached so does soil by Drucker and Prager.
TEST(SoilLayer, SettlesAsElasticityHasIt)
{
    const double M = 2e6 * (1 - 0.3) / (1.3 * 0.4), expected = 1850 * 9.81 * sqr(0.5) / (2 * M) * (1 - sqr(0.05));
    EXPECT_NEAR(settlement("rho 1850; law elastic; elasticCoeffs { E 2e6; nu 0.3; }\n") / expected, 1, 0.03);
    EXPECT_NEAR(settlement("rho 1850; law druckerPrager; druckerPragerCoeffs { E 2e6; nu 0.3; frictionAngle 40; cohesion 1e5; }\n") /
                    expected,
                1, 0.03);
}

std::string mistake(
    const Files& files, const std::function<void(Cloud&)>& change = [](Cloud&) {}, const Geometry& geometry = emptySpace(2))
{
    try
    {
        const auto settings = settingsIn(files, geometry);
        auto cloud = block<2>(12, 0);
        change(cloud);
        makeSimulation(settings, geometry, cloud, {});
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}
Files changed(Files files, const std::string& file, const std::string& from, const std::string& to)
{
    auto& text = files[file];
    text.replace(text.find(from), from.size(), to);
    return files;
}
void says(const std::string& message, const std::string& words) { EXPECT_NE(message.find(words), std::string::npos) << message; }

// Each with the file and, where there is one, the line.
TEST(SoilMistakes, SayWhereAndWhat)
{
    const auto good = blockCase();
    EXPECT_EQ(mistake(good), "");
    const auto schemes = [&](const std::string& more)
    {
        auto files = good;
        files["system/sphSchemes"] += more + "\n";
        return mistake(files);
    };
    says(schemes("density continuity; integration { scheme predictorCorrector; }"),
         "system/sphSchemes:3: the stress of soil lives in the middle of steps, with one evaluation there, or at the ends of Verlet's");
    says(schemes("density numberDensity;"), "system/sphSchemes:3: soil has an integrated density");
    says(schemes("pressureGradient huAdams;"), "system/sphSchemes:3: pressureGradient goes with a state equation");
    says(schemes("shifting 2;"), "system/sphSchemes:3: shifting goes with a state equation");
    says(
        mistake(blockCase("type isotropic; pressure 1e4;", "shown ( shearStrain plasticShearStrain );")),
        "system/sphSchemes:2: plasticShearStrain is of laws that are linearly elastic within a yield surface, druckerPrager and mohrCoulomb; of law wuBauer shearStrain has all of it");
    for (const auto* stress : {"smoothingActs always;", "stressSmoothing 0; smoothingActs always;"})
        says(mistake(blockCase("type isotropic; pressure 1e4;", stress)),
             "system/sphSchemes:2: smoothingActs does nothing without stressSmoothing");
    says(mistake(blockCase("type isotropic; pressure 1e4;", "hourglassStiffness 0.2;")),
         "system/sphSchemes:2: hourglassStiffness goes with `stressDivergence balanced;`");
    says(mistake(blockCase("type isotropic; pressure 1e4;", "artificialViscosity 0; viscosityActs always;")),
         "system/sphSchemes:2: viscosityActs does nothing with artificialViscosity 0");
    says(mistake(changed(good, "constant/phaseProperties", "stress constitutiveLaw;", "stress constitutiveLaw; mu 1;")),
         "entry \"mu\" is not used here");
    says(mistake(changed(good, "constant/soilProperties", "rho 1850", "elasticCoeffs { E 2e7; nu 0.3; mu 1; } rho 1850")),
         "constant/soilProperties:1: entry \"mu\" is not used here");
    EXPECT_EQ(mistake(changed(good, "constant/soilProperties", "rho 1850", "elasticCoeffs { E 2e7; nu 0.3; } rho 1850")), "")
        << "of a law to change to";
    says(mistake(changed(good, "constant/soilProperties", "rho 1850", "rho 0")), "constant/soilProperties:1: ");
    says(mistake(changed(good, "constant/soilProperties", "rho 1850", "rho 1600")),
         "constant/soilProperties:1: 1600 kg/m^3 is not the density of sand");
    says(mistake(changed(good, "constant/soilProperties", "type isotropic; pressure 1e4;", "type geostatic; surface 1;")),
         "constant/soilProperties:4: geostatic needs gravity");
    says(mistake(changed(good, "constant/soilProperties", "initialStress { type isotropic; pressure 1e4; }", "")),
         "constant/soilProperties: has no `initialStress`");
    says(mistake(changed(good, "constant/soilProperties", "pressure 1e4;", "pressure 1e4; K0 1;")),
         "constant/soilProperties:4: entry \"K0\" is not used here");
    const auto properties = [&](const std::string& more)
    {
        auto files = good;
        files["constant/soilProperties"] += more + "\n";
        return mistake(files);
    };
    says(properties("confiningPressure 2e4;"), "constant/soilProperties:4: 10000 Pa within is not confiningPressure, 20000 Pa");
    says(properties("confiningPressure 5;"), "constant/soilProperties:5: 5 Pa is less than floorPressure, 10 Pa");
    says(properties("confiningPressure 1e4; stressFree detached;"), "constant/soilProperties:5: on soil whose stress is 0 for good");
    says(mistake(good,
                 [](Cloud& cloud)
                 {
                     give(cloud, "sigma", FieldClass::symmTensor,
                          [](std::size_t i) { return std::vector<double>{-1e4, 0, 0, i == 5 ? 3e4 : -1e4, 0, -1e4}; });
                 }),
         "trace 10000 Pa; tension is positive, and this law has none");
    says(mistake(changed(changed(good, "constant/phaseProperties", "phases (sand);", "phases (sand water); water { rho 1; soundSpeed 1; }"),
                         "system/sphSchemes", "\n", "\n")),
         "soil goes with one phase alone");
    // State variables: none said, beyond the law's range, by two levels of time.
    const auto sand = ofVoidRatio(good);
    EXPECT_EQ(mistake(sand), "");
    says(mistake(ofVoidRatio(good, "")),
         "constant/soilProperties: initialStress has no `voidRatio`, and the time folder no field voidRatio");
    says(mistake(ofVoidRatio(good, "voidRatio 0.5;")),
         "void ratio 0.5 is below the densest: possible at p = 10000 Pa are 0.512744 (e_d) to 0.967441");
    says(mistake(ofVoidRatio(good, "voidRatio 1.2;")), "above the loosest");
    says(mistake(changed(sand, "constant/soilProperties", "alpha 0.13", "alpha 9")), "constant/soilProperties:3: 3 + a^2");
    says(mistake(changed(sand, "constant/soilProperties", "e_c0 0.84", "e_c0 1.84")), "void ratios are to grow from e_d0 to e_c0 to e_i0");
    says(mistake(changed(sand, "system/sphSchemes", "soil {", "integration { scheme verlet; } soil {")), "live at one level of time");
    says(properties("initialStress { type isotropic; pressure 1e4; voidRatio 0.7; }"), "voidRatio");
    auto fluid = changed(good, "constant/phaseProperties", "stress constitutiveLaw;", "soundSpeed 1;");
    says(mistake(fluid), "system/sphSchemes:2: does nothing without soil");
    fluid["system/sphSchemes"] = "resolution { spacing 0.05; support 3; kernel wendlandC2; }\n";
    auto rough = emptySpace(2);
    addWall(rough, Plane({0, 0, 0}, {0, 1, 0}));
    rough.walls[0].name = "floor";
    rough.walls[0].frictionAngle = 20;
    says(mistake(
             fluid, [](Cloud&) {}, rough),
         "frictionAngle of floor is that of soil");
}

// Layers that end within the support, or are as far apart as those of another resolution.
TEST(SoilMistakes, LayersThinnerThanTheSupport)
{
    const auto good = changed(blockCase(), "system/sphSchemes", "\n", "\nwalls layers;\n");
    const auto with = [&](double support, double apart)
    {
        auto geometry = emptySpace(2);
        addWall(geometry, Plane({0, 0, 0}, {0, 1, 0}));
        geometry.walls[0].name = "floor";
        geometry.walls[0].where = {"constant/geometry", 4};
        repeatPeriodically(geometry, 5 * spacing);
        Diagnostics none;
        geometry.layers = makeWallLayers(geometry, support, apart, none);
        return mistake(
            good, [](Cloud&) {}, geometry);
    };
    EXPECT_EQ(with(3 * spacing, spacing), "");
    says(with(2 * spacing, spacing),
         "constant/geometry:4: the layers of particles behind floor are 0.1 m thick, less than the kernel's support, 0.15 m");
    says(with(4 * spacing, 2 * spacing),
         "constant/geometry:4: the first layer of particles behind floor lies 0.05 m deep, and particles are 0.05 m apart");
}
// Pairs know nothing of what lies along a wall that slips.
TEST(SoilMistakes, LayersByPairDoNotSlip)
{
    auto files = soilCase();
    files["system/sphSchemes"] += "walls layers; layerValues byPair;\n";
    const TestCase c(files);
    for (const char* program : {"packParticles", "meshToGhost"}) c.runWell(program);
    says(c.run("sphFoamLike").err, "left, right of constant/geometry with `slip yes;` needs what carries the velocity along the wall");
    c.write("system/sphSchemes", soilCase()["system/sphSchemes"] + "layerValues byPair;\n");
    c.runWell("meshToGhost");
    says(c.run("sphFoamLike").err, "system/sphSchemes:2: goes with `walls layers;` alone");
}

}
}
