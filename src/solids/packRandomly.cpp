#include "solids/Bed.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Spheres of radii R that repel one another where they overlap, and walls alike, all in lengths of the mean diameter:
///
///   E = 1/2 sum_pairs (1 - r_ij/(R_i + R_j))^2 + 1/2 sum_walls (1 - s_i/R_i)^2
///
/// r_ij distance of two centres, s_i of a centre from a wall. At E = 0 nothing overlaps (O'Hern, Silbert, Liu & Nagel 2003). The minimum is
/// sought by FIRE (Bitzek et al. 2006) with that paper's constants.
class SoftSpheres
{
    SolidContainer container_;
    std::vector<double> R_;
    std::vector<Vector<3>> x_, v_, force_, listedAt_;
    std::vector<std::pair<int, int>> pairs_;
    double largestOverlap_ = 0;
    static constexpr double skin_ = 0.1;

    void list()
    {
        double moved = listedAt_.empty() ? skin_ : 0;
        for (std::size_t i = 0; i < listedAt_.size(); ++i) moved = std::max(moved, mag(x_[i] - listedAt_[i]));
        if (moved < 0.5 * skin_) return;
        for (auto& x : x_)
        {
            const auto wrap = [](double a, double length) { return a - length * std::floor(a / length); };
            if (container_.periodic[0]) x.x = wrap(x.x, container_.length);
            if (container_.periodic[1]) x.y = wrap(x.y, container_.width);
            if (container_.periodic[2]) x.z = wrap(x.z, container_.height);
        }
        pairs_ = nearPairs(container_, x_, R_, skin_);
        listedAt_ = x_;
    }

    void wall(std::size_t i, double distance, const Vector<3>& normal)
    {
        const double overlap = 1 - distance / R_[i];
        if (overlap <= 0) return;
        largestOverlap_ = std::max(largestOverlap_, overlap);
        force_[i] += overlap / R_[i] * normal;
    }

    void findForces()
    {
        list();
        largestOverlap_ = 0;
        std::ranges::fill(force_, Vector<3>{});
        for (const auto& [a, b] : pairs_)
        {
            const auto i = std::size_t(a), j = std::size_t(b);
            const auto d = shortest(container_, x_[i] - x_[j]);
            const double r = mag(d), sum = R_[i] + R_[j], overlap = 1 - r / sum;
            if (overlap <= 0 || r == 0) continue;
            largestOverlap_ = std::max(largestOverlap_, overlap);
            const auto f = overlap / (sum * r) * d;
            force_[i] += f;
            force_[j] -= f;
        }
        const auto& c = container_;
        for (std::size_t i = 0; i < x_.size(); ++i)
        {
            const auto& x = x_[i];
            if (!c.periodic[2])
            {
                wall(i, x.z, {0, 0, 1});
                wall(i, c.height - x.z, {0, 0, -1});
            }
            if (c.isCylinder)
            {
                const double r = std::hypot(x.x, x.y);
                if (r > 0) wall(i, c.radius - r, {-x.x / r, -x.y / r, 0});
                continue;
            }
            if (!c.periodic[0])
            {
                wall(i, x.x, {1, 0, 0});
                wall(i, c.length - x.x, {-1, 0, 0});
            }
            if (!c.periodic[1])
            {
                wall(i, x.y, {0, 1, 0});
                wall(i, c.width - x.y, {0, -1, 0});
            }
        }
    }

public:
    SoftSpheres(const SolidContainer& c, const std::vector<Body>& bodies, Noise noise) : container_(c)
    {
        for (const auto& b : bodies)
        {
            R_.push_back(0.5 * b.size);
            double x = noise.between(0, c.length), y = noise.between(0, c.width);
            if (c.isCylinder)
            {
                const double r = c.radius * std::sqrt(noise()), angle = 2 * std::numbers::pi * noise();
                x = r * std::cos(angle);
                y = r * std::sin(angle);
            }
            x_.push_back({x, y, noise.between(0, c.height)});
        }
        v_.resize(x_.size());
        force_.resize(x_.size());
    }

    const std::vector<Vector<3>>& centres() const { return x_; }
    double largestOverlap() const { return largestOverlap_; }
    double solidVolume() const
    {
        double sum = 0;
        for (const double R : R_) sum += 4 * std::numbers::pi / 3 * R * R * R;
        return sum;
    }
    void scaleSizes(double factor)
    {
        for (auto& R : R_) R *= factor;
        listedAt_.clear();
    }

