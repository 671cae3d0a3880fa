/// Settings of system/reconstructSurfaceDict; every entry has a default, so that the file may be missing.
#pragma once
#include "dictionary/Dictionary.hpp"
#include "surfaces/ColourFunction.hpp"
#include "surfaces/Cuts.hpp"
#include "surfaces/Picture.hpp"
#include <optional>
#include <string>
#include <vector>

namespace sph
{

/// Facts of a case on which the defaults rest.
struct SurfaceCase
{
    double spacing = 0;              ///< of the particles [m]
    std::vector<std::string> phases; ///< at least one
    Vector<3> up{0, 1, 0};           ///< against gravity
};

struct PictureSettings
{
    std::array<int, 2> size{1200, 900};
    Camera camera;
    bool surface = true, walls = true, particles = false;
    std::vector<std::string> shownWalls; ///< by name; empty: all
    std::string colourBy;                ///< a field, or "phase"; empty: none was asked for
    Location whereColourBy;
    std::optional<std::array<double, 2>> range; ///< of the colours; that of the values unless given
    int smoothing = 20;
    CutPlane plane{{}, {0, 0, 1}};
    bool allParticles = false;   ///< in 3-D; else those on the plane
    std::optional<CutPlane> cut; ///< before which nothing is shown
    double wallOpacity = 1;
    std::string title;
    bool showTime = true, scaleBar = false;
    double framesPerSecond = 10; ///< [1/s] of a sequence

    bool particlesOnPlane() const { return particles && !allParticles; }
    /// The field that colours the surface, empty for its own colour.
    std::string surfaceField() const { return particles ? "" : colourBy; }
};

struct SurfaceSettings
{
    std::string cloud;
    std::vector<int> phases;             ///< numbers in SurfaceCase::phases
    double gridSpacing = 0, support = 0; ///< [m]
    Location whereGridSpacing;
    std::string kernel;
    std::optional<double> iso;              ///< empty: the level that encloses the particles' volume
    std::optional<Normalisation> normalise; ///< empty: particles where another phase is there, else walls
    bool closed = false;
    int smoothing = 0;
    std::vector<std::string> formats;
    PictureSettings picture;
};

/// The default support is measured, on a sphere of radius 16 spacings, particles displaced by 0.15 spacings at random, step half
/// a spacing: support 1.5/2/2.5/3 spacings gives the area +9.0/+3.6/+1.4/+0.5 % and the volume within 0.4 %.
SurfaceSettings readSurfaceSettings(const Dictionary&, const SurfaceCase&, const Geometry&);

}
