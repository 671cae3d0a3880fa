#include "base/OutputFile.hpp"
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

namespace sph
{

namespace
{
constexpr std::size_t longestNumber = 64;

char* print(char* at, double value, int precision)
{
    const auto end = at + longestNumber;
    return (precision > 0 ? std::to_chars(at, end, value, std::chars_format::general, precision) : std::to_chars(at, end, value)).ptr;
}

/// Removes its file unless it was renamed: what is left of one that could not be written.
struct Unfinished
{
    std::filesystem::path path;
    ~Unfinished()
    {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};
}

OutputFile::OutputFile(const std::filesystem::path& path) : OutputFile(path, path) {}

OutputFile::OutputFile(const std::filesystem::path& path, const std::filesystem::path& shown) : shown_(shown)
{
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(errno);
}

OutputFile::~OutputFile()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::fail(int reason) const
{
    throw CaseError({shown_.string(), 0}, "cannot be written: " + std::generic_category().message(reason));
}

void OutputFile::send(const char* data, std::size_t size)
{
    if (taker_) return taker_({data, size});
    while (size > 0)
    {
        const auto sent = ::write(descriptor_, data, size);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) fail(errno);
        data += sent;
        size -= std::size_t(sent);
    }
}

void OutputFile::writeLong(std::string_view text)
{
    flush();
    if (text.size() > capacity_) return send(text.data(), text.size());
    write(text);
}

void OutputFile::write(double value, int precision)
{
    if (longestNumber > capacity_ - used_) flush();
    used_ = std::size_t(print(buffer_.get() + used_, value, precision) - buffer_.get());
}

void OutputFile::write(std::int64_t value)
{
    if (longestNumber > capacity_ - used_) flush();
    const auto at = buffer_.get() + used_;
    used_ += std::size_t(std::to_chars(at, at + longestNumber, value).ptr - at);
}

void OutputFile::flush()
{
    const auto size = used_;
    used_ = 0;
    send(buffer_.get(), size);
}

void OutputFile::close()
{
    flush();
    if (taker_) return;
    // Some file systems (NFS, quotas) report a full disk only here.
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail(errno);
}

void writeFile(const std::filesystem::path& path, std::string_view text)
{
    namespace fs = std::filesystem;
    std::error_code reason;
    // A link goes on pointing to what is now the new text; a device is written to, not replaced.
    const auto target = fs::is_symlink(path, reason) ? fs::weakly_canonical(path, reason) : path;
    const auto status = fs::status(target, reason);
    const bool isThere = fs::exists(status), isPlain = !isThere || fs::is_regular_file(status);
    const Unfinished written{isPlain ? fs::path(fmt::format("{}.{}{}", target.string(), ::getpid(), partialSuffix)) : fs::path()};
    OutputFile file(isPlain ? written.path : target, path);
    file.write(text);
    file.close();
    if (!isPlain) return;
    reason.clear();
    if (isThere) fs::permissions(written.path, status.permissions(), reason);
    if (!reason) fs::rename(written.path, target, reason);
    if (reason) throw CaseError({path.string(), 0}, "cannot be written: " + reason.message());
}

void createFolders(const std::filesystem::path& folder)
{
    std::error_code reason;
    std::filesystem::create_directories(folder, reason);
    if (reason) throw CaseError({folder.string(), 0}, "folder cannot be made: " + reason.message());
}

std::string shortestText(double value)
{
    char text[longestNumber];
    return {text, print(text, value, 0)};
}

}
