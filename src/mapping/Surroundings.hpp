/// Particles around any point of the fluid, in sight of it, and the weights that make a value of theirs.
#pragma once
#include "mapping/Sight.hpp"
#include "sampling/Interpolator.hpp"
#include <functional>
#include <memory>
#include <mutex>

namespace sph
{

/// Weights f(x) = sum_j w_j f_j, sum_j w_j = 1, of the particles around a point.
struct Surrounded
{
    PointWeights weights; ///< empty where no particle is within reach
    double nearest = 0;   ///< distance of the nearest of them [m]
    /// Whether the support of the kernel has any. Beyond it the weight is that of the nearest particle alone.
    bool bySupport = false;
};

/// The particles of a scene as their neighbours at any point see them.
///
/// Within the support of the kernel weights are those of Interpolator, linear or by Shepard; those of a particle at the point itself are 1 for it and 0 for all
/// others, so that what is interpolated to the particles' own places is what they have. Linear weights with sum_j |w_j| > 2 (few particles, far to one
/// side, whose noise they would amplify) give way to Shepard's. Where the support has none the nearest particle within two and then four supports
/// counts alone: between spheres that nearly touch, coarse particles end before fine ones do.
///
/// A particle counts where the straight way to it, or to its periodic copy, is free of walls (Sight). Verified by test/unit/mapping (Surroundings).
class Surroundings
{
public:
    /// Keeps the view, which must outlive this with its arrays and the geometry.
    Surroundings(const ParticleView&, const Geometry& walls);

    using Admits = std::function<bool(std::size_t particle)>;
    /// `toWall` is the point's distance from the walls. `supports`: how far the search goes, 1 to 4.
    Surrounded around(const PlacedPoint&, Interpolation, const Admits& admits = {}, int supports = 4) const;

    const Sight& sight() const { return sight_; }

private:
    ParticleView view_;
    Sight sight_;
    std::vector<double> toWall_; ///< of the particles [m]

    /// Interpolators of one, two and four supports: most scenes need the first alone.
    struct Reach
    {
        std::once_flag isMade;
        std::unique_ptr<Interpolator> interpolator;
    };
    mutable std::array<Reach, 3> reaches_;
    const Interpolator& reach(int k) const;
};

}
