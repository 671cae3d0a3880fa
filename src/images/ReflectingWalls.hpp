/// The walls of a scene as chains of reflections meet them: the foot of a particle or of its image so far, and whether an image fills a corner of two solids.
#pragma once
#include "geometry/NearWalls.hpp"
#include "images/Chain.hpp"
#include <vector>

namespace sph
{

class ReflectingWalls
{
    const Geometry* geometry_;
    NearWalls near_;
    std::vector<Reflector> reflectors_;
    double reach_, spacing_, skin_;

public:
    /// Walls within `reach` [m] mirror: the kernel's support and the `skin` [m] of the lists. The geometry must outlive them.
    /// `near` finds walls within `further` [m], where that is more.
    ReflectingWalls(const Geometry&, double reach, double spacing, double skin, double further = 0);

    const Geometry& geometry() const { return *geometry_; }
    const NearWalls& near() const { return near_; }
    std::span<const Reflector> reflectors() const { return reflectors_; }
    double reach() const { return reach_; }
    double spacing() const { return spacing_; }
    double skin() const { return skin_; }
    /// Null where the patch is no mesh.
    const TriangleMesh* meshOf(int patch) const { return geometry_->patches[std::size_t(patch)].mesh; }

    /// The foot of what reflection number `reflection` of a chain mirrors: x is the source itself, or its image so far.
    Foot footOf(Mirror& mirror, int reflection, const Vector<3>& x, const Vector<3>& source) const
    {
        const int p = mirror.patch;
        if (const auto* mesh = meshOf(p))
        {
            Foot f = mesh->body().mirror(mirror.facet, mesh->local(x), mesh->hidden());
            if (geometry_->mayBeCovered(p))
                f.exposure =
                    geometry_->exposure(p, source, reflection == 0 ? f : mesh->body().footOnFace(mirror.facet, mesh->local(source)));
            return f;
        }
        return reflection == 0 ? geometry_->foot(p, x) : geometry_->footOfGhost(p, x, source);
    }

    /// Whether an image x of a chain that ends with patches q and p fills what the two solids leave: it lies in one of them, or they do not meet.
    bool fillsCorner(int p, int q, const Vector<3>& x) const;
    /// Speed of the image over that of what is mirrored, until the lists are built anew: meanwhile the distance grows by half the skin at most, and an image beyond
    /// the support does not matter.
    double speedOf(const Foot&) const;
    /// Largest angle by which the normal turns until the lists are built anew [rad]: the source moves by half the skin at most, and its image `speed` times as far.
    /// A body with edges may show another face at once.
    double turnOf(int patch, const Foot&, double speed) const;
};

}
