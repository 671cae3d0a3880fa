/// The surface of a phase from its particles: meshes, their area and volume, and pictures.
#include "Movie.hpp"
#include "SurfaceRun.hpp"
#include "base/CommandLine.hpp"
#include "base/words.hpp"
#include "case/OutputTable.hpp"
#include "case/timeSelection.hpp"
#include "surfaces/VirtualDisplay.hpp"
#include "surfaces/entries/surfaceTable.hpp"
#include <fmt/format.h>
#include <map>
#include <optional>

namespace
{

struct Options
{
    std::string times, phase, movie;
    bool latestTime = false, pictures = false, noSurface = false;
};

std::vector<std::string> chosenTimes(const sph::Case& folder, const sph::SurfaceSettings& settings, const Options& options)
{
    std::vector<std::string> times;
    for (const auto& time : folder.times())
        if (sph::hasCloud(folder.folder(), time, settings.cloud)) times.push_back(time);
    if (times.empty())
        throw sph::CaseError(fmt::format("No time folder of {} has a cloud lagrangian/{}", folder.folder().string(), settings.cloud));
    if (options.latestTime) return {times.back()};
    return sph::selectTimes(times, options.times);
}

/// Columns of surfaces.dat; the phase is part of a column's name where there are several.
std::vector<sph::Column> columns(const std::vector<std::string>& phases, int dimension)
{
    std::vector<sph::Column> all;
    for (const auto& phase : phases)
        for (const auto& column : sph::surfaceTable(dimension).columns) all.push_back(column.of(phases.size() > 1 ? phase : ""));
    return all;
}

std::vector<double> row(const std::vector<sph::SurfaceReport>& surfaces)
{
    std::vector<double> values;
    for (const auto& s : surfaces)
        values.insert(values.end(), {s.area, s.volume, s.particleVolume, s.differencePercent(), double(s.pieces)});
    return values;
}

/// What area and volume are called in a case of that dimension, with their units.
struct Words
{
    const char *area, *volume;
};
Words wordsOf(int dimension) { return dimension == 2 ? Words{"length [m]", "area [m^2]"} : Words{"area [m^2]", "volume [m^3]"}; }

int run(const std::filesystem::path& path, const Options& options)
{
    const sph::Case folder(path);
    const sph::SurfaceRun surfaceRun(folder, options.phase);
    for (const auto& warning : folder.diagnostics().warnings()) fmt::print(stderr, "--> Warning: {}\n", warning);
    const auto times = chosenTimes(folder, surfaceRun.settings(), options);
    fmt::print("{}; kernel {} of radius {:.4g} m\n\n", surfaceRun.gridInWords(), surfaceRun.settings().kernel,
               surfaceRun.settings().support);

    std::optional<sph::Movie> movie;
    if (!options.movie.empty()) movie.emplace(options.movie);
    const bool pictures = options.pictures || movie;
    std::optional<sph::VirtualDisplay> display;
    if (pictures) display.emplace();
    std::map<std::string, std::vector<std::filesystem::path>> sequences; // pictures in the order of times, by their file's name
    std::optional<sph::OutputTable> table;
    const auto words = wordsOf(surfaceRun.geometry().dimension);
    if (!options.noSurface)
    {
        const auto dat = folder.folder() / "postProcessing" / "reconstructSurface" / times.front() / "surfaces.dat";
        std::filesystem::create_directories(dat.parent_path());
        const auto header = "Surfaces of " + sph::list(surfaceRun.phaseNames());
        table.emplace(dat, std::vector<std::string>{header}, columns(surfaceRun.phaseNames(), surfaceRun.geometry().dimension));
    }
    for (const auto& time : times)
    {
        fmt::print("Time = {}\n", time);
        const auto result = surfaceRun.process(time, !options.noSurface, pictures);
        for (const auto& s : result.surfaces)
            fmt::print("    {}: {} particles{}, {} {:.5g}, {} {:.5g} ({:+.2f} % of the particles' {:.5g}), {} piece{}{}\n", s.phase,
                       s.particles, s.held > 0 ? fmt::format(" ({} more held beyond openings)", s.held) : "", words.area, s.area,
                       words.volume, s.volume, s.differencePercent(), s.particleVolume, s.pieces, s.pieces == 1 ? "" : "s",
                       surfaceRun.settings().iso ? "" : fmt::format(", level {:.3f}", s.level));
        for (const std::filesystem::path file : result.written)
        {
            fmt::print("    {}\n", file.string());
            if (file.extension() == ".png") sequences[file.stem().string()].push_back(folder.folder() / file);
        }
        if (table) table->row(std::stod(time), row(result.surfaces));
        std::fflush(stdout);
    }
    for (const auto& [phase, drawn] : sequences)
        if (movie)
        {
            const auto file = fmt::format("postProcessing/reconstructSurface/{}.{}", phase, movie->format());
            movie->write(drawn, surfaceRun.settings().picture.framesPerSecond, folder.folder() / file);
            fmt::print("\n{}: {} pictures\n", file, drawn.size());
        }
    fmt::print("\nEnd\n");
    return 0;
}

}

int main(int argc, char** argv)
{
    Options options;
    return sph::runApplication(
        "reconstructSurface", argc, argv,
        "Reconstructs the surface of a phase from its particles, as told by system/reconstructSurfaceDict (optional), into\n"
        "postProcessing/reconstructSurface.",
        [&](sph::CommandLine& line)
        {
            const auto time = line.option("time", options.times, "ranges", "Times and ranges: '0.1,0.3', '0.1:0.5', ':0.5' (default: all)");
            line.flag("latestTime", options.latestTime, "The last time only").excludes(time);
            line.option("phase", options.phase, "name", "This phase only");
            line.flag("picture", options.pictures, "Draw <time>/<phase>.png");
            line.option("movie", options.movie, "mp4|gif", "Draw all times and join them to <phase>.mp4 or .gif, by ffmpeg");
            line.flag("noSurface", options.noSurface, "Write no surface: pictures only");
        },
        [&](const std::filesystem::path& folder) { return run(folder, options); });
}
