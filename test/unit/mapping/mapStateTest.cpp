#include "mapping/mapState.hpp"
#include "Particles.hpp"
#include "mapping/Surroundings.hpp"
#include "mapping/choosePhases.hpp"
#include "sampling/SampledField.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace sph
{
namespace
{

/// Particles off their lattice by up to so many spacings, in the unit square or cube.
Particles scene(int dimension, int across, double jitter, bool isPeriodic = false)
{
    const double dx = 1.0 / across;
    Particles particles(dimension, {0, 0, 0}, {1, 1, 1}, dx);
    std::mt19937 random{unsigned(across)};
    std::uniform_real_distribution<double> shift(-jitter * dx, jitter * dx);
    for (auto* x : {&particles.x, &particles.y, &particles.z})
        for (auto& value : *x)
            if (x != &particles.z || dimension == 3) value += shift(random);
    particles.geometry.periodic = {isPeriodic, isPeriodic, isPeriodic && dimension == 3};
    return particles;
}

/// Phase 0 where `isLiquid`, of 1000 kg/m^3, and phase 1, of 1 kg/m^3, elsewhere.
void fill(Particles& particles, const std::function<bool(Vector<3>)>& isLiquid)
{
    particles.phases = {"liquid", "gas"};
    particles.setPhase([&](Vector<3> x) { return isLiquid(x) ? 0 : 1; });
    for (std::size_t i = 0; i < particles.size(); ++i) particles.mass[i] = (particles.phase[i] == 0 ? 1000 : 1) * particles.volume[i];
}

MappedState map(const Particles& source, const Particles& target, const MapSettings& settings = {})
{
    return mapState(source.view(), target.view(), settings, [](const std::string&) {});
}

std::string refusal(const Particles& source, const Particles& target)
{
    try
    {
        map(source, target);
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

Vector<3> velocity(const MappedState& state, std::size_t i)
{
    const auto& U = state.fields.at("U").component;
    return {U[0][i], U[1][i], U[2][i]};
}

double distanceAcross(double a, double b) { return a - b - std::round(a - b); }

/// Mean place of the particles of phase 0, about `near` in a periodic domain.
template<class IsLiquid> Vector<3> centre(const Particles& particles, const IsLiquid& isLiquid, const Vector<3>& near)
{
    Vector<3> sum;
    double count = 0;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        if (!isLiquid(i)) continue;
        const auto x = particles.position(i);
        sum += Vector<3>{distanceAcross(x.x, near.x), distanceAcross(x.y, near.y),
                         particles.geometry.dimension == 3 ? distanceAcross(x.z, near.z) : 0};
        ++count;
    }
    return near + sum / count;
}

}

// Moving least squares: a linear field is exact in the interior and at boundaries, but for the uniform shift that makes up for the momentum of the
// disordered source, the same for all. Tolerance: round-off times the condition of the moment matrix, 1/2e-3.
TEST(MapState, linearVelocitiesAreExact)
{
    for (const int dimension : {2, 3})
    {
        auto source = scene(dimension, 12, 0.2);
        const auto field = [&](Vector<3> x) {
            return Vector<3>{3 + 2 * x.x - 5 * x.y, x.x + (dimension == 3 ? 7 * x.z : 0), dimension == 3 ? x.y - x.z : 0};
        };
        source.setU(field);
        const auto target = scene(dimension, 17, 0.1);
        const auto state = map(source, target);
        const auto shift = velocity(state, 0) - field(target.position(0));
        EXPECT_LT(mag(shift), 0.05);
        for (std::size_t i = 0; i < target.size(); ++i)
            ASSERT_LT(mag(velocity(state, i) - field(target.position(i)) - shift), 1e-11) << dimension << " " << i;
    }
}

// A wave in a periodic square: halving the source's spacing divides the L2 error by 4.
TEST(MapState, smoothVelocitiesAreOfSecondOrder)
{
    const auto wave = [](Vector<3> x) {
        return Vector<3>{std::sin(2 * M_PI * x.x) * std::cos(2 * M_PI * x.y), std::cos(2 * M_PI * x.x), 0};
    };
    const auto target = scene(2, 57, 0.2, true);
    const auto error = [&](int across)
    {
        auto source = scene(2, across, 0.1, true);
        source.setU(wave);
        const auto state = map(source, target);
        double sum = 0;
        for (std::size_t i = 0; i < target.size(); ++i) sum += sqr(mag(velocity(state, i) - wave(target.position(i))));
        return std::sqrt(sum / double(target.size()));
    };
    const double coarse = error(16), middle = error(32), fine = error(64);
    EXPECT_NEAR(std::log2(coarse / middle), 2, 0.25);
    EXPECT_NEAR(std::log2(middle / fine), 2, 0.25);
    EXPECT_LT(fine, 0.005);
}

// A disc and a sphere of liquid: mass to half a particle, momentum of both phases to round-off, centre to a tenth of the source's spacing (that of the source's own
// particles is off the drawn centre by as much), and the surface where shares are a half.
TEST(MapState, aDropKeepsMassMomentumAndPlace)
{
    for (const auto& [dimension, coarse, fine] : {std::tuple{2, 20, 50}, {2, 50, 20}, {3, 14, 24}})
        for (const Vector<3> middle : {Vector<3>{0.513, 0.492, 0.507}, {0.02, 0.97, 0.01}}) // within, and across the faces of the period
        {
            auto source = scene(dimension, coarse, 0.15, true), target = scene(dimension, fine, 0.15, true);
            const auto inDrop = [&, d = dimension](Vector<3> x) {
                return std::hypot(distanceAcross(x.x, middle.x), distanceAcross(x.y, middle.y),
                                  d == 3 ? distanceAcross(x.z, middle.z) : 0) < 0.3;
            };
            fill(source, inDrop);
            fill(target, [](Vector<3>) { return false; });
            source.setU(
                [&, d = dimension](Vector<3> x) {
                    return inDrop(x) ? Vector<3>{1 + 0.1 * std::sin(6 * x.y), -2, d == 3 ? 0.5 : 0} : Vector<3>{0, x.x, 0};
                });
            const auto state = map(source, target);
            const double particle = 1000 * target.volume[0];
            EXPECT_LE(std::fabs(state.corrected[0].mass - state.source[0].mass), 0.5 * particle * (1 + 1e-9));
            for (const auto k : {0, 1})
                EXPECT_LT(mag(state.corrected[std::size_t(k)].momentum - state.source[std::size_t(k)].momentum),
                          1e-12 * mag(state.source[0].momentum))
                    << k;
            const auto was = centre(
                source, [&](std::size_t i) { return source.phase[i] == 0; }, middle);
            const auto is = centre(
                target, [&](std::size_t i) { return state.phase[i] == 0; }, middle);
            EXPECT_LT(mag(is - was), 0.1 * std::max(source.spacing, target.spacing)) << dimension << " " << coarse;
            EXPECT_NEAR(state.leastShare[0], 0.5, 0.1);
        }
}

// Kinetic energy that is reported is that of the particles, and a field that is not the velocity keeps within what the source has.
TEST(MapState, sumsAreThoseOfTheParticlesAndFieldsKeepTheirBounds)
{
    auto source = scene(2, 20, 0.2), target = scene(2, 33, 0.2);
    source.setU([](Vector<3> x) { return Vector<3>{std::sin(9 * x.x), x.x * x.y, 0}; });
    source.setP([](Vector<3> x) { return x.x < 0.5 ? 0.0 : 1.0; });
    const auto state = map(source, target, {.fields = {"p"}});
    double energy = 0;
    for (std::size_t i = 0; i < target.size(); ++i)
    {
        energy += 0.5 * state.mass[i] * sqr(mag(velocity(state, i)));
        EXPECT_GE(state.fields.at("p").component[0][i], 0);
        EXPECT_LE(state.fields.at("p").component[0][i], 1 + 1e-14);
    }
    EXPECT_NEAR(state.corrected[0].kineticEnergy, energy, 1e-12 * energy);
    EXPECT_NEAR(state.corrected[0].kineticEnergy, state.source[0].kineticEnergy, 0.15 * energy); // a wave of 14 spacings, smoothed
}

// Particles at the places of the source's have to the last bit what those have, in patches of both phases of a few particles.
TEST(MapState, theSameParticlesHaveTheSameState)
{
    auto source = scene(2, 24, 0.2, true);
    const auto target = [&]
    {
        auto all = source;
        fill(all, [](Vector<3>) { return false; });
        return all;
    }();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    fill(source, [&](Vector<3>) { return any(random) > 0.3; });
    source.setU([&](Vector<3>) { return Vector<3>{any(random), any(random), 0}; });
    source.setP([&](Vector<3>) { return any(random); });
    const auto state = map(source, target, {.fields = {"p"}});
    for (std::size_t i = 0; i < source.size(); ++i)
    {
        ASSERT_EQ(state.phase[i], int(source.phase[i]));
        ASSERT_EQ(state.mass[i], source.mass[i]);
        ASSERT_EQ(state.fields.at("U").component[0][i], source.ux[i]);
        ASSERT_EQ(state.fields.at("U").component[1][i], source.uy[i]);
        ASSERT_EQ(state.fields.at("p").component[0][i], source.p[i]);
    }
}

namespace
{
/// A periodic square that a plate of 0.08 divides at x = 0.5.
Geometry dividedSquare()
{
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto geometry = readGeometry(Dictionary::parse("dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x y); }\n"
                                                         "walls { plate { type box; min (0.46 -1 0); max (0.54 2 0); fluid outside; } }",
                                                         "constant/geometry", diagnostics),
                                       0.3);
    diagnostics->throwIfAny();
    return geometry;
}
}

// Across the plate nothing is seen, along it, close to it, and through the period all; a chord that cuts it by less than a twentieth of a spacing is free.
TEST(Sight, endsAtWalls)
{
    const auto geometry = dividedSquare();
    const Sight sight(geometry, 0.05);
    const auto at = [&](Vector<3> x) { return PlacedPoint{x, sight.toWall(x)}; };
    EXPECT_FALSE(sight.isFree(at({0.44, 0.5, 0}), at({0.56, 0.5, 0})));
    EXPECT_FALSE(sight.isFree(at({0.44, 0.4, 0}), at({0.56, 0.6, 0})));
    EXPECT_TRUE(sight.isFree(at({0.45, 0.4, 0}), at({0.45, 0.6, 0})));
    EXPECT_TRUE(sight.isFree(at({0.02, 0.4, 0}), at({-0.02, 0.6, 0})));
    EXPECT_TRUE(sight.isFree(at({0.461, 0.4, 0}), at({0.461, 0.6, 0})));
    EXPECT_TRUE(Sight(Geometry{}, 0.05).isFree({{0, 0, 0}, Box::infinity}, {{1, 0, 0}, Box::infinity}));
}

// At a particle's own place it counts alone; within the support weights are linear; beyond it the nearest counts alone, as far as four supports; the particles that
// are not admitted count nowhere.
TEST(Surroundings, weighTheSupportOrTheNearest)
{
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.setP([](Vector<3> x) { return 2 * x.x + 3 * x.y; });
    const auto view = particles.view();
    const Surroundings surroundings(view, particles.geometry);
    const auto around = [&](Vector<3> x, const Surroundings::Admits& admits = {}) {
        return surroundings.around({x, Box::infinity}, Interpolation::linear, admits);
    };
    EXPECT_EQ(around(particles.position(7)).weights.particle, std::vector<std::size_t>{7});
    EXPECT_NEAR(around({0.51, 0.47, 0}).weights(particles.p.data()), 2 * 0.51 + 3 * 0.47, 1e-12);
    const auto beyond = around({1.2, 0.52, 0});
    EXPECT_FALSE(beyond.bySupport);
    EXPECT_NEAR(beyond.nearest, std::hypot(0.225, 0.005), 1e-12);
    ASSERT_EQ(beyond.weights.particle.size(), 1u);
    EXPECT_EQ(particles.position(beyond.weights.particle[0]).y, 0.525);
    EXPECT_TRUE(around({1.7, 0.5, 0}).weights.empty());
    EXPECT_TRUE(around({0.5, 0.5, 0}, [](std::size_t) { return false; }).weights.empty());
}

// The plate is a spacing and a half thick, between two streams: particles beside it have the velocity of their side alone.
TEST(MapState, nothingIsSeenThroughAWall)
{
    const auto geometry = dividedSquare();
    const auto without = [&](Particles all)
    {
        Particles kept = all;
        for (auto* values : {&kept.x, &kept.y, &kept.z, &kept.mass, &kept.volume, &kept.phase, &kept.ux, &kept.uy, &kept.uz, &kept.p})
            values->clear();
        kept.geometry = geometry;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all.x[i] < 0.46 || all.x[i] > 0.54) kept.add(all.position(i));
        return kept;
    };
    auto source = without(scene(2, 20, 0.1));
    const auto target = without(scene(2, 40, 0.1));
    // The halves meet at x = 0 too: there the field is as it is, and is left out of the test.
    source.setU([](Vector<3> x) { return Vector<3>{0, x.x < 0.5 ? 1.0 : -1.0, 0}; });
    const auto state = map(source, target);
    for (std::size_t i = 0; i < target.size(); ++i)
    {
        if (std::fabs(target.x[i] - 0.5) > 0.3) continue;
        EXPECT_NEAR(velocity(state, i).y, target.x[i] < 0.5 ? 1 : -1, 0.05);
    }
}

// Liquid below y = 0.43, nothing above: of a target that fills all, particles for the liquid's mass stay, and none above the surface by more than a spacing.
TEST(MapState, aFreeSurfaceLeavesPlacesEmpty)
{
    auto source = scene(2, 25, 0.1);
    const auto all = source;
    for (auto* values :
         {&source.x, &source.y, &source.z, &source.mass, &source.volume, &source.phase, &source.ux, &source.uy, &source.uz, &source.p})
        values->clear();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all.y[i] < 0.43) source.add(all.position(i));
    const auto target = scene(2, 40, 0.1);
    const auto state = map(source, target);
    EXPECT_LE(std::fabs(state.corrected[0].mass - state.source[0].mass), 0.5 * target.mass[0] * (1 + 1e-9));
    EXPECT_EQ(state.emptied + state.corrected[0].particles, target.size());
    for (std::size_t i = 0; i < target.size(); ++i)
    {
        if (std::fabs(target.y[i] - 0.43) < 0.04) continue;
        EXPECT_EQ(state.phase[i], target.y[i] > 0.43 ? leftEmpty : 0) << target.y[i];
    }
}

