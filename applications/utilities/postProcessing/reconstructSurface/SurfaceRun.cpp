#include "SurfaceRun.hpp"
#include "base/words.hpp"
#include "case/phaseEntries.hpp"
#include "surfaces/Cuts.hpp"
#include "surfaces/EnclosedVolume.hpp"
#include "surfaces/PhaseCloud.hpp"
#include "surfaces/SmoothedField.hpp"
#include "surfaces/SurfaceWriter.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <vtkDoubleArray.h>
#include <vtkNew.h>

namespace sph
{

namespace
{

/// `phases (water air);`, or one phase where the case names none.
std::vector<std::string> phaseNames(const Case& folder)
{
    const auto phases = entry::phases(folder.dictionaryIfPresent("constant/phaseProperties"), {});
    return phases.empty() ? std::vector<std::string>{"fluid"} : phases;
}

/// Nodes of a grid of the whole domain, beyond which grids are made around what is there, and pictures show the walls on one of so many nodes.
constexpr double mostOfDomain = 1 << 24, ofWalls = 1 << 21;
/// Nodes in all: 8 GiB for each field on them.
constexpr double mostNodes = 1e9;

/// The meshes `of` all parts in one.
template<class Parts, class Of> Mesh inOne(const Parts& parts, const Of& of)
{
    Mesh all;
    for (const auto& part : parts)
    {
        const auto mesh = of(part);
        all = all ? joined(all, mesh) : mesh;
    }
    return all ? all : Mesh::New();
}

/// A field's name on a colour bar: what has a direction is shown by its magnitude.
std::string titleOf(const Cloud& cloud, const std::string& field)
{
    const auto found = cloud.fields.find(field);
    return found != cloud.fields.end() && found->second.type == FieldClass::vector ? "|" + field + "|" : field;
}

SurfaceCase describe(const Case& folder, double spacing, int dimension)
{
    SurfaceCase scene;
    scene.spacing = spacing;
    scene.phases = phaseNames(folder);
    const auto gravity = entry::gravity(folder.dictionaryIfPresent("constant/g"), {});
    if (dimension == 3 && mag(gravity) > 0) scene.up = -gravity / mag(gravity);
    return scene;
}

}

SurfaceRun::SurfaceRun(const Case& folder, const std::string& phase) : case_(folder)
{
    const auto geometryDict = folder.dictionary("constant/geometry");
    const auto dict = folder.dictionaryIfPresent("system/reconstructSurfaceDict");
    const auto resolution = readResolution(folder.dictionary("system/sphSchemes"));
    geometry_ = readGeometry(geometryDict, resolution, 3 / resolution.support, folder.folder());
    scene_ = describe(folder, resolution.spacing, geometry_.dimension);
    folder.diagnostics().throwIfAny();
    settings_ = readSurfaceSettings(dict, scene_, geometry_);
    dict.reportUnused();
    folder.diagnostics().throwIfAny();
    if (!phase.empty())
    {
        const auto found = std::ranges::find(scene_.phases, phase);
        if (found == scene_.phases.end())
            throw CaseError(fmt::format("-phase: \"{}\" is unknown. {}", phase, suggestion(phase, "phases", scene_.phases)));
        settings_.phases = {int(found - scene_.phases.begin())};
    }
    const double nodes = nodesOfDomain(geometry_, settings_.gridSpacing);
    sparse_ = nodes > mostOfDomain;
    const double coarser = sparse_ ? std::pow(nodes / ofWalls, 1.0 / geometry_.dimension) : 1;
    openEnds_.emplace(folder, geometry_, resolution);
    folder.diagnostics().throwIfAny();
    if (openEnds_->none()) openEnds_.reset();
    space_ = spaceOf(gridOfDomain(geometry_, coarser * settings_.gridSpacing));
    if (const auto& names = settings_.picture.shownWalls; !names.empty())
    {
        auto shown = geometry_;
        std::erase_if(shown.originals,
                      [&](const Patch& p) { return std::ranges::find(names, geometry_.walls[std::size_t(p.wall)].name) == names.end(); });
        repeatPeriodically(shown, shown.reach);
        auto distance = wallDistances(space_.grid, shown);
        shown_ = Shown{std::move(shown), std::move(distance)};
    }
}

std::string SurfaceRun::gridInWords() const
{
    if (sparse_) return fmt::format("Grids around the particles, nodes {:.4g} m apart", settings_.gridSpacing);
    const auto& n = space_.grid.nodes;
    return fmt::format("Grid of {} x {} x {} nodes, {:.4g} m apart", n[0], n[1], n[2], space_.grid.largestStep());
}

std::vector<std::string> SurfaceRun::phaseNames() const
{
    std::vector<std::string> names;
    for (const int phase : settings_.phases) names.push_back(scene_.phases[phase]);
    return names;
}

std::string SurfaceRun::output(const std::string& time, const std::string& file) const
{
    return fmt::format("postProcessing/reconstructSurface/{}/{}", time, file);
}

SurfaceRun::Space SurfaceRun::spaceOf(const RegularGrid& grid) const
{
    Space space{grid, wallDistances(grid, geometry_), {}};
    if (!openEnds_) return space;
    const double far = mag(geometry_.high - geometry_.low);
    space.toOpenEnds = space.wallDistance;
    space.toOpenEnds.resize(grid.size(), far);
    for (int k = 0; k < grid.nodes[2]; ++k)
        for (int j = 0; j < grid.nodes[1]; ++j)
            for (int i = 0; i < grid.nodes[0]; ++i)
            {
                double& distance = space.toOpenEnds[grid.index(i, j, k)];
                distance = std::min({distance, openEnds_->distance(grid.node(i, j, k)), far});
            }
    return space;
}

Mesh SurfaceRun::freeSurfaceIn(const Part& part, double level, int smoothing) const
{
    const auto& grid = part.space.grid;
    const Mesh mesh = freeSurface(grid, part.colour, level, geometry_, smoothing);
    if (!openEnds_ || mesh->GetNumberOfPoints() == 0) return mesh;
    vtkNew<vtkDoubleArray> distance;
    distance->SetNumberOfValues(mesh->GetNumberOfPoints());
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
        double x[3];
        mesh->GetPoint(p, x);
        distance->SetValue(p, std::min(openEnds_->distance({x[0], x[1], x[2]}), grid.largestStep()));
    }
    return clipped(mesh, distance);
}

