#include "mapping/mapState.hpp"
#include "base/CaseError.hpp"
#include "base/Clock.hpp"
#include "geometry/components.hpp"
#include "mapping/Surroundings.hpp"
#include "mapping/choosePhases.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace sph
{

PhaseState& PhaseState::operator+=(const PhaseState& other)
{
    particles += other.particles;
    mass += other.mass;
    momentum += other.momentum;
    kineticEnergy += other.kineticEnergy;
    return *this;
}

namespace
{
/// Share of the target's volume below which the source has a free surface, and above the reciprocal of which it does not fit.
constexpr double filled = 0.99;
/// The same of a scene with openings, at whose planes layers of particles end that are as thick as a spacing.
constexpr double filledBetweenOpenings = 0.9;
/// Support of the kernel by which phases have their shares, in spacings of the source: as narrow as covers any place, since a wide one rounds bodies of few
/// spacings. Water at the contacts of bccBed (tutorials/heapLeaching), put into another packing of the same 30 spacings a period, wets 0.265 of the spheres
/// before, and after it 0.260 by 1.5 spacings and 0.257 by the support of 2.6.
constexpr double shareSupport = 1.5;
/// Time between two lines of progress [s].
constexpr double reportInterval = 5;

std::string shortText(const Vector<3>& x) { return fmt::format("({:.6g} {:.6g} {:.6g})", x.x, x.y, x.z); }

/// Means in place of extrapolations.
PointWeights withoutNegative(PointWeights weights)
{
    double sum = 0;
    for (auto& w : weights.weight) sum += w = std::max(w, 0.0);
    for (auto& w : weights.weight) w /= sum;
    return weights;
}

/// f(i) of n particles by all threads, with lines of progress.
template<class F> void forParticles(std::size_t n, const std::string& what, const Say& say, const F& f)
{
    const Clock clock;
    double said = 0;
    const std::size_t parts = std::clamp<std::size_t>(n / 10000, 1, 100);
    for (std::size_t part = 0; part < parts; ++part)
    {
        const std::size_t end = (part + 1) * n / parts;
#pragma omp parallel for schedule(dynamic, 64)
        for (std::size_t i = part * n / parts; i < end; ++i) f(i);
        if (const double now = clock.clockTime(); now > said + reportInterval && end < n)
        {
            said = now;
            say(fmt::format("    {}: {} of {} particles, {:.0f} s", what, end, n, now));
        }
    }
}

class Mapper
{
    const ParticleView &source_, &target_;
    const MapSettings& settings_;
    const Say& say_;
    std::size_t n_, phases_;
    int lightest_;
    std::vector<int> phaseOfSource_;  ///< by particle, in the target's order
    std::vector<double> volume_;      ///< of the target's particles [m^3]
    std::vector<PlacedPoint> places_; ///< of the target's particles
    Surroundings surroundings_;
    bool hasFreeSurface_ = false;
    std::vector<char> covered_;
    MappedState mapped_;

    double sourceVolume(std::size_t k) const { return mapped_.source[k].mass / target_.restDensity[k]; }
    std::size_t sourcePhase(std::size_t j) const { return std::size_t(phaseOfSource_[j]); }
    bool isOf(std::size_t i, int phase) const { return mapped_.phase[i] == phase; }

    void sumSource();
    void compareVolumes();
    std::vector<std::vector<double>> findShares();
    void refuseUncovered(const std::vector<char>& isFarOff) const;
    void choose(const std::vector<std::vector<double>>& shares);
    void interpolate();
    std::vector<PhaseState> sums() const;
    void correctMomentum();

public:
    Mapper(const ParticleView& source, const ParticleView& target, const MapSettings&, const Say&);
    MappedState run();
};

std::vector<int> sourcePhases(const ParticleView& source, const ParticleView& target)
{
    std::vector<int> number;
    for (const auto& name : source.phases) number.push_back(int(std::ranges::find(target.phases, name) - target.phases.begin()));
    std::vector<int> phases(source.n);
    for (std::size_t j = 0; j < source.n; ++j) phases[j] = number[phaseOf(source, j)];
    return phases;
}

Mapper::Mapper(const ParticleView& source, const ParticleView& target, const MapSettings& settings, const Say& say)
    : source_(source),
      target_(target),
      settings_(settings),
      say_(say),
      n_(target.n),
      phases_(target.phases.size()),
      lightest_(int(std::ranges::min_element(target.restDensity.begin(), target.restDensity.begin() + long(phases_)) -
                    target.restDensity.begin())),
      phaseOfSource_(sourcePhases(source, target)),
      volume_(n_),
      places_(n_),
      surroundings_(source, *target.geometry),
      covered_(n_, 1)
{
    for (std::size_t i = 0; i < n_; ++i) volume_[i] = target_.mass[i] / target_.restDensity[phaseOf(target_, i)];
#pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t i = 0; i < n_; ++i) places_[i] = {position(target_, i), surroundings_.sight().toWall(position(target_, i))};
}

void Mapper::sumSource()
{
    const SampledField U(source_, "U", {});
    mapped_.source = groupSums(
        source_.n, phases_, [&](std::size_t j) { return source_.inScene(j) ? sourcePhase(j) : phases_; },
        [&](std::size_t j)
        {
            const Vector<3> v{U(0, j), U(1, j), U(2, j)};
            return PhaseState{1, source_.mass[j], source_.mass[j] * v, 0.5 * source_.mass[j] * dot(v, v)};
        });
}

void Mapper::compareVolumes()
{
    if (settings_.gasIsInPart) return;
    const double least = target_.heldBy ? filledBetweenOpenings : filled;
    double has = 0;
    for (std::size_t k = 0; k < phases_; ++k) has += sourceVolume(k);
    const double holds = sum(n_, [&](std::size_t i) { return target_.inScene(i) ? volume_[i] : 0.0; });
    if (has * least > holds)
        throw CaseError(fmt::format("{} holds {:.6g} {} of fluid, and the particles of {} have {:.6g}: all of the fluid's space is to be "
                                    "packed before the state of others is mapped, fill ( {{ region all; phase {}; }} );",
                                    settings_.targetName, holds, target_.dimension == 2 ? "m^2" : "m^3", settings_.sourceName, has,
                                    target_.phases.front()));
    hasFreeSurface_ = has < least * holds;
    if (hasFreeSurface_) say_(fmt::format("Free surface: the source fills {:.2f} % of the places", 100 * has / holds));
}

/// By phase and place; marks places that the source does not cover.
std::vector<std::vector<double>> Mapper::findShares()
{
    std::vector<std::vector<double>> shares(phases_, std::vector<double>(n_, 0));
    auto narrow = source_;
    narrow.support = std::min(source_.support, shareSupport * source_.spacing);
    const Surroundings near(narrow, *target_.geometry);
    std::optional<Surroundings> space;
    auto places = target_;
    places.support = source_.support;
    places.kernel = source_.kernel;
    places.volume = volume_.data();
    if (hasFreeSurface_) space.emplace(places, *target_.geometry);
    std::vector<char> isFarOff(n_, 0);
    std::atomic<std::size_t> byNearest = 0;
    forParticles(n_, "shares of the phases", say_,
                 [&](std::size_t i)
                 {
                     const auto around =
                         (space ? surroundings_ : near).around(places_[i], Interpolation::shepard, {}, hasFreeSurface_ ? 1 : 4);
                     // Between walls that nearly touch, coarse particles end before fine ones do.
                     const bool isInGap = places_[i].toWall < source_.spacing;
                     covered_[i] = !around.weights.empty() && (around.bySupport || isInGap || settings_.gasIsInPart);
                     isFarOff[i] = !covered_[i] && !hasFreeSurface_ && !settings_.gasIsInPart;
                     if (!covered_[i]) return;
                     byNearest += !around.bySupport;
                     double scale = 1;
                     if (space) scale = around.weights.coverage / space->around(places_[i], Interpolation::shepard, {}, 1).weights.coverage;
                     for (std::size_t t = 0; t < around.weights.particle.size(); ++t)
                         shares[sourcePhase(around.weights.particle[t])][i] += scale * around.weights.weight[t];
                 });
    mapped_.byNearest = byNearest;
    refuseUncovered(isFarOff);
    return shares;
}

void Mapper::refuseUncovered(const std::vector<char>& isFarOff) const
{
    const auto count = std::ranges::count(isFarOff, 1);
    if (count == 0) return;
    const auto& g = *target_.geometry;
    double farthest = 0;
    std::size_t at = 0;
    // The farthest of some: all against all would take long.
    for (std::size_t i = 0, seen = 0; i < n_ && seen < 1000; ++i)
    {
        if (!isFarOff[i]) continue;
        ++seen;
        const double nearest = -most(source_.n, [&](std::size_t j) { return -mag(g.shortest(position(source_, j) - places_[i].x)); });
        if (nearest > farthest) farthest = nearest, at = i;
    }
    throw CaseError(fmt::format(
        "{} does not cover {} of the {} particles of {}: at {} none of its particles is in sight within {:.4g} m, the nearest of all "
        "{:.4g} m away. Its fluid lies elsewhere, or its geometry is another; where it has a free surface, all of the fluid's space is to be "
        "packed, fill ( {{ region all; phase {}; }} );, and mapParticles leaves places empty",
        settings_.sourceName, count, n_, settings_.targetName, shortText(places_[at].x), shareSupport * source_.spacing, farthest,
        target_.phases.front()));
}

void Mapper::choose(const std::vector<std::vector<double>>& shares)
{
    auto offered = shares;
    for (std::size_t i = 0; i < n_; ++i)
        if (!target_.inScene(i))
            for (auto& share : offered) share[i] = 0;
    std::vector<int> order(phases_);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater{}, [&](int k) { return target_.restDensity[std::size_t(k)]; });
    std::vector<double> wanted(phases_);
    for (std::size_t k = 0; k < phases_; ++k) wanted[k] = sourceVolume(k);
    const int rest = hasFreeSurface_ ? leftEmpty : lightest_;
    auto choice = choosePhases(offered, volume_, wanted, order, rest);
    const double largest = n_ > 0 ? *std::ranges::max_element(volume_) : 0;
    for (std::size_t k = 0; k < phases_; ++k)
        if (choice.unplaced[k] > 0.5 * largest)
            throw CaseError(fmt::format(
                "{:.4g} kg of the {:.6g} kg of {} in {} find no place among the particles of {}: all of the fluid's space is to be packed",
                choice.unplaced[k] * target_.restDensity[k], mapped_.source[k].mass, target_.phases[k], settings_.sourceName,
                settings_.targetName));
    // What openings hold takes the phase of most of what is around.
    for (std::size_t i = 0; i < n_; ++i)
        if (!target_.inScene(i))
            for (std::size_t k = 0; k < phases_; ++k)
                if (const int phase = choice.phase[i];
                    shares[k][i] > 0 && (phase == leftEmpty || shares[k][i] > shares[std::size_t(phase)][i]))
                    choice.phase[i] = int(k);
    mapped_.phase = std::move(choice.phase);
    mapped_.leastShare = std::move(choice.leastShare);
    mapped_.emptied = std::size_t(std::ranges::count(mapped_.phase, leftEmpty));
    mapped_.uncovered = hasFreeSurface_ ? 0 : std::size_t(std::ranges::count(covered_, 0));

    mapped_.mass.assign(target_.mass, target_.mass + n_);
    for (std::size_t i = 0; i < n_; ++i)
        if (const int k = mapped_.phase[i]; k != leftEmpty && k != int(phaseOf(target_, i)))
            mapped_.mass[i] = target_.restDensity[std::size_t(k)] * volume_[i];
}

void Mapper::interpolate()
{
    std::vector<SampledField> fields{{source_, "U", {}}};
    for (const auto& name : settings_.fields) fields.emplace_back(source_, name, Location{});
    std::vector<CloudField*> results;
    for (const auto& field : fields)
    {
        auto& result = mapped_.fields[field.name()];
        result = {field.type(), std::vector(std::size_t(field.components()), std::vector<double>(n_, 0))};
        results.push_back(&result);
    }
    // Means of each phase, for places that see none of it.
    const auto counts = groupSums(
        source_.n, phases_, [&](std::size_t j) { return sourcePhase(j); }, [](std::size_t) { return 1.0; });
    std::vector<std::vector<std::vector<double>>> ofPhase(fields.size());
    for (std::size_t f = 1; f < fields.size(); ++f)
        for (int c = 0; c < fields[f].components(); ++c)
        {
            ofPhase[f].push_back(groupSums(
                source_.n, phases_, [&](std::size_t j) { return sourcePhase(j); }, [&](std::size_t j) { return fields[f](c, j); }));
            for (std::size_t k = 0; k < phases_; ++k) ofPhase[f].back()[k] /= std::max(counts[k], 1.0);
        }

    forParticles(n_, "velocities and fields", say_,
                 [&](std::size_t i)
                 {
                     const int phase = mapped_.phase[i];
                     if (phase == leftEmpty) return;
                     const auto around = covered_[i] ? surroundings_.around(places_[i], Interpolation::linear,
                                                                            [&](std::size_t j) { return phaseOfSource_[j] == phase; })
                                                     : Surrounded{};
                     const bool seesNone = around.weights.empty();
                     // What has come to a place where its phase is not moves with what is there.
                     const auto ofOthers =
                         seesNone && covered_[i] ? surroundings_.around(places_[i], Interpolation::shepard) : Surrounded{};
                     const auto means = withoutNegative(around.weights);
                     for (std::size_t f = 0; f < fields.size(); ++f)
                         for (int c = 0; c < fields[f].components(); ++c)
                         {
                             double& value = results[f]->component[std::size_t(c)][i];
                             const double* const values = fields[f].array(c);
                             if (!values) continue;
                             if (f > 0 && seesNone) value = ofPhase[f][std::size_t(c)][std::size_t(phase)];
                             else if (seesNone) value = ofOthers.weights.empty() ? 0 : ofOthers.weights(values);
                             else value = (f > 0 ? means : around.weights)(values);
                         }
                 });
}

std::vector<PhaseState> Mapper::sums() const
{
    const auto& U = mapped_.fields.at("U").component;
    return groupSums(
        n_, phases_,
        [&](std::size_t i) { return mapped_.phase[i] != leftEmpty && target_.inScene(i) ? std::size_t(mapped_.phase[i]) : phases_; },
        [&](std::size_t i)
        {
            const Vector<3> v{U[0][i], U[1][i], U[2][i]};
            const double m = mapped_.mass[i];
            return PhaseState{1, m, m * v, 0.5 * m * dot(v, v)};
        });
}

/// Gas that the source does not cover stays at rest. Between openings, where masses differ by a part of a layer, mean velocities are kept, and so flow rates.
void Mapper::correctMomentum()
{
    mapped_.interpolated = sums();
    const auto moves = [&](std::size_t i) { return mapped_.phase[i] != leftEmpty && target_.inScene(i) && covered_[i]; };
    const auto mass = groupSums(
        n_, phases_, [&](std::size_t i) { return moves(i) ? std::size_t(mapped_.phase[i]) : phases_; },
        [&](std::size_t i) { return mapped_.mass[i]; });
    std::vector<Vector<3>> shift(phases_);
    for (std::size_t k = 0; k < phases_; ++k)
    {
        const auto &was = mapped_.source[k], &is = mapped_.interpolated[k];
        const double amount = target_.heldBy && was.mass > 0 ? is.mass / was.mass : 1;
        if (mass[k] > 0) shift[k] = (amount * was.momentum - is.momentum) / mass[k];
    }
    auto& U = mapped_.fields.at("U").component;
    for (std::size_t i = 0; i < n_; ++i)
        for (int c = 0; moves(i) && c < target_.dimension; ++c) U[std::size_t(c)][i] += shift[std::size_t(mapped_.phase[i])].*component(c);
    mapped_.corrected = sums();
}

MappedState Mapper::run()
{
    sumSource();
    compareVolumes();
    choose(findShares());
    interpolate();
    correctMomentum();
    return std::move(mapped_);
}
}

MappedState mapState(const ParticleView& source, const ParticleView& target, const MapSettings& settings, const Say& say)
{
    return Mapper(source, target, settings, say).run();
}

}
