#include "Movie.hpp"
#include "base/OutputFile.hpp"
#include "base/words.hpp"
#include "sweeps/ChildProcess.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace fs = std::filesystem;

namespace
{

/// Links to pictures under numbers, which ffmpeg reads in their order; gone with this object.
class Frames
{
    fs::path folder_;

public:
    Frames(const fs::path& folder, const std::vector<fs::path>& pictures) : folder_(folder)
    {
        fs::remove_all(folder_);
        createFolders(folder_);
        for (std::size_t k = 0; k < pictures.size(); ++k)
            fs::create_symlink(fs::absolute(pictures[k]), folder_ / fmt::format("{:06}.png", k));
    }
    ~Frames()
    {
        std::error_code kept;
        fs::remove_all(folder_, kept);
    }
    Frames(const Frames&) = delete;
    Frames& operator=(const Frames&) = delete;
    std::string pattern() const { return (folder_ / "%06d.png").string(); }
};

/// Filter of ffmpeg: an mp4 stores colours for two by two pixels, so that it needs even numbers of them, and yuv420p is what every player knows; a gif has 256 colours,
/// the best ones of all pictures.
const char* filterOf(const std::string& format)
{
    return format == "mp4" ? "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,format=yuv420p" : "split[a][b];[a]palettegen[p];[b][p]paletteuse";
}

}

const std::vector<std::string>& Movie::formats()
{
    static const std::vector<std::string> all{"mp4", "gif"};
    return all;
}

Movie::Movie(const std::string& format) : format_(format)
{
    if (std::ranges::find(formats(), format) == formats().end())
        throw CaseError(fmt::format("-movie: \"{}\" is unknown. {}", format, suggestion(format, "formats", formats())));
    const auto program = findProgram("ffmpeg");
    if (!program)
        throw CaseError("-movie: ffmpeg is not installed (Debian: apt install ffmpeg). Without -movie the pictures alone are drawn");
    ffmpeg_ = *program;
}

void Movie::write(const std::vector<fs::path>& pictures, double framesPerSecond, const fs::path& file) const
{
    if (pictures.size() < 2) throw CaseError("-movie: one picture is no sequence; choose more times");
    const auto folder = fs::absolute(file.parent_path()); // ffmpeg runs there
    const Frames frames(folder / ("." + file.stem().string() + ".frames"), pictures);
    ProcessTask task;
    task.command = {ffmpeg_.string(),
                    "-nostdin",
                    "-y",
                    "-framerate",
                    fmt::format("{:g}", framesPerSecond),
                    "-i",
                    frames.pattern(),
                    "-vf",
                    filterOf(format_),
                    file.filename().string()};
    task.folder = folder;
    task.log = folder / "log.ffmpeg";
    if (const auto outcome = runProcess(task); !outcome.well())
        throw CaseError(fmt::format("ffmpeg could not write {}: {}; read {}", file.string(), outcome.inWords(), task.log.string()));
    fs::remove(task.log);
}

}