std::vector<SurfaceRun::Part> SurfaceRun::partsAround(const PhaseParticles& particles) const
{
    std::vector<Part> parts;
    if (!sparse_) parts.push_back({space_, {}});
    else
    {
        std::vector<Vector<3>> ofPhase;
        for (std::size_t p = 0; p < particles.size(); ++p)
            if (particles.inPhase[p]) ofPhase.push_back(particles.position[p]);
        const auto grids = gridsAround(geometry_, settings_.gridSpacing, ofPhase, settings_.support + 2 * settings_.gridSpacing);
        double nodes = 0;
        for (const auto& grid : grids) nodes += double(grid.size());
        if (nodes > mostNodes)
            throw CaseError(settings_.whereGridSpacing,
                            fmt::format("the surface asks for grids of {:.1e} nodes; at most {:.0e} are possible", nodes, mostNodes));
        for (const auto& grid : grids) parts.push_back({spaceOf(grid), {}});
    }
    const auto normalise = settings_.normalise.value_or(particles.hasOtherPhase() ? Normalisation::particles : Normalisation::walls);
    for (auto& part : parts)
        part.colour = colourFunction(part.space.grid, part.space.wallDistance, particles, settings_.kernel, settings_.support, normalise);
    return parts;
}

SurfaceReport SurfaceRun::reconstruct(const std::vector<Part>& parts, const PhaseParticles& particles, int phase, const std::string& time,
                                      bool write, std::vector<std::string>& written) const
{
    SurfaceReport report;
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
        if (!particles.inPhase[p]) continue;
        if (beyond(particles.position[p])) ++report.held;
        else
        {
            ++report.particles;
            report.particleVolume += particles.volume[p];
        }
    }
    const auto enclosedAt = [&](double level)
    {
        Enclosed all;
        for (const auto& [space, colour] : parts)
        {
            const auto enclosed = enclosedVolume(space.grid, colour, level, space.sceneDistance());
            all.volume += enclosed.volume;
            all.pieces += enclosed.pieces;
        }
        return all;
    };
    report.level =
        settings_.iso ? *settings_.iso : levelEnclosing(report.particleVolume, [&](double level) { return enclosedAt(level).volume; });
    const auto free = inOne(parts, [&](const Part& part) { return freeSurfaceIn(part, report.level, settings_.smoothing); });
    const auto enclosed = enclosedAt(report.level);
    report.phase = scene_.phases[phase];
    report.area = measure(free);
    report.volume = enclosed.volume;
    report.pieces = enclosed.pieces;
    if (!write) return report;

    const auto closed = [&](const Part& part)
    { return closedSurface(part.space.grid, part.colour, report.level, part.space.sceneDistance(), settings_.support); };
    const auto mesh = settings_.closed ? inOne(parts, closed) : free;
    for (const auto& format : settings_.formats)
    {
        written.push_back(output(time, fmt::format("{}.{}", report.phase, format)));
        writeSurface(mesh, case_.folder() / written.back());
    }
    return report;
}

