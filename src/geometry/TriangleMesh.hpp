/// A closed surface of triangles as a wall: one body, or a body with its cavities, that periodic copies share.
#pragma once
#include "geometry/FacetBody.hpp"
#include <memory>

namespace sph
{

class TriangleMesh : public Shape
{
    std::shared_ptr<const FacetBody> body_;
    Vector<3> offset_;
    std::vector<char> hidden_; ///< facets in other solids; empty where there are none

public:
    explicit TriangleMesh(std::shared_ptr<const FacetBody> body, const Vector<3>& offset = {}) : body_(std::move(body)), offset_(offset) {}

    const FacetBody& body() const { return *body_; }
    /// A copy of the mesh with facets hidden in other solids.
    std::shared_ptr<const TriangleMesh> withHidden(std::vector<char> facets) const
    {
        auto mesh = std::make_shared<TriangleMesh>(body_, offset_);
        mesh->hidden_ = std::move(facets);
        return mesh;
    }
    FacetBody::Hidden hidden() const { return hidden_; }
    /// Position in the body's coordinates, from one in the scene's.
    Vector<3> local(const Vector<3>& x) const { return x - offset_; }

    Foot foot(const Vector<3>& x) const override { return body_->foot(local(x)); }
    double distance(const Vector<3>& x, double within) const override { return body_->foot(local(x), within).distance; }
    Box bounds() const override { return {body_->bounds().low + offset_, body_->bounds().high + offset_}; }
    double smallestRadius() const override { return body_->smallestRadius(); }
    bool hasEdges() const override { return true; }
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override;
    ShapeDescription description() const override;
    bool invariantAlong(int) const override { return false; }
    bool enclosesFluid() const override { return body_->volume() < 0; }
    TriangleSurface triangles(const Box&, double size) const override;
    /// Facets of one region of the mesh, as they are.
    TriangleSurface region(int) const;
};

/// The bodies of a closed surface: each connected part by itself, a cavity with the body around it. Bodies may touch and overlap.
std::vector<std::shared_ptr<const FacetBody>> bodiesOf(const FacetSurface&, const FacetScale&);

/// Whether a patch is known, without a search, to be farther from x than that [m]; of one that is no mesh (null) nothing is known.
inline bool isBeyond(const TriangleMesh* mesh, const Vector<3>& x, double least)
{
    return mesh && mesh->body().isBeyond(mesh->local(x), least);
}

/// Null where the shape is no mesh.
inline const TriangleMesh* asMesh(const Shape& shape) { return dynamic_cast<const TriangleMesh*>(&shape); }

}
