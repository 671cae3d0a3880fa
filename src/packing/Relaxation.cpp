#include "packing/Relaxation.hpp"
#include "base/JoinedTrees.hpp"
#include "geometry/components.hpp"
#include "geometry/offWalls.hpp"
#include "models/density/NumberDensity.hpp"
#include "models/walls/ghostRules.hpp"
#include "packing/Repulsion.hpp"
#include "packing/WallDistance.hpp"
#include "packing/relaxationTerms.hpp"
#include "parallel/reduce.hpp"
#include "plan/Plan.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace sph
{

namespace
{
/// Images and lists reach this many spacings beyond the support; they are rebuilt when a particle or image has moved half of it.
constexpr double skin = 0.2;

/// No step moves a particle farther than this many spacings.
constexpr double largestStep = 0.1;

/// Particles are kept this many spacings off a wall; relaxed ones stand about half a spacing off.
constexpr double wallInset = 0.2;

/// Particles stand on one line where their distances from one another across it are below this [spacings].
constexpr double sameLine = 1e-6;

/// The density, and for points that move the repulsion. Where the scene's kernel lets particles pair (cubic spline: closest pair 0.31 spacings on a simple cubic bed at support 2.4, its
/// Fourier transform is negative somewhere), they are pushed with the gradient of a kernel that does not (0.80 spacings).
template<int dim> std::vector<Group> groupsOf(const Kernel<dim>& kernel, bool moves)
{
    std::vector<Group> groups{{NumberDensity::name, {NumberDensity::name, WallDistance::name}}};
    if (!moves) return groups;
    groups.push_back({.name = Repulsion::name, .terms = {Repulsion::name}});
    if (std::holds_alternative<CubicSpline<dim>>(kernel.choice())) groups.back().kernel = OwnKernel{"wendlandC2", kernel.support()};
    return groups;
}

/// Number of the particle that an image is of.
struct Source
{
    static constexpr FieldInfo info{"source", "1"};
    template<int dim, class Real = double> struct At
    {
        Real number;
    };
};

/// Over particles, of the residual r = V_0 sigma - 1.
struct Sums
{
    std::size_t particles = 0;
    double residual = 0, squares = 0, max = 0;

    Sums& operator+=(const Sums& s)
    {
        particles += s.particles;
        residual += s.residual;
        squares += s.squares;
        Larger{}(max, s.max);
        return *this;
    }
    KernelResidual::Moments moments() const
    {
        if (particles == 0) return {};
        const double mean = residual / double(particles), square = squares / double(particles);
        // This order makes NaN the larger of a NaN and 0.
        return {particles, mean, std::sqrt(square), max, std::sqrt(std::max(square - mean * mean, 0.0))};
    }
};

/// Points sorted by cubes of edge `size`, x fastest: neighbours in space become neighbours in memory. Packings are written in this order.
Points sortedByCells(const Points& points, double size)
{
    const std::size_t n = points.size();
    std::array<std::vector<long>, 3> cell;
    for (const auto& [x, cells] : {std::pair(&points.x, &cell[0]), std::pair(&points.y, &cell[1]), std::pair(&points.z, &cell[2])})
    {
        const double low = least(n, [x = x](std::size_t i) { return (*x)[i]; });
        for (const double q : *x) cells->push_back(long((q - low) / size));
    }
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b)
                     { return std::tie(cell[2][a], cell[1][a], cell[0][a]) < std::tie(cell[2][b], cell[1][b], cell[0][b]); });
    Points sorted;
    for (const auto i : order) sorted.add(points[i]);
    return sorted;
}

