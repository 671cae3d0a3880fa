#include "base/readText.hpp"
#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace sph
{

std::optional<std::string> readText(const std::filesystem::path& path, std::string& reason)
{
    namespace fs = std::filesystem;
    std::error_code unreadable;
    const auto status = fs::status(path, unreadable);
    const auto size = fs::is_regular_file(status) ? fs::file_size(path, unreadable) : 0;
    std::ifstream in;
    if (status.type() == fs::file_type::not_found) reason = "there is no such file";
    else if (status.type() == fs::file_type::none) reason = "this file cannot be read: " + unreadable.message();
    else if (!fs::is_regular_file(status))
        reason = fs::is_directory(status) ? "this is a folder" : "this is a device or a pipe: only regular files are read";
    else if (size > longestText) reason = fmt::format("this file has {} MB; at most {} MB of text are read", size >> 20, longestText >> 20);
    else if (in.open(path, std::ios::binary); !in) reason = "this file cannot be read: " + std::generic_category().message(errno);
    if (!reason.empty()) return {};
    std::string text(size, '\0');
    in.read(text.data(), std::streamsize(size));
    text.resize(std::size_t(in.gcount())); // another program may be shortening it
    return text;
}

}
