/// Surfaces and pictures of the times of one case.
#pragma once
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "geometry/Geometry.hpp"
#include "geometry/OpenEnds.hpp"
#include "surfaces/SurfaceSettings.hpp"
#include <optional>
#include <string>
#include <vector>

namespace sph
{

/// What is told of a surface, in SI units; area and volume are length and area in 2-D.
struct SurfaceReport
{
    std::string phase;
    std::size_t particles = 0; ///< in the scene
    std::size_t held = 0;      ///< beyond openings
    double area = 0, volume = 0, particleVolume = 0;
    double level = 0.5; ///< of the colour function on it
    int pieces = 0;
    /// Difference of the enclosed volume from that of the particles [%].
    double differencePercent() const { return particleVolume > 0 ? 100 * (volume / particleVolume - 1) : 0; }
};

struct TimeResult
{
    std::vector<SurfaceReport> surfaces;
    std::vector<std::string> written; ///< files, relative to the case
};

class SurfaceRun
{
    const Case& case_;
    SurfaceCase scene_;
    Geometry geometry_;
    SurfaceSettings settings_;
    std::optional<OpenEnds> openEnds_;
    /// A grid and the distances of its nodes from the walls and, where the case has openings, from their planes as well, behind which there is no scene.
    struct Space
    {
        RegularGrid grid;
        std::vector<double> wallDistance, toOpenEnds;
        const std::vector<double>& sceneDistance() const { return toOpenEnds.empty() ? wallDistance : toOpenEnds; }
    };
    Space space_; ///< of the domain, once for all times; where that has too many nodes for its surfaces, a coarser one that shows the walls
    bool sparse_; ///< the latter
    struct Shown
    {
        Geometry geometry;
        std::vector<double> wallDistance;
    };
    std::optional<Shown> shown_; ///< with the walls alone that pictures show; none where these are all

    std::string output(const std::string& time, const std::string& file) const;
    /// A part of the domain and the colour function in it.
    struct Part
    {
        Space space;
        std::vector<double> colour;
    };
    Space spaceOf(const RegularGrid&) const;
    std::vector<Part> partsAround(const PhaseParticles&) const;
    bool beyond(const Vector<3>& x) const { return openEnds_ && openEnds_->beyond(x); }
    /// The free surface in a part, before the planes of openings.
    Mesh freeSurfaceIn(const Part&, double level, int smoothing) const;
    SurfaceReport reconstruct(const std::vector<Part>&, const PhaseParticles&, int phase, const std::string& time, bool write,
                              std::vector<std::string>& written) const;
    Scene emptyScene(const std::string& time) const;
    void showWalls(Scene&) const;
    /// > 0 within the surface and before walls: the excess of colour over its level, or where less the distance over the support.
    double insideOf(const Part&, const std::vector<double>& excess, const Vector<3>& x) const;
    void showSurface(Scene&, const std::vector<Part>&, double level, const Cloud&, const PhaseParticles&) const;
    void showParticles(Scene&, const Cloud&) const;

public:
    /// Reads constant/geometry, system/sphSchemes, constant/phaseProperties, constant/g and system/reconstructSurfaceDict; all
    /// mistakes are thrown together. `phase` replaces the phases of the dictionary unless it is empty.
    SurfaceRun(const Case&, const std::string& phase);

    const Geometry& geometry() const { return geometry_; }
    /// What surfaces are found on, in words.
    std::string gridInWords() const;
    const SurfaceSettings& settings() const { return settings_; }
    std::vector<std::string> phaseNames() const;

    /// Writes surfaces and pictures of one time into postProcessing/reconstructSurface/<time>.
    TimeResult process(const std::string& time, bool surfaces, bool pictures) const;
};

}
