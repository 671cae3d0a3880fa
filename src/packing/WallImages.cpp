#include "WallImages.hpp"
#include "PatchGrid.hpp"
#include "components.hpp"
#include "periodicShifts.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sph
{

namespace
{
/// Two patches that meet at a fluid angle above about 105 degrees cover the corner with one reflection each; a second one would
/// cover it twice. n_p . n_q = -cos(angle).
constexpr double mostAlignedNormals = 0.26;

/// Beside a centre of curvature on the fluid side the volume factor diverges: such an image stands for nothing.
constexpr double largestFactor = 10;

constexpr std::size_t chunkSize = 512;
}

/// Images of a run of consecutive points. Chunks are joined in order, so that the number of threads does not matter.
struct WallImages::Chunk
{
    std::vector<Image> images;
    std::vector<Vector<3>> at; ///< mirror images of the present point, to find those that coincide
    std::vector<int> near, nearCount;
};

WallImages::WallImages(const Geometry& geometry) : geometry_(geometry), all_(geometry.patches.size())
{
    std::iota(all_.begin(), all_.end(), 0);
}

std::span<const int> WallImages::candidates(const Vector<3>& x, double reach) const
{
    if (geometry_.grid && reach <= geometry_.reach*(1 + 1e-12)) return geometry_.grid->near(x);
    return all_;
}

bool WallImages::isWithin(double reach, const Vector<3>& x) const
{
    for (int k = 0; k < geometry_.dimension; ++k)
        if (x.*component(k) < geometry_.low.*component(k) - reach || x.*component(k) > geometry_.high.*component(k) + reach)
            return false;
    return true;
}

void WallImages::reflect(Chunk& chunk, const Image& parent, int reflections, const Vector<3>& x, double factor,
                         const Vector<3>& previousNormal, double reach) const
{
    const double coincident = 1e-7*reach;
    for (const int p : candidates(x, reach))
    {
        if (reflections > 0 && p == parent.patch[reflections - 1]) continue;
        const Foot foot = geometry_.patches[p].shape->foot(x);
        if (!foot.smooth || foot.distance <= 0 || foot.distance >= reach) continue;
        if (reflections > 0 && dot(foot.normal, previousNormal) > mostAlignedNormals) continue;
        const double w = factor*volumeFactor(foot);
        if (!(w > 0) || w > largestFactor) continue;

        if (reflections == 0)
        {
            // A foot point that lies in the solid of another patch is no part of the wall.
            const Vector<3> footPoint = x - foot.distance*foot.normal;
            bool isWall = true;
            for (const int q : candidates(footPoint, reach))
                isWall &= q == p || geometry_.patches[q].shape->foot(footPoint).distance > -coincident;
            if (!isWall) continue;
        }

        const Vector<3> mirrored = mirrorImage(x, foot);
        if (!isWithin(reach, mirrored)) continue;
        const bool known = std::any_of(chunk.at.begin(), chunk.at.end(),
                                       [&](const Vector<3>& other)
                                       {
                                           return std::fabs(other.x - mirrored.x) < coincident &&
                                                  std::fabs(other.y - mirrored.y) < coincident &&
                                                  std::fabs(other.z - mirrored.z) < coincident;
                                       });
        if (known) continue;

        Image image = parent;
        image.patch[reflections] = p;
        chunk.images.push_back(image);
        chunk.at.push_back(mirrored);
        if (reflections + 1 < mostReflections) reflect(chunk, image, reflections + 1, mirrored, w, foot.normal, reach);
    }
}

void WallImages::copyLayers(double reach)
{
    for (const auto& particle : geometry_.layers)
    {
        const auto add = [&](const Vector<3>& by)
        {
            if (const auto x = particle.x + by; isWithin(reach, x)) layers_.push_back({x, particle.volumeFactor, particle.wall});
        };
        add({});
        forEachPeriodicShift(geometry_, add);
    }
}

void WallImages::build(const Points& points, std::size_t n, double reach)
{
    n_ = n;
    if (layers_.empty()) copyLayers(reach);
    const Vector<3> length = geometry_.high - geometry_.low;
    std::array<int, 3> copies{};
    for (int k = 0; k < geometry_.dimension; ++k)
        if (geometry_.periodic[k]) copies[k] = int(std::ceil(reach/geometry_.length(k)));

    const std::size_t chunks = (n + chunkSize - 1)/chunkSize;
    std::vector<Chunk> chunk(chunks);
#pragma omp parallel for schedule(dynamic)
    for (std::size_t c = 0; c < chunks; ++c)
        for (std::size_t i = c*chunkSize; i < std::min(n, (c + 1)*chunkSize); ++i)
        {
            const Vector<3> x = points[i];
            const std::size_t nearBefore = chunk[c].near.size();
            for (const int p : candidates(x, reach))
                if (geometry_.patches[p].shape->foot(x).distance < reach) chunk[c].near.push_back(p);
            chunk[c].nearCount.push_back(int(chunk[c].near.size() - nearBefore));

            chunk[c].at.clear();
            for (int sz = -copies[2]; sz <= copies[2]; ++sz)
                for (int sy = -copies[1]; sy <= copies[1]; ++sy)
                    for (int sx = -copies[0]; sx <= copies[0]; ++sx)
                    {
                        const Vector<3> shift{sx*length.x, sy*length.y, sz*length.z};
                        const Vector<3> copy = x + shift;
                        if (!isWithin(reach, copy)) continue;
                        Image image{int(i), {-1, -1, -1}, shift};
                        if (sx || sy || sz) chunk[c].images.push_back(image);
                        if (layers_.empty()) reflect(chunk[c], image, 0, copy, 1, {}, reach);
                    }
        }

    images_.clear();
    near_.clear();
    nearStart_.assign(1, 0);
    for (const auto& part : chunk)
    {
        images_.insert(images_.end(), part.images.begin(), part.images.end());
        near_.insert(near_.end(), part.near.begin(), part.near.end());
        for (const int count : part.nearCount) nearStart_.push_back(nearStart_.back() + count);
    }
}

void WallImages::refresh(Points& points, std::vector<double>& factor) const
{
    points.resize(n_ + images_.size() + layers_.size());
    factor.resize(points.size());
    std::fill(factor.begin(), factor.begin() + n_, 1.0);
    const long images = long(images_.size());
#pragma omp parallel for schedule(static)
    for (long k = 0; k < images; ++k)
    {
        const Image& image = images_[k];
        Vector<3> x = points[image.source] + image.shift;
        double w = 1;
        for (const int p : image.patch)
        {
            if (p < 0) break;
            const Foot foot = geometry_.patches[p].shape->foot(x);
            w *= volumeFactor(foot);
            x = mirrorImage(x, foot);
        }
        points.set(n_ + k, x);
        factor[n_ + k] = std::clamp(w, 0.0, largestFactor);
    }
    for (std::size_t k = 0; k < layers_.size(); ++k)
    {
        points.set(n_ + images_.size() + k, layers_[k].x);
        factor[n_ + images_.size() + k] = layers_[k].volumeFactor;
    }
}

}