// Gas around a drop alone: what the source does not cover is gas at rest, whatever the shift of the rest.
TEST(MapState, gasThatWasLeftOutIsAtRest)
{
    auto whole = scene(2, 40, 0.1, true), source = whole;
    const auto radius = [](Vector<3> x) { return std::hypot(x.x - 0.5, x.y - 0.5); };
    for (auto* values :
         {&source.x, &source.y, &source.z, &source.mass, &source.volume, &source.phase, &source.ux, &source.uy, &source.uz, &source.p})
        values->clear();
    for (std::size_t i = 0; i < whole.size(); ++i)
        if (radius(whole.position(i)) < 0.3) source.add(whole.position(i));
    fill(source, [&](Vector<3> x) { return radius(x) < 0.1; });
    source.setU([](Vector<3> x) { return Vector<3>{1, x.x, 0}; });
    auto target = scene(2, 60, 0.1, true);
    fill(target, [](Vector<3>) { return false; });
    const auto state = map(source, target, {.gasIsInPart = true});
    EXPECT_GT(state.uncovered, 0u);
    for (std::size_t i = 0; i < target.size(); ++i)
    {
        if (radius(target.position(i)) < 0.3 + 4 * 1.5 * 0.025) continue;
        EXPECT_EQ(state.phase[i], 1);
        EXPECT_EQ(mag(velocity(state, i)), 0);
    }
    EXPECT_LE(std::fabs(state.corrected[0].mass - state.source[0].mass), 0.5 * 1000 * target.volume[0] * (1 + 1e-9));
}

