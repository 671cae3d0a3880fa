/// A sequence of pictures as one file, by ffmpeg.
#pragma once
#include "base/CaseError.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace sph
{

class Movie
{
    std::string format_;
    std::filesystem::path ffmpeg_;

public:
    static const std::vector<std::string>& formats();

    /// Throws CaseError where there is no such format or no ffmpeg: before the first picture is drawn.
    explicit Movie(const std::string& format);

    /// "mp4"
    const std::string& format() const { return format_; }

    /// Joins pictures of one size. Throws CaseError where there are fewer than two, or where ffmpeg fails; its log is then beside the file.
    void write(const std::vector<std::filesystem::path>& pictures, double framesPerSecond, const std::filesystem::path& file) const;
};

}