template<int dim> class Relaxer
{
    const Geometry& geometry_;
    const Kernel<dim>& kernel_;
    const double V0_, spacing_, reach_;
    const std::size_t n_, owned_; ///< particles that are relaxed; with those around
    const Catalogue<dim> catalogue_;
    Plan<dim> plan_;
    FieldStore<dim> store_;
    Images<dim> images_;
    NeighbourLists<dim> lists_;
    std::array<double*, dim> x_;
    const typename NeighbourLists<dim>::Stored stored_; ///< lists that one density and one search read are made for each of them
    std::array<std::vector<double>, dim> atBuild_;      ///< of what moves
    KernelResidual residual_;                           ///< at the present places
    Vector<dim> travelled_{};                           ///< sum over all particles and steps [m]
    std::vector<std::vector<std::size_t>> lines_;       ///< of particles that move as one
    Vector<dim> direction_{};                           ///< of the lines
    std::vector<double> place_;                         ///< of each particle along its line [m]

public:
    /// `moves`: whether `move` will be called.
    Relaxer(const Geometry& geometry, const Kernel<dim>& kernel, double V0, double spacing, const Points& around, const Points& points,
            bool moves)
        : geometry_(geometry),
          kernel_(kernel),
          V0_(V0),
          spacing_(spacing),
          reach_(kernel.support() + skin * spacing),
          n_(points.size()),
          owned_(n_ + around.size()),
          catalogue_(relaxationTerms<dim>(V0)),
          plan_(catalogue_, groupsOf(kernel, moves), {PackingPressure::info.name}),
          images_(geometry, reach_, spacing, 0, nullptr, 0, moves ? recalledWithin(geometry, spacing) : 0),
          stored_(moves ? NeighbourLists<dim>::Stored::yes : NeighbourLists<dim>::Stored::no)
    {
        plan_.allocate(store_);
        store_.allocate(ImageWeight{});
        if (images_.recalls()) store_.allocateState(ImagesMade{});
        // No term reads a velocity; layers ask for a rule all the same.
        images_.rules().set(Velocity{}, std::make_unique<ReflectedVelocity<dim>>(geometry));
        if (!geometry.layers.empty()) images_.setLayers({geometry, kernel, reach_, spacing});
        store_.resize(owned_ + 1, owned_);
        x_ = store_.pointers(Position{});
        const auto sorted = sortedByCells(points, kernel.support()), sortedAround = sortedByCells(around, kernel.support());
        forEach([&](std::size_t i) { place(i, in<dim>(i < n_ ? sorted[i] : sortedAround[i - n_])); });
        rebuild();
    }

    /// Keeps particles that stand behind one another along this unit vector in lines from now on.
    void keepLines(const Vector<3>& along)
    {
        direction_ = in<dim>(along);
        std::map<std::array<long, std::size_t(dim)>, std::vector<std::size_t>> lines;
        for (std::size_t i = 0; i < n_; ++i)
        {
            place_.push_back(dot(position(i), direction_));
            const auto foot = in3D(position(i) - place_[i] * direction_);
            std::array<long, std::size_t(dim)> at;
            for (int c = 0; c < dim; ++c) at[std::size_t(c)] = std::lround(foot.*component(c) / (sameLine * spacing_));
            lines[at].push_back(i);
        }
        for (auto& [_, line] : lines) lines_.push_back(std::move(line));
    }

    /// Distance by which the centre of mass has moved [m].
    double drift() const { return mag(travelled_) / double(n_); }

    void updateDensity()
    {
        const bool rebuilds = stored_ == NeighbourLists<dim>::Stored::yes;
        if (rebuilds && haveMovedFar(0, owned_)) rebuild();
        else
        {
            images_.move(store_);
            if (rebuilds && haveMovedFar(owned_, images_.nullParticle())) rebuild();
        }
        plan_.evaluate(store_, images_, lists_, kernel_, plan_.group(NumberDensity::name));
        residual_ = measured();
    }

    const KernelResidual& residual() const { return residual_; }

    /// Scatter of the particles near walls, or of all where there are no walls.
    double scatter() const { return (residual_.nearWalls.particles ? residual_.nearWalls : residual_.overall).scatter; }

    /// One step; what it returns are the largest shift in spacings and the particles that walls held back.
    std::pair<double, std::size_t> move(double bias, double coefficient)
    {
        const double* const V = store_.component(Volume::info.name, 0);
        double* const P = store_.component(PackingPressure::info.name, 0);
        const double mean = (1 + residual_.overall.mean) / V0_;
        forEach([&](std::size_t i) { P[i] = i < n_ ? bias + 1 / (V[i] * mean) - 1 : bias; });
        plan_.evaluate(store_, images_, lists_, kernel_, plan_.group(Repulsion::name));

        const double C = coefficient * spacing_ * spacing_, limit = largestStep * spacing_;
        const auto f = store_.pointers(PackingGradient{});
        const double* const distance = store_.component(DistanceToWall::info.name, 0);
        const auto total = reduce(
            n_, Shifts{},
            [&](std::size_t i)
            {
                Vector<dim> shift;
                fetch(shift, [&](int c) { return -C * f[c][i]; });
                const double length = mag(shift);
                if (length > limit) shift *= limit / length;
                const auto from = position(i), wanted = from + shift;
                const auto reached = distance[i] - mag(shift) < clearance().looked() ? intoFluid(from, wanted) : wanted;
                place(i, reached);
                return Shifts{std::min(length, limit), std::size_t(!(reached == wanted)), reached - from};
            },
            [](Shifts& all, const Shifts& of) { all += of; });
        travelled_ += total.sum;
        straighten();
        return {total.largest / spacing_, total.held};
    }

    /// Finds what each image is an image of, for `findClosestPair` and `correctPockets`.
    void findSources()
    {
        store_.allocate(GhostWall{});
        store_.allocate(Source{});
        images_.move(store_);
        double* const source = store_.component(Source::info.name, 0);
        forEach([&](std::size_t i) { source[i] = double(i); });
        Images<dim>::template refresh<Source>(images_, store_);
    }

    void findClosestPair(RelaxationResult& result)
    {
        const double *const source = store_.component(Source::info.name, 0), *const wall = store_.component(GhostWall::info.name, 0);
        struct Neighbour
        {
            double r = Box::infinity;
            std::array<std::size_t, 2> pair{};
        };
        const auto nearer = [](Neighbour& nearest, const Neighbour& other)
        {
            if (other.r < nearest.r) nearest = other;
        };
        const auto closest = reduce(
            n_, Neighbour{},
            [&](std::size_t i)
            {
                Neighbour nearest;
                // mirror images of a particle may be as near as the wall is
                typename NeighbourLists<dim>::Room room;
                for (const int j : lists_.of(i, room))
                    if (std::size_t(j) != i && std::size_t(j) != images_.nullParticle() && wall[j] == 0 && source[j] < double(n_))
                        nearer(nearest, {mag(position(i) - position(std::size_t(j))), {i, std::size_t(source[j])}});
                return nearest;
            },
            nearer);
        result.closestPair = closest.r;
        result.closest = closest.pair;
    }

    std::vector<CrowdedParticle> crowded() const
    {
        const double* const V = store_.component(Volume::info.name, 0);
        std::vector<CrowdedParticle> all;
        for (std::size_t i = 0; i < n_; ++i)
            if (const double residual = V0_ / V[i] - 1; residual > crowdedFrom) all.push_back({i, residual});
        return all;
    }

    /// Inside the domain's periodic faces, as they lie now.
    Points points()
    {
        wrap();
        Points all;
        for (std::size_t i = 0; i < n_; ++i) all.add(in3D(position(i)));
        return all;
    }

    /// The points, with more or fewer of them in sealed pockets that differ from the rest, as they lie now. `sealed` counts them.
    Points correctPockets(SealedPockets& sealed) const
    {
        Points corrected;
        std::vector<char> stays(n_, 1);
        const auto [pockets, rest] = sealedPockets();
        sealed.pockets = pockets.size();
        for (const auto& pocket : pockets)
        {
            const double density = meanSum(pocket);
            if (std::fabs(density / rest - 1) < pocketsDiffer) continue;
            const long n = long(pocket.size()), off = std::max(-n, std::lround(double(n) * (1 - rest / density)));
            // Taken out of and put into its whole length alike.
            for (long k = 0; k < std::abs(off); ++k)
            {
                const std::size_t i = pocket[std::size_t((2 * k + 1) * n / (2 * std::abs(off)))];
                if (off > 0) stays[i] = 0;
                else if (const auto other = nearest(i))
                    corrected.add(in3D(position(i) + 0.4 * *other)); // not half-way, where its own may come
            }
        }
        sealed.added = corrected.size();
        for (std::size_t i = 0; i < n_; ++i)
            if (stays[i]) corrected.add(in3D(position(i)));
            else ++sealed.takenOut;
        return corrected;
    }

private:
    struct Shifts
    {
        double largest = 0;
        std::size_t held = 0;
        Vector<dim> sum{};
        Shifts& operator+=(const Shifts& s)
        {
            Larger{}(largest, s.largest);
            held += s.held;
            sum += s.sum;
            return *this;
        }
    };

    /// Calls f(j, x_j - x_i) for the particles within the support of particle i, by number, but for images behind walls; periodic copies count as what they are copies of.
    template<class F> void forEachWithin(std::size_t i, const F& f) const
    {
        const double *const source = store_.component(Source::info.name, 0), *const wall = store_.component(GhostWall::info.name, 0);
        typename NeighbourLists<dim>::Room room;
        for (const int j : lists_.of(i, room))
        {
            const auto k = std::size_t(j);
            if (k == i || k == images_.nullParticle() || wall[k] != 0) continue;
            const auto between = position(k) - position(i);
            if (mag(between) <= kernel_.support()) f(std::size_t(source[k]), between);
        }
    }

    /// Whether there is fluid half-way from particle i.
    bool sees(std::size_t i, const Vector<dim>& between) const
    {
        return store_.component(DistanceToWall::info.name, 0)[i] > 0.5 * kernel_.support() ||
               geometry_.distance(in3D(position(i) + 0.5 * between)) > 0;
    }

    /// From particle i to the nearest that it sees, if there is one.
    std::optional<Vector<dim>> nearest(std::size_t i) const
    {
        std::optional<Vector<dim>> least;
        forEachWithin(i,
                      [&](std::size_t, const Vector<dim>& between)
                      {
                          if ((!least || mag(between) < mag(*least)) && sees(i, between)) least = between;
                      });
        return least;
    }

    /// Mean of V_0 sum_j W_ij.
    double meanSum(const std::vector<std::size_t>& particles) const
    {
        const double* const V = store_.component(Volume::info.name, 0);
        double sum = 0;
        for (const auto i : particles) sum += V0_ / V[i];
        return sum / double(particles.size());
    }

    /// Particles of each pocket, in their order, and the mean sum of the rest: the largest number of particles of which each sees another. What sees particles around is no pocket.
    std::pair<std::vector<std::vector<std::size_t>>, double> sealedPockets() const
    {
        JoinedTrees trees;
        trees.reset(owned_);
        for (std::size_t i = 0; i < owned_; ++i)
            forEachWithin(i,
                          [&](std::size_t j, const Vector<dim>& between)
                          {
                              if (trees.rootOf(i) != trees.rootOf(j) && sees(i, between)) trees.join(i, j);
                          });
        std::map<int, std::vector<std::size_t>> joined;
        for (std::size_t i = 0; i < n_; ++i) joined[trees.rootOf(i)].push_back(i);
        std::set<int> open;
        for (std::size_t i = n_; i < owned_; ++i) open.insert(trees.rootOf(i));
        const auto largest = std::ranges::max_element(joined, {}, [](const auto& one) { return one.second.size(); });
        const double rest = meanSum(largest->second);
        std::vector<std::vector<std::size_t>> pockets;
        for (auto one = joined.begin(); one != joined.end(); ++one)
            if (one != largest && !open.contains(one->first)) pockets.push_back(std::move(one->second));
        return {std::move(pockets), rest};
    }

    template<class F> void forEach(const F& f) const
    {
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < owned_; ++i) f(i);
    }
    Vector<dim> position(std::size_t i) const { return valueAt<Vector<dim>>(x_, i); }
    void place(std::size_t i, Vector<dim> x_i)
    {
        store(x_i, [&](int c, double q) { x_[c][i] = q; });
    }

    void straighten()
    {
        for (const auto& line : lines_)
        {
            Vector<dim> mean{};
            for (const auto i : line) mean += position(i) / double(line.size());
            for (const auto i : line) place(i, mean + (place_[i] - dot(mean, direction_)) * direction_);
        }
    }

    void wrap()
    {
        forEach(
            [&](std::size_t i)
            {
                auto x = in3D(position(i));
                for (int k = 0; k < dim; ++k)
                {
                    const auto c = component(k);
                    if (!geometry_.periodic[k]) continue;
                    if (x.*c < geometry_.low.*c) x.*c += geometry_.length(k);
                    if (x.*c >= geometry_.high.*c) x.*c -= geometry_.length(k);
                }
                place(i, in<dim>(x));
            });
    }

    void rebuild()
    {
        wrap();
        images_.build(store_, owned_);
        x_ = store_.pointers(Position{});
        std::array<const double*, dim> x;
        for (int c = 0; c < dim; ++c)
        {
            x[c] = x_[c];
            if (stored_ == NeighbourLists<dim>::Stored::yes) atBuild_[c].assign(x[c], x[c] + images_.nullParticle());
        }
        lists_.build(x, owned_, images_.nullParticle(), reach_, stored_, plan_.idle());
        plan_.bind(store_, Coefficients{});
    }

    /// Whether one of the particles or images from `begin` to `end` - 1 has since lists were built.
    bool haveMovedFar(std::size_t begin, std::size_t end) const
    {
        const double farthest = most(end - begin,
                                     [&](std::size_t k)
                                     {
                                         Vector<dim> moved;
                                         fetch(moved, [&](int c) { return x_[c][begin + k] - atBuild_[c][begin + k]; });
                                         return dot(moved, moved);
                                     });
        return farthest > sqr(0.5 * skin * spacing_);
    }

    Clearance clearance() const { return {wallInset * spacing_, narrowestCrevice * spacing_}; }

    /// `wanted`, put off the walls; `from` where they leave no room, as where spheres touch.
    Vector<dim> intoFluid(const Vector<dim>& from, const Vector<dim>& wanted) const
    {
        const auto reached = offWalls(images_.nearWalls(), wanted, clearance(), Box::infinity, [](const Vector<dim>&, int) {});
        return images_.nearWalls().nearestFoot(in3D(reached), Box::infinity).foot.distance > 0.5 * clearance().closest ? reached : from;
    }

    KernelResidual measured() const
    {
        const double* const V = store_.component(Volume::info.name, 0);
        const double* const distance = store_.component(DistanceToWall::info.name, 0);
        const double near = kernel_.support();
        struct Both
        {
            Sums overall, nearWalls;
            Both& operator+=(const Both& s)
            {
                overall += s.overall;
                nearWalls += s.nearWalls;
                return *this;
            }
        };
        const auto all = sum(n_,
                             [&](std::size_t i)
                             {
                                 const double r = V0_ / V[i] - 1;
                                 const Sums one{1, r, r * r, std::fabs(r)};
                                 return Both{one, distance[i] < near ? one : Sums{}};
                             });
        return {all.overall.moments(), all.nearWalls.moments()};
    }
};