TEST(MapState, saysWhatDoesNotFit)
{
    auto source = scene(2, 20, 0), target = scene(2, 30, 0);
    for (auto& x : target.x) x *= 0.5;
    for (auto& m : target.mass) m *= 0.5;
    EXPECT_NE(refusal(source, target).find("the target holds 0.5 m^2 of fluid, and the particles of the source have 1:"), std::string::npos)
        << refusal(source, target);

    // The same volume in another place: the farthest particle is half the width from the source's, which is within 1/2 of x.
    target = scene(2, 20, 0);
    for (auto& x : source.x) x *= 0.5;
    const auto text = refusal(source, target);
    EXPECT_NE(text.find("the source does not cover"), std::string::npos) << text;
    EXPECT_NE(text.find("of the 400 particles of the target: at (0.975"), std::string::npos) << text;
    EXPECT_NE(text.find("the nearest of all 0.4875 m away"), std::string::npos) << text;
}

// Two liquids and a gas, by hand: the first takes its two best places, the second the best that is left, the third what remains.
TEST(Phases, chooseInTurnUntilTheirVolumeIsReached)
{
    const std::vector<std::vector<double>> shares{{0.9, 0.6, 0.5, 0.1, 0}, {0.1, 0.4, 0.5, 0.4, 0}, {0, 0, 0, 0.5, 1}};
    const auto choice = choosePhases(shares, std::vector(5, 1.0), {2.4, 1.4, 9}, {0, 1, 2}, 2);
    EXPECT_EQ(choice.phase, (std::vector<int>{0, 0, 1, 2, 2}));
    EXPECT_EQ(choice.leastShare, (std::vector<double>{0.6, 0.5, 1}));
    EXPECT_EQ(choice.unplaced, (std::vector<double>{0, 0, 0}));
    // Half a particle more and a third one is nearer; a phase without shares enough says what it lacks.
    EXPECT_EQ(choosePhases(shares, std::vector(5, 1.0), {2.6, 0, 9}, {0, 1, 2}, 2).phase, (std::vector<int>{0, 0, 0, 2, 2}));
    EXPECT_NEAR(choosePhases(shares, std::vector(5, 1.0), {6, 0, 9}, {0, 1, 2}, leftEmpty).unplaced[0], 2, 1e-15);
}

}
