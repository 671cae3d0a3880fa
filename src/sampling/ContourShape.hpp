/// The level set of an expression of particles, and the shape that it has.
#pragma once
#include "sampling/FunctionContext.hpp"
#include "sampling/LevelSet.hpp"
#include "sampling/ParticleExpression.hpp"
#include <optional>

namespace sph
{

struct SphereFit;

/// Numbers of a level set; NaN where there is none, or it is no such shape.
struct ContourFigures
{
    double area = 0;        ///< of the level set [m^2], in 2-D and in a cut its length [m]
    double volume = 0;      ///< where the value is above the level [m^3], in 2-D and in a cut its area [m^2]
    double rear, front;     ///< least and largest coordinate along the direction [m]
    Vector<3> centroid;     ///< of the volume [m]
    double radius;          ///< of the circle or sphere [m]
    Vector<3> centre;       ///< of it [m]
    double misfit;          ///< root of the mean square distance from it [m]
    double angle;           ///< with the wall [degrees]
    Vector<3> semiAxes;     ///< of the ellipse or ellipsoid, longest first [m]
    double least, most;     ///< values of the expression where it was asked for
    std::size_t places = 0; ///< that the numbers rest on

    ContourFigures();
};

/// A number of a contour by the word that asks for it.
struct ContourFigure
{
    Column column;
    double (*of)(const ContourFigures&);
};
const std::vector<ContourFigure>& contourFigures();

/// Dictionary:
///
///     phase   water;                                  // the surface of a phase: its volume fraction is 1/2
///     value   "$T"; level 330;                        // or: where an expression has a value
///     region  { min (0 0 0); max (1 1 0.5); }         // within a box
///     cut     { point (0 0 1); normal (0 0 1); }      // in a plane, in 2-D on a line
///     wall    floor; above 2.5;                       // the angle with a wall
///     direction (1 0 0);                              // along which `front` and `rear` lie
///     centre  (0 0 0);                                // of the circle or sphere, where it is known
///     endsAtWalls no;                                 // the kernel's mean goes on into the wall
///
/// The volume fraction is C(x) = sum_j V_j W_j C_j/sum_j V_j W_j with C_j = 1 in the phase, of a scene with one phase sum_j V_j W_j/D (FluidPart); particles are mirrored in planes of symmetry. An
/// expression is carried to x by weights that are exact for linear fields (Interpolator), and its level set ends where the fluid ends. f is found at the nodes of a lattice of one spacing; the level set is
/// LevelSet's, and ends at walls.
///
/// radius and centre are those of the circle or sphere nearest to the level set (SphereFit). A wall, plane or equally curved all around, is met at the angle
///
///   cos theta = -h/R - k (R^2 - h^2)/(2 R)
///
/// through the side where the value is above the level, with R [m] the radius, h [m] the height of the centre above the wall, k [1/m] the wall's curvature, negative for fluid outside a sphere (Shape.hpp). What lies
/// nearer to the wall than `above` spacings is not fitted then: there the profile of a diffuse interface bends, and base and height of a drop would give an angle up to 10 degrees off.
///
/// Where the scene is periodic and no region is given, what is above the level is kept in one piece: coordinates are continued across the periodic face.
class ContourShape
{
    std::optional<ParticleExpression> value_;
    std::optional<std::size_t> phase_;
    double level_;
    std::optional<Box> region_;
    struct Cut
    {
        Vector<3> point, normal;
    };
    std::optional<Cut> cut_;
    std::optional<std::size_t> wall_;
    double above_; ///< [spacings]
    bool endsAtWalls_;
    Vector<3> direction_;
    std::optional<Vector<3>> centre_;

    class Sampled;
    Box box(const ParticleView&, const std::vector<double>& values) const;
    Lattice lattice(const ParticleView&, const Box&) const;
    void fit(const ParticleView&, const LevelSet&, const Lattice&, ContourFigures&) const;
    double angleWith(const ParticleView&, const SphereFit&, bool isAboveInside) const;

public:
    static EntryList entries();
    /// `numbers`, `later`: names that the expression may have (ParticleExpression).
    ContourShape(const Dictionary&, const FunctionContext&, const std::vector<std::string>& numbers = {},
                 const std::vector<std::string>& later = {});
    ContourFigures operator()(const ParticleView&, const NamedNumbers& = {}) const;
    bool hasWall() const { return bool(wall_); }
    double level() const { return level_; }
};

}
