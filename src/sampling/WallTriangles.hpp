/// The walls of a scene as small triangles, on which fields are carried by interpolation.
#pragma once
#include "geometry/TriangleSurface.hpp"
#include "sampling/FluidPart.hpp"
#include <memory>
#include <vector>

namespace sph
{

/// Triangles no longer than half a spacing of Geometry::walls within a region, of each the area that lies in no other solid, and of each point the part D of the kernel's sphere that lies in the
/// fluid's space. All hang on the shapes alone: they are found once, D when it is first asked for, and all again where a wall has moved (MovingWalls).
class WallTriangles
{
public:
    struct Wall
    {
        TriangleSurface surface;
        std::vector<double> areas;      ///< of each triangle [m^2], per metre of depth [m] in 2-D; 0 where another solid covers it
        std::vector<double> fluidParts; ///< D of each point; NaN until asked for
    };

private:
    Box region_;
    double spacing_; ///< [m]
    bool flat_;
    FluidPart fluidPart_;
    std::vector<std::shared_ptr<const Shape>> shapes_; ///< whose triangles these are
    std::vector<Wall> walls_;

    double size() const { return 0.5 * spacing_; } ///< of triangles, at most [m]
    void triangulate(const Geometry&);

public:
    /// Triangles of the view's geometry, for its resolution.
    WallTriangles(const ParticleView&, const Box& region);
    /// Makes them anew where a wall has another shape than it had, as one that moves.
    void follow(const Geometry&);
    std::vector<Wall>& walls() { return walls_; }
    /// The share of the fluid's space about a point that particles fill, min(1, sum_j V_j W_j/D): below 1 beyond the surface of a liquid whose gas is left out. Threads may ask for
    /// different points at once.
    double filled(Wall&, std::size_t point, double coverage, const Geometry&) const;
    /// The place in the scene of a point of a surface: a flat scene lies in the plane z = 0.
    Vector<3> inScene(Vector<3> x) const
    {
        if (flat_) x.z = 0;
        return x;
    }
    /// Twice the area of a triangle times its normal into the fluid.
    static Vector<3> doubledNormal(const TriangleSurface&, std::size_t triangle);
};

}