Scene SurfaceRun::emptyScene(const std::string& time) const
{
    const auto& picture = settings_.picture;
    Scene scene;
    scene.dimension = geometry_.dimension;
    scene.low = geometry_.low;
    scene.high = geometry_.high;
    scene.camera = picture.camera;
    if (picture.particlesOnPlane()) scene.camera.facing = picture.plane.normal;
    else if (picture.cut) scene.camera.facing = picture.cut->normal;
    scene.size = picture.size;
    const auto shownTime = picture.showTime ? fmt::format("Time = {} s", time) : "";
    scene.scaleBar = picture.scaleBar;
    scene.wallOpacity = picture.wallOpacity;
    scene.title = picture.title + (picture.title.empty() || shownTime.empty() ? "" : "      ") + shownTime;
    return scene;
}

double SurfaceRun::insideOf(const Part& part, const std::vector<double>& excess, const Vector<3>& x) const
{
    const auto& distance = part.space.sceneDistance();
    const double inside = interpolated(part.space.grid, excess, x);
    return distance.empty() ? inside : std::min(inside, interpolated(part.space.grid, distance, x) / settings_.support);
}

void SurfaceRun::showWalls(Scene& scene) const
{
    const auto& distance = shown_ ? shown_->wallDistance : space_.wallDistance;
    const auto& geometry = shown_ ? shown_->geometry : geometry_;
    if (distance.empty()) return;
    auto solid = distance;
    for (auto& d : solid) d = -d;
    scene.wallCuts = cutFaces(space_.grid, solid, {});
    if (geometry_.dimension == 2) return;
    scene.walls = wallSurface(space_.grid, distance, geometry);
    // Walls before the plane of the particles would hide them.
    const auto& picture = settings_.picture;
    const auto plane = picture.particlesOnPlane() ? std::optional(picture.plane) : picture.cut;
    if (!plane) return;
    scene.walls = behind(*plane, scene.walls);
    scene.wallCuts = joined(behind(*plane, scene.wallCuts), solidsOn(*plane, space_.grid, geometry));
}

