/// Pictures of a scene, drawn off screen into a PNG file. Needs a display: see VirtualDisplay.
#pragma once
#include "surfaces/IsoSurface.hpp"
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

struct Camera
{
    std::optional<Vector<3>> position, focalPoint;
    std::optional<Vector<3>> facing; ///< without a position: the normal of a plane to look at
    Vector<3> up{0, 1, 0};
    double zoom = 1;
};

/// Particles drawn as discs (2-D) or spheres (3-D).
struct Points
{
    std::vector<Vector<3>> position;
    std::vector<double> value;                  ///< what the colour shows
    std::optional<std::array<double, 2>> range; ///< of the colours; that of the values unless given
    double diameter = 0;
    std::string title;               ///< of the colour bar; unused for phases
    std::vector<std::string> phases; ///< names where `value` is the number of a phase; else a continuous scale
};

/// Colours of the values that the points of a surface have as their scalars.
struct SurfaceColours
{
    std::string title; ///< of the colour bar
    std::optional<std::array<double, 2>> range;
};

/// Contents of a picture; an empty mesh or list is left out.
struct Scene
{
    int dimension = 3;
    Vector<3> low, high;                         ///< the domain, whose outline is drawn
    Mesh liquid, liquidCuts;                     ///< surface, and where the domain's faces cut through it
    std::optional<SurfaceColours> liquidColours; ///< of both; none: that of water, translucent
    Mesh walls, wallCuts;
    double wallOpacity = 1;
    Mesh contour; ///< 2-D surface line
    Points points;
    Camera camera;
    std::array<int, 2> size{1200, 900}; ///< pixels
    std::string title;
    bool scaleBar = false; ///< a length to measure by
};

/// The largest of 1, 2 and 5 times a power of ten up to `most`.
double roundLength(double most);

/// Throws CaseError where the file cannot be written.
void drawPicture(const Scene&, const std::filesystem::path& png);

}
