#include "surfaces/SurfaceSettings.hpp"
#include "geometry/wallNames.hpp"
#include "kernels/Kernel.hpp"
#include "surfaces/SurfaceWriter.hpp"
#include "surfaces/entries/surfaceEntries.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// A grid of more nodes than this that is finer than particles by so much is a mistaken spacing.
constexpr double mostNodes = 1e9, finest = 0.05;

bool contains(std::span<const std::string> words, const std::string& word) { return std::ranges::find(words, word) != words.end(); }

Camera readCamera(const Dictionary& dict, const SurfaceCase& scene)
{
    Camera camera;
    camera.position = entry::position.ifGiven(dict);
    camera.focalPoint = entry::focalPoint.ifGiven(dict);
    camera.up = entry::up(dict, scene.up);
    if (mag(camera.up) == 0)
    {
        entry::up.error(dict, "must have a direction");
        camera.up = scene.up;
    }
    camera.zoom = entry::zoom(dict);
    return camera;
}

/// The default plane is upright, so that what is up in the scene is up in the picture: nobody looks along gravity.
CutPlane readPlane(const Dictionary& dict, const Vector<3>& up, const Geometry& geometry)
{
    const bool zIsUp = std::abs(up.z) > 0.8 * mag(up);
    return {entry::point(dict, 0.5 * (geometry.low + geometry.high)),
            entry::normal(dict, zIsUp ? Vector<3>{0, -1, 0} : Vector<3>{0, 0, 1})};
}

PictureSettings readPicture(const Dictionary& dict, const SurfaceCase& scene, const Geometry& geometry)
{
    PictureSettings picture;
    const auto size = entry::size(dict);
    if (size.size() != 2 || size[0] < 16 || size[1] < 16 || size[0] > 8000 || size[1] > 8000)
        entry::size.error(dict, "must be width and height in pixels, each from 16 to 8000");
    else picture.size = {size[0], size[1]};
    picture.camera = readCamera(entry::camera(dict), scene);

    const bool surfaceOnly = geometry.dimension == 3 && scene.phases.size() > 1;
    const auto show = entry::show(dict, surfaceOnly               ? std::vector<std::string>{"surface", "walls"}
                                        : scene.phases.size() > 1 ? std::vector<std::string>{"surface", "walls", "particles"}
                                                                  : std::vector<std::string>{"walls", "particles"});
    picture.surface = contains(show, "surface");
    picture.walls = contains(show, "walls");
    picture.particles = contains(show, "particles");
    picture.shownWalls = entry::shownWalls.among(dict, wallNames(geometry), {});

    picture.colourBy = entry::colourBy(dict, "");
    picture.whereColourBy = entry::colourBy.where(dict);
    if (const auto given = entry::range.ifGiven(dict))
    {
        const auto& range = *given;
        if (range.size() == 2 && range[1] > range[0]) picture.range = {range[0], range[1]};
        else entry::range.error(dict, "must be the least and the largest value, as in (0 1)");
    }
    picture.smoothing = entry::pictureSmoothing(dict);
    picture.plane = readPlane(entry::plane(dict), picture.camera.up, geometry);
    picture.allParticles = entry::shownParticles(dict) == "all";
    const auto cut = entry::cut(dict);
    if (entry::cut.given(dict)) picture.cut = readPlane(cut, picture.camera.up, geometry);
    picture.wallOpacity = entry::wallOpacity(dict);
    picture.scaleBar = entry::scaleBar(dict);
    picture.framesPerSecond = entry::framesPerSecond(dict);
    if (picture.surface && picture.surfaceField() == "phase")
        entry::colourBy.error(dict, "the surface is that of one phase: name a field, or show the particles");
    if (picture.cut && geometry.dimension == 2) entry::cut.error(dict, "a plane scene is not cut");
    if (picture.cut && picture.particlesOnPlane())
        entry::cut.error(dict, "the particles lie on a cut, `plane`, already: give that alone, or say `particles all;`");
    picture.title = entry::title(dict);
    picture.showTime = entry::showTime(dict);
    return picture;
}

}

SurfaceSettings readSurfaceSettings(const Dictionary& dict, const SurfaceCase& scene, const Geometry& geometry)
{
    SurfaceSettings settings;
    settings.cloud = entry::cloud(dict);
    for (const auto& name : entry::phases.among(dict, scene.phases, {scene.phases.front()}))
        settings.phases.push_back(int(std::ranges::find(scene.phases, name) - scene.phases.begin()));

    settings.gridSpacing = entry::gridSpacing(dict, 0.5 * scene.spacing);
    settings.whereGridSpacing = entry::gridSpacing.where(dict);
    const double nodes = nodesOfDomain(geometry, settings.gridSpacing);
    if (nodes > mostNodes && settings.gridSpacing < finest * scene.spacing)
        entry::gridSpacing.error(dict, fmt::format("gives a grid of {:.1e} nodes; at most {:.0e} are possible", nodes, mostNodes));
    settings.support = entry::support(dict, 3 * scene.spacing);
    if (settings.support < settings.gridSpacing)
        (entry::support.given(dict) ? entry::support : entry::gridSpacing)
            .error(dict, fmt::format("the support, {} m, must not be less than gridSpacing, {} m", settings.support, settings.gridSpacing));
    constexpr double widest = 20; // spacings; the particles within grow by its cube
    if (settings.support > widest * scene.spacing)
        entry::support.error(dict, fmt::format("is a length, and more than {} times the spacing, {} m", widest, scene.spacing));
    settings.kernel = entry::kernel(dict);
    settings.iso = entry::iso(dict);
    if (!entry::iso.given(dict)) settings.iso = 0.5;
    if (const auto way = entry::normalise.ifGiven(dict))
        settings.normalise = *way == "none" ? Normalisation::none : *way == "walls" ? Normalisation::walls : Normalisation::particles;
    settings.closed = entry::closed(dict);
    settings.smoothing = entry::smoothing(dict);
    settings.formats = entry::formats(dict);
    for (const auto& format : settings.formats)
        if (!canHold(format, geometry.dimension))
            entry::formats.error(dict,
                                 fmt::format("{} holds triangles only, and the surface of a 2-D case is a line. Write vtp or obj", format));
    settings.picture = readPicture(entry::picture(dict), scene, geometry);
    return settings;
}

}