void SurfaceRun::showSurface(Scene& scene, const std::vector<Part>& parts, double level, const Cloud& cloud,
                             const PhaseParticles& particles) const
{
    const auto& picture = settings_.picture;
    const auto surfaceIn = [&](const Part& part) { return freeSurfaceIn(part, level, picture.smoothing); };
    if (geometry_.dimension == 2)
    {
        scene.contour = inOne(parts, surfaceIn);
        return;
    }
    std::vector<double> values;
    if (const auto field = picture.surfaceField(); !field.empty())
    {
        values = colouringValues(cloud, field, picture.whereColourBy, case_.diagnostics());
        case_.diagnostics().throwIfAny();
        scene.liquidColours = SurfaceColours{titleOf(cloud, field), picture.range};
    }
    std::vector<Mesh> surfaces, cuts;
    for (const auto& part : parts)
    {
        const auto& grid = part.space.grid;
        auto excess = part.colour;
        for (auto& c : excess) c -= level;
        auto surface = surfaceIn(part), cut = cutFaces(grid, excess, part.space.sceneDistance());
        if (picture.cut)
        {
            surface = behind(*picture.cut, surface);
            cut = joined(behind(*picture.cut, cut),
                         sectionOn(*picture.cut, grid, [&](const Vector<3>& x) { return insideOf(part, excess, x); }));
        }
        if (!values.empty())
        {
            const SmoothedField field(grid, particles, values, settings_.kernel, settings_.support);
            field.colour(surface);
            field.colour(cut);
        }
        surfaces.push_back(surface);
        cuts.push_back(cut);
    }
    const auto itself = [](const Mesh& mesh) { return mesh; };
    scene.liquid = inOne(surfaces, itself);
    scene.liquidCuts = inOne(cuts, itself);
}

void SurfaceRun::showParticles(Scene& scene, const Cloud& cloud) const
{
    const auto& picture = settings_.picture;
    auto field = picture.colourBy;
    if (field.empty()) field = scene_.phases.size() > 1 || !cloud.fields.contains("U") ? "phase" : "U";
    auto& points = scene.points;
    const bool byPhase = field == "phase";
    const auto values = byPhase && !cloud.fields.contains("phase")
                            ? std::vector<double>(cloud.size())
                            : colouringValues(cloud, field, picture.whereColourBy, case_.diagnostics());
    case_.diagnostics().throwIfAny();
    if (byPhase) points.phases = scene_.phases;
    points.range = picture.range;
    points.title = titleOf(cloud, field);
    // Discs of the particles' own area, balls that touch.
    points.diameter = scene_.spacing * (geometry_.dimension == 2 ? std::sqrt(4 / std::numbers::pi) : 1);
    for (std::size_t p = 0; p < cloud.size(); ++p)
    {
        const Vector<3> x{cloud.x[p], cloud.y[p], geometry_.dimension == 2 ? 0 : cloud.z[p]};
        if (geometry_.dimension == 3 && picture.particlesOnPlane() && std::fabs(picture.plane.height(x)) > 0.5 * scene_.spacing) continue;
        if (picture.cut && picture.cut->height(x) > 0) continue;
        if (beyond(x)) continue;
        points.position.push_back(x);
        points.value.push_back(values[p]);
    }
}

TimeResult SurfaceRun::process(const std::string& time, bool surfaces, bool pictures) const
{
    auto& diagnostics = case_.diagnostics();
    const auto cloud = readCloud(case_.folder(), time, settings_.cloud, diagnostics,
                                 {{"phase", FieldClass::label}, {"m", FieldClass::scalar}, {"rho", FieldClass::scalar}});
    diagnostics.throwIfAny();
    const double uniformVolume = std::pow(scene_.spacing, geometry_.dimension);
    const auto& picture = settings_.picture;

    TimeResult result;
    for (const int phase : settings_.phases)
    {
        std::vector<Part> parts;
        PhaseParticles particles;
        if (surfaces || (pictures && picture.surface))
        {
            particles = phaseParticles(cloud, phase, scene_.phases.size(), uniformVolume);
            parts = partsAround(particles);
            result.surfaces.push_back(reconstruct(parts, particles, phase, time, surfaces, result.written));
        }
        if (!pictures) continue;
        auto scene = emptyScene(time);
        if (picture.walls) showWalls(scene);
        if (picture.surface) showSurface(scene, parts, result.surfaces.back().level, cloud, particles);
        if (picture.particles) showParticles(scene, cloud);
        result.written.push_back(output(time, scene_.phases[phase] + ".png"));
        drawPicture(scene, case_.folder() / result.written.back());
    }
    return result;
}

}