    /// True where at most `steps` steps part all spheres but for relative overlaps of `tolerance`.
    bool part(int steps, double tolerance)
    {
        constexpr double longest = 0.3, start = 0.1, grow = 1.1, halve = 0.5, mixing = 0.1, calmer = 0.99;
        constexpr int delay = 5;
        double dt = start, alpha = mixing;
        int downhill = 0;
        std::ranges::fill(v_, Vector<3>{});
        findForces();
        for (int step = 0; step < steps && largestOverlap_ > tolerance; ++step)
        {
            double power = 0, ff = 0, vv = 0;
            for (std::size_t i = 0; i < x_.size(); ++i)
            {
                power += dot(force_[i], v_[i]);
                ff += dot(force_[i], force_[i]);
                vv += dot(v_[i], v_[i]);
            }
            if (power > 0)
            {
                const double along = ff > 0 ? alpha * std::sqrt(vv / ff) : 0;
                for (std::size_t i = 0; i < v_.size(); ++i) v_[i] = (1 - alpha) * v_[i] + along * force_[i];
                if (++downhill > delay)
                {
                    dt = std::min(grow * dt, longest);
                    alpha *= calmer;
                }
            }
            else
            {
                std::ranges::fill(v_, Vector<3>{});
                dt *= halve;
                alpha = mixing;
                downhill = 0;
            }
            for (std::size_t i = 0; i < x_.size(); ++i)
            {
                v_[i] += dt * force_[i];
                x_[i] += dt * v_[i];
            }
            findForces();
        }
        return largestOverlap_ <= tolerance;
    }
};

/// Overlaps that are none, over the size; radii are reduced by as much in the end.
constexpr double none = 1e-6;
constexpr int mostSteps = 20000;

/// The largest solid fraction at which the spheres can be parted, from one reached to the next (O'Hern et al. 2003), then by bisection.
void compress(SoftSpheres& spheres, double volume, const Progress& progress)
{
    constexpr double step = 0.02, finest = 1e-4;
    double reached = spheres.solidVolume() / volume, missed = 1;
    while (missed - reached > finest)
    {
        const auto before = spheres;
        const double next = missed < 1 ? 0.5 * (reached + missed) : reached + step;
        spheres.scaleSizes(std::cbrt(next / reached));
        const bool done = spheres.part(mostSteps, none);
        progress(fmt::format("solid fraction {:.5f}: {}", next, done ? "reached" : "not reached"));
        (done ? reached : missed) = next;
        if (!done) spheres = before;
    }
}

}

void packRandomly(const SolidsPlan& plan, Bed& bed, const Progress& progress)
{
    // The number is that which comes nearest to the porosity; all sizes change by the rest. Random close packing of equal spheres has 0.36.
    constexpr double closest = 0.36, start = 0.5;
    const double porosity = plan.porosity.value_or(closest), solid = (1 - porosity) * plan.container.volume();
    constexpr int quantiles = 1000, most = 1'000'000;
    const double wanted = solid / plan.size.meanVolume(quantiles);
    if (wanted < 1 || wanted > most)
        throw CaseError(plan.size.where,
                        fmt::format("a porosity of {:g} takes {:.3g} spheres of this size; 1 to {} are possible", porosity, wanted, most));
    const int count = int(std::lround(wanted));
    bed.bodies = drawBodies(plan, count);
    const double unit = bed.meanSize = plan.size.mean(count);
    auto c = plan.container;
    for (double* length : {&c.length, &c.width, &c.radius, &c.height}) *length /= unit;
    for (auto& b : bed.bodies) b.size /= unit;
    progress(fmt::format("{} spheres", count));

    SoftSpheres spheres(c, bed.bodies, Noise(plan.seed + 1));
    const double asked = spheres.solidVolume();
    if (plan.porosity)
    {
        // Larger by what they lose again
        spheres.scaleSizes(std::cbrt((1 - porosity) * c.volume() / asked) / (1 - none));
        if (!spheres.part(10 * mostSteps, none))
            throw CaseError(plan.porosityAt,
                            fmt::format("spheres still overlap by {:.2g} of their size at a porosity of {:g}, which is less than "
                                        "these sizes have in this container. Without the entry the least is sought",
                                        spheres.largestOverlap(), porosity));
    }
    else
    {
        spheres.scaleSizes(std::cbrt(start * c.volume() / asked));
        if (!spheres.part(mostSteps, none))
            throw CaseError(plan.container.where, "spheres of this size do not fit into the container at a porosity of 0.5");
        compress(spheres, c.volume(), progress);
    }
    spheres.scaleSizes(1 - none);
    bed.sizeFactor = std::cbrt(spheres.solidVolume() / asked);
    bed.meanSize *= bed.sizeFactor;
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        bed.bodies[i].centre = unit * spheres.centres()[i];
        bed.bodies[i].size *= unit * bed.sizeFactor;
        bed.bodies[i].rotation = {};
    }

    // Touching: what moved by less than the last step of the compression would close.
    constexpr double touching = 1e-3;
    std::vector<Vector<3>> centres;
    std::vector<double> reach;
    for (const auto& b : bed.bodies)
    {
        centres.push_back(b.centre);
        reach.push_back(0.5 * b.size);
    }
    for (const auto& [i, j] : nearPairs(plan.container, centres, reach, touching * bed.meanSize))
        bed.contacts.push_back({i, j,
                                mag(shortest(plan.container, centres[std::size_t(i)] - centres[std::size_t(j)])) - reach[std::size_t(i)] -
                                    reach[std::size_t(j)]});
}

}
