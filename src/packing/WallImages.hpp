/// Images of the particles: periodic copies, and mirror images in the walls with their volume factors. Where walls are layers of particles
/// (Geometry::layers) these stand in the place of mirror images, with periodic copies of their own.
///
/// A particle (or a periodic copy of it) is reflected in each patch near it; the mirror image is reflected again in patches that
/// face it, up to three times in all. This fills the corners of a box (1/4 and 1/8 of the kernel), channels down to half a support
/// wide, and the pinch between two touching spheres, where one reflection leaves the number density at 0.86 of its value at a half gap
/// of 0.31 spacings and the second brings it to 0.96 (a prototype's quadrature; not remeasured here).
#pragma once
#include "Geometry.hpp"
#include "Points.hpp"
#include <array>
#include <span>
#include <vector>

namespace sph
{

class WallImages
{
public:
    explicit WallImages(const Geometry&);

    /// Finds all images of the first `n` points that lie within `reach` of the domain.
    void build(const Points& points, std::size_t n, double reach);

    /// Appends the images, recomputed from the first `n` points, behind them, with their volume factors (1 for the points), and the layers.
    void refresh(Points& points, std::vector<double>& factor) const;

    /// Without the layers.
    std::size_t size() const { return images_.size(); }
    std::size_t points() const { return n_; }
    std::size_t source(std::size_t image) const { return images_[image].source; }
    /// Or a particle of a layer.
    bool isOfWall(std::size_t image) const { return image >= images_.size() || images_[image].patch[0] >= 0; }

    /// The patches within reach of a point.
    std::span<const int> patchesNear(std::size_t i) const
    {
        return {near_.data() + nearStart_[i], near_.data() + nearStart_[i + 1]};
    }

private:
    static constexpr int mostReflections = 3;

    struct Image
    {
        int source;
        std::array<int, mostReflections> patch; ///< in the order of reflection, -1 behind the last
        Vector<3> shift;
    };
    struct Chunk;

    void reflect(Chunk&, const Image&, int reflections, const Vector<3>& x, double factor, const Vector<3>& previousNormal,
                 double reach) const;
    bool isWithin(double reach, const Vector<3>& x) const;
    void copyLayers(double reach);
    /// Patches that may be within reach of x, and others.
    std::span<const int> candidates(const Vector<3>& x, double reach) const;

    const Geometry& geometry_;
    std::vector<int> all_;
    std::size_t n_ = 0;
    std::vector<Image> images_;
    std::vector<LayerParticle> layers_;     ///< with their periodic copies
    std::vector<int> near_;
    std::vector<std::size_t> nearStart_;
};

}