double biasAt(int step, const RelaxationSettings& s)
{
    const double second = std::clamp(2.0 * step / s.steps - 1, 0.0, 1.0);
    return s.bias[0] * std::pow(s.bias[1] / s.bias[0], second);
}
}

template<int dim>
RelaxationResult relax(const Geometry& geometry, const Kernel<dim>& kernel, double V0, double spacing, const RelaxationSettings& settings,
                       const Points& around, Points& points)
{
    RelaxationResult result;
    Relaxer<dim> relaxer(geometry, kernel, V0, spacing, around, points, settings.steps > 0);
    if (settings.alongLines) relaxer.keepLines(*settings.alongLines);
    relaxer.updateDensity();
    result.before = result.after = relaxer.residual();
    while (result.steps < settings.steps && relaxer.scatter() > settings.tolerance)
    {
        std::tie(result.largestShift, result.heldBack) = relaxer.move(biasAt(result.steps, settings), settings.coefficient);
        relaxer.updateDensity();
        ++result.steps;
    }
    if (result.steps) result.after = relaxer.residual();
    result.crowded = relaxer.crowded();
    relaxer.findSources();
    relaxer.findClosestPair(result);
    result.centreOfMassDrift = relaxer.drift() / spacing;
    if (settings.correctsPockets && points.size() > 0 && !geometry.patches.empty())
        if (auto corrected = relaxer.correctPockets(result.sealed); result.sealed.added + result.sealed.takenOut > 0)
        {
            points = std::move(corrected);
            return result;
        }
    points = relaxer.points();
    return result;
}

template RelaxationResult relax<2>(const Geometry&, const Kernel<2>&, double, double, const RelaxationSettings&, const Points&, Points&);
template RelaxationResult relax<3>(const Geometry&, const Kernel<3>&, double, double, const RelaxationSettings&, const Points&, Points&);

}
