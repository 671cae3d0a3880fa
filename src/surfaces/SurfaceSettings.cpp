#include "SurfaceSettings.hpp"
#include "Kernel.hpp"
#include "SurfaceWriter.hpp"
#include "words.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// A grid of more nodes than this is a mistaken spacing: 8 GiB for each field on it.
constexpr double mostNodes = 1e9;

bool contains(std::span<const std::string> words, const std::string& word)
{
    return std::ranges::find(words, word) != words.end();
}

/// A list of words, each of which must be known.
std::vector<std::string> chooseWords(const Dictionary& dict, const std::string& key, const std::string& things,
                                     std::span<const std::string> known, const std::vector<std::string>& fallback)
{
    auto words = dict.get<std::vector<std::string>>(key, fallback);
    std::erase_if(words,
                  [&](const std::string& word)
                  {
                      if (contains(known, word)) return false;
                      dict.error(key, fmt::format("\"{}\" is unknown. {}", word, suggestion(word, things, known)));
                      return true;
                  });
    return words;
}

int count(const Dictionary& dict, const std::string& key, int fallback)
{
    const int value = dict.get<int>(key, fallback);
    if (value < 0) dict.error(key, "must not be negative");
    return std::max(value, 0);
}

Camera readCamera(const Dictionary& dict, const SurfaceCase& scene)
{
    Camera camera;
    if (dict.found("position")) camera.position = dict.get<Vector<3>>("position");
    if (dict.found("focalPoint"))
        camera.focalPoint = dict.get<Vector<3>>("focalPoint");
    else
        dict.get<Vector<3>>("focalPoint", Vector<3>{});
    if (!camera.position) dict.get<Vector<3>>("position", Vector<3>{});
    camera.up = dict.get<Vector<3>>("up", scene.up);
    if (mag(camera.up) == 0)
    {
        dict.error("up", "must have a direction");
        camera.up = scene.up;
    }
    camera.zoom = dict.getPositive("zoom", units::none, 1);
    return camera;
}

PictureSettings readPicture(const Dictionary& dict, const SurfaceCase& scene, const Geometry& geometry)
{
    PictureSettings picture;
    const auto size = dict.get<std::vector<int>>("size", {1200, 900});
    if (size.size() != 2 || size[0] < 16 || size[1] < 16 || size[0] > 8000 || size[1] > 8000)
        dict.error("size", "must be width and height in pixels, each from 16 to 8000");
    else
        picture.size = {size[0], size[1]};
    picture.camera = readCamera(dict.subDictOrEmpty("camera"), scene);

    static const std::vector<std::string> things{"surface", "walls", "particles"};
    const bool surfaceOnly = geometry.dimension == 3 && scene.phases.size() > 1;
    const auto show = chooseWords(dict, "show", "things to show", things,
                                  surfaceOnly               ? std::vector<std::string>{"surface", "walls"}
                                  : scene.phases.size() > 1 ? std::vector<std::string>{"surface", "walls", "particles"}
                                                            : std::vector<std::string>{"walls", "particles"});
    picture.surface = contains(show, "surface");
    picture.walls = contains(show, "walls");
    picture.particles = contains(show, "particles");

    picture.colourBy = dict.get("colourBy", "");
    picture.whereColourBy = dict.where("colourBy");
    if (dict.found("range"))
    {
        const auto range = dict.get<std::vector<double>>("range");
        if (range.size() == 2 && range[1] > range[0]) picture.range = {range[0], range[1]};
        else dict.error("range", "must be the least and the largest value, as in (0 1)");
    }
    picture.smoothing = count(dict, "smoothing", picture.smoothing);
    const auto plane = dict.subDictOrEmpty("plane");
    picture.plane.point = plane.getVector("point", units::m, 0.5 * (geometry.low + geometry.high));
    const auto normal = plane.get<Vector<3>>("normal", {0, 0, 1});
    if (mag(normal) > 0)
        picture.plane.normal = normal / mag(normal);
    else
        plane.error("normal", "must have a direction");
    picture.title = dict.get("title", "");
    picture.showTime = dict.get<bool>("showTime", true);
    return picture;
}

}

SurfaceSettings readSurfaceSettings(const Dictionary& dict, const SurfaceCase& scene, const Geometry& geometry)
{
    SurfaceSettings settings;
    settings.cloud = dict.get("cloud", "sph");
    for (const auto& name : chooseWords(dict, "phases", "phases", scene.phases, {scene.phases.front()}))
        settings.phases.push_back(int(std::ranges::find(scene.phases, name) - scene.phases.begin()));

    settings.gridSpacing = dict.getPositive("gridSpacing", units::m, 0.5 * scene.spacing);
    if (const double nodes = nodesOfDomain(geometry, settings.gridSpacing); nodes > mostNodes)
        dict.error("gridSpacing", fmt::format("gives a grid of {:.1e} nodes; at most {:.0e} are possible", nodes, mostNodes));
    settings.support = dict.getPositive("support", units::m, 3 * scene.spacing);
    if (settings.support < settings.gridSpacing)
        dict.error("support", fmt::format("must not be less than gridSpacing, {}", settings.gridSpacing));
    settings.kernel = dict.choose("kernel", kernelNames(), "wendlandC2");
    settings.iso = dict.getPositive("iso", units::none, 0.5);
    if (settings.iso >= 1) dict.error("iso", "must lie between 0 and 1");

    static const std::vector<std::string> ways{"none", "walls", "particles"};
    if (const auto way = dict.choose("normalise", ways, ""); way == "none")
        settings.normalise = Normalisation::none;
    else if (way == "walls")
        settings.normalise = Normalisation::walls;
    else if (way == "particles")
        settings.normalise = Normalisation::particles;

    settings.closed = dict.get<bool>("closed", false);
    settings.smoothing = count(dict, "smoothing", 0);
    settings.formats = chooseWords(dict, "formats", "formats", surfaceFormats(), {"vtp"});
    for (const auto& format : settings.formats)
        if (!canHold(format, geometry.dimension))
            dict.error("formats",
                       fmt::format("{} holds triangles only, and the surface of a 2-D case is a line. Write vtp or obj", format));
    settings.picture = readPicture(dict.subDictOrEmpty("picture"), scene, geometry);
    return settings;
}

}
