/// Check whether reflection can represent the walls of a scene: curvature, gaps, contacts and overlaps against the kernel support H.
///
/// An image exists as far as the nearest centre of curvature, so that R > H is needed on either side of a curved wall (Barker et al.
/// 2012 do not say so). Gaps narrower than H are legal: second reflections fill them; they are reported, since the flow in them is not
/// resolved.
/// Surfaces may meet where the fluid between them has an angle of 90 degrees or more (corners of a box, ends of a tube), and balls may overlap by a
/// tenth of a diameter, as packers leave them: a contact. Spheres of a table that overlap by more are named by their rows. Sharper wedges of other bodies are an error, between the walls of a container a warning. A wall may slide along itself and nowhere else. The part of a wall in another solid is none of
/// it (solidUnion.cpp): a step on the floor may be thinner than two supports; a body that no fluid can reach is an error.
#pragma once
#include "geometry/Geometry.hpp"
#include <string>
#include <vector>

namespace sph
{

/// The place where two surfaces come nearest to each other with fluid between them.
struct Gap
{
    double width = Box::infinity; ///< [m]; 0 where they touch
    Vector<3> at;                 ///< middle of the gap
    int wall = -1;                ///< on the other side
};

struct WallReport
{
    std::string type;                      ///< of its shapes, "sphere"; several with commas
    std::string fluid;                     ///< "inside", "outside", or "normal" for planes
    int shapes = 0;                        ///< before repetition
    double smallestRadius = Box::infinity; ///< of curvature, where the fluid meets the wall within the domain [m]
    Vector<3> smallestRadiusAt;
    Gap narrowest;    ///< to any other shape, contacts left out
    int contacts = 0; ///< with this wall's other shapes and those of other walls, per period
};

struct GeometryReport
{
    std::vector<WallReport> walls; ///< one for each of Geometry::walls
    double fluidFraction = 1;      ///< volume of the fluid over that of the domain
    double fluidFractionError = 0; ///< standard error of the sampling
    int contacts = 0;              ///< in the domain, each once
    double overlap = 0;            ///< largest of two balls, or of a ball and another solid, over the smaller diameter
    Vector<3> overlapAt;
};

/// Records errors and warnings at the walls they concern. `geometry.reach` must be at least H [m].
GeometryReport checkGeometry(const Geometry&, double H, Diagnostics&);

}
