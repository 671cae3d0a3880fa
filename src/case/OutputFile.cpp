#include "OutputFile.hpp"
#include <cerrno>
#include <charconv>
#include <cstring>
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
    return (precision > 0 ? std::to_chars(at, end, value, std::chars_format::general, precision) : std::to_chars(at, end, value))
        .ptr;
}
}

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path)
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
    throw CaseError({path_.string(), 0}, "cannot be written: " + std::generic_category().message(reason));
}

void OutputFile::send(const char* data, std::size_t size)
{
    while (size > 0)
    {
        const auto sent = ::write(descriptor_, data, size);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) fail(errno);
        data += sent;
        size -= std::size_t(sent);
    }
}

void OutputFile::write(std::string_view text)
{
    if (text.size() > capacity_ - used_) flush();
    if (text.size() > capacity_) return send(text.data(), text.size());
    std::memcpy(buffer_.get() + used_, text.data(), text.size());
    used_ += text.size();
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
    // Some file systems (NFS, quotas) report a full disk only here.
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail(errno);
}

void writeFile(const std::filesystem::path& path, std::string_view text)
{
    OutputFile file(path);
    file.write(text);
    file.close();
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
