#include "Relaxation.hpp"
#include "PairSums.hpp"
#include "WallImages.hpp"
#include <algorithm>
#include <cmath>
#include <tuple>

namespace sph
{

namespace
{
/// The neighbour table reaches this many spacings beyond the support; it is rebuilt when a particle or image has moved half of it.
constexpr double skin = 0.2;

/// No step moves a particle farther than this many spacings.
constexpr double largestStep = 0.1;

/// Particles are kept this many spacings off a wall; relaxed ones stand about half a spacing off.
constexpr double wallInset = 0.2;

/// Where the kernel itself lets particles pair (cubic spline: closest pair 0.31 spacings on a simple cubic bed at support 2.4, its
/// Fourier transform is negative somewhere), they are pushed with the gradient of a kernel that does not (0.80 spacings).
template<int dim> Kernel<dim> repulsionOf(const Kernel<dim>& kernel)
{
    if (std::holds_alternative<CubicSpline<dim>>(kernel.choice())) return Kernel<dim>("wendlandC2", kernel.support());
    return kernel;
}

template<int dim> class Relaxer
{
    const Geometry& geometry_;
    const Kernel<dim>& kernel_;
    const Kernel<dim> repulsion_;
    const double V0_, spacing_;
    Points& points_;
    std::size_t n_;
    WallImages images_;
    NeighbourTable table_;
    Points atBuild_, gradient_;
    std::vector<double> factor_, sigma_, pressure_;

public:
    Relaxer(const Geometry& geometry, const Kernel<dim>& kernel, double V0, double spacing, Points& points)
        : geometry_(geometry),
          kernel_(kernel),
          repulsion_(repulsionOf(kernel)),
          V0_(V0),
          spacing_(spacing),
          points_(points),
          n_(points.size()),
          images_(geometry)
    {
        const auto order = cellOrder(points, n_, kernel.support());
        Points sorted;
        sorted.resize(n_);
        for (std::size_t i = 0; i < n_; ++i) sorted.set(i, points[order[i]]);
        points = std::move(sorted);
        rebuild();
    }

    std::size_t size() const { return n_; }

    /// Cuts the images off again.
    void finish() { points_.resize(n_); }

    void updateDensity()
    {
        images_.refresh(points_, factor_);
        if (hasMovedFar()) rebuild();
        numberDensity(kernel_, table_, points_, factor_, sigma_);
    }

    KernelResidual residual() const
    {
        KernelResidual r;
        r.overall = moments([](std::size_t) { return true; });
        r.nearWalls = moments([&](std::size_t i) { return isNearWall(i); });
        return r;
    }

    /// Of the particles near walls, or of all where there are no walls.
    double scatter() const
    {
        const auto near = moments([&](std::size_t i) { return isNearWall(i); });
        return near.particles ? near.scatter : moments([](std::size_t) { return true; }).scatter;
    }

    /// One step; what it returns are the largest shift in spacings and the particles that walls held back.
    std::pair<double, std::size_t> move(double bias, double coefficient)
    {
        double mean = 0;
        for (const double s : sigma_) mean += s;
        mean /= double(n_);

        pressure_.assign(points_.size(), bias); // that of layers of the mean density
        for (std::size_t i = 0; i < n_; ++i) pressure_[i] = bias + sigma_[i]/mean - 1;
        for (std::size_t k = 0; k < images_.size(); ++k) pressure_[n_ + k] = pressure_[images_.source(k)];
        pressureGradient(repulsion_, table_, points_, factor_, pressure_, V0_, gradient_);

        const double C = coefficient*spacing_*spacing_, limit = largestStep*spacing_;
        double largest = 0;
        std::size_t held = 0;
        const long n = long(n_);
#pragma omp parallel for schedule(static) reduction(max : largest) reduction(+ : held)
        for (long i = 0; i < n; ++i)
        {
            Vector<3> shift = -C*gradient_[i];
            const double length = mag(shift);
            if (length > limit) shift *= limit/length;
            largest = std::max(largest, std::min(length, limit));
            const Vector<3> wanted = points_[i] + shift;
            const Vector<3> reached = intoFluid(i, points_[i], wanted);
            held += !(reached == wanted);
            points_.set(i, reached);
        }
        return {largest/spacing_, held};
    }

    void findClosestPair(RelaxationResult& result) const
    {
        double closest = Box::infinity;
        for (std::size_t i = 0; i < n_; ++i)
            for (const int j : table_.of(i))
            {
                // mirror images of a particle may be as near as the wall is
                const bool isImage = std::size_t(j) >= n_;
                if (isImage && images_.isOfWall(j - n_)) continue;
                const double r = mag(points_[i] - points_[j]);
                if (r < closest)
                {
                    closest = r;
                    result.closest = {i, isImage ? images_.source(j - n_) : std::size_t(j)};
                }
            }
        result.closestPair = closest;
    }

private:
    void rebuild()
    {
        const double reach = kernel_.support() + skin*spacing_;
        points_.resize(n_);
        images_.build(points_, n_, reach);
        images_.refresh(points_, factor_);
        table_.build(points_, n_, reach);
        atBuild_ = points_;
    }

    bool hasMovedFar() const
    {
        double largest = 0;
        const long all = long(points_.size());
#pragma omp parallel for schedule(static) reduction(max : largest)
        for (long i = 0; i < all; ++i)
        {
            const Vector<3> moved = points_[i] - atBuild_[i];
            largest = std::max(largest, dot(moved, moved));
        }
        return largest > sqr(0.5*skin*spacing_);
    }

    bool isNearWall(std::size_t i) const
    {
        for (const int p : images_.patchesNear(i))
            if (geometry_.patches[p].shape->foot(points_[i]).distance < kernel_.support()) return true;
        return false;
    }

    /// `wanted`, pushed off the walls nearby by projection; `from` where the walls leave no room, as where spheres touch.
    Vector<3> intoFluid(std::size_t i, const Vector<3>& from, Vector<3> wanted) const
    {
        const auto near = images_.patchesNear(i);
        if (near.empty()) return wanted;
        const double inset = wallInset*spacing_;
        for (int sweep = 0; sweep < 4; ++sweep)
        {
            bool isClear = true;
            for (const int p : near)
            {
                const Foot foot = geometry_.patches[p].shape->foot(wanted);
                if (foot.distance >= inset) continue;
                isClear = false;
                wanted += (inset - foot.distance)*foot.normal;
            }
            if (isClear) return wanted;
        }
        double nearest = Box::infinity;
        for (const int p : near) nearest = std::min(nearest, geometry_.patches[p].shape->foot(wanted).distance);
        return nearest > 0.5*inset ? wanted : from;
    }

    template<class Choice> KernelResidual::Moments moments(const Choice& counts) const
    {
        KernelResidual::Moments m;
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < n_; ++i)
        {
            if (!counts(i)) continue;
            const double r = V0_*sigma_[i] - 1;
            ++m.particles;
            sum += r;
            squares += r*r;
            m.max = std::max(m.max, std::fabs(r));
        }
        if (!m.particles) return m;
        m.mean = sum/double(m.particles);
        m.rms = std::sqrt(squares/double(m.particles));
        m.scatter = std::sqrt(std::max(0.0, squares/double(m.particles) - m.mean*m.mean));
        return m;
    }
};

Vector<3> centreOfMass(const Points& p, std::size_t n)
{
    Vector<3> sum;
    for (std::size_t i = 0; i < n; ++i) sum += p[i];
    return sum/double(n);
}

double biasAt(int step, const RelaxationSettings& s)
{
    const double second = std::clamp(2.0*step/s.steps - 1, 0.0, 1.0);
    return s.bias[0]*std::pow(s.bias[1]/s.bias[0], second);
}
}

template<int dim>
RelaxationResult relax(const Geometry& geometry, const Kernel<dim>& kernel, double V0, double spacing,
                       const RelaxationSettings& settings, Points& points)
{
    RelaxationResult result;
    Relaxer<dim> relaxer(geometry, kernel, V0, spacing, points);
    const std::size_t n = relaxer.size();
    const Vector<3> start = centreOfMass(points, n);

    relaxer.updateDensity();
    result.before = result.after = relaxer.residual();
    while (result.steps < settings.steps && relaxer.scatter() > settings.tolerance)
    {
        std::tie(result.largestShift, result.heldBack) = relaxer.move(biasAt(result.steps, settings), settings.coefficient);
        relaxer.updateDensity();
        ++result.steps;
    }
    if (result.steps) result.after = relaxer.residual();
    relaxer.findClosestPair(result);
    relaxer.finish();
    result.centreOfMassDrift = mag(centreOfMass(points, n) - start)/spacing;
    return result;
}

template RelaxationResult relax<2>(const Geometry&, const Kernel<2>&, double, double, const RelaxationSettings&, Points&);
template RelaxationResult relax<3>(const Geometry&, const Kernel<3>&, double, double, const RelaxationSettings&, Points&);

}
