#include "case/MappedFile.hpp"
#include <cerrno>
#include <fcntl.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace sph
{

namespace
{
std::pair<void*, std::size_t> map(int descriptor)
{
    struct stat status;
    if (::fstat(descriptor, &status) != 0) return {MAP_FAILED, 0};
    if (!S_ISREG(status.st_mode))
    {
        errno = S_ISDIR(status.st_mode) ? EISDIR : ENODEV;
        return {MAP_FAILED, 0};
    }
    const auto size = std::size_t(status.st_size);
    // An empty file cannot be mapped, and has nothing to show.
    return {size == 0 ? nullptr : ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0), size};
}
}

MappedFile::MappedFile(const std::filesystem::path& path)
{
    // A pipe must not make the opening wait for a writer.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) throw std::system_error(errno, std::generic_category());
    const auto [data, size] = map(descriptor);
    const int reason = errno;
    ::close(descriptor); // the mapping outlives it
    if (data == MAP_FAILED)
    {
        if (reason == ENODEV) throw std::runtime_error("it is a device or a pipe: only regular files are read");
        throw std::system_error(reason, std::generic_category());
    }
    data_ = data;
    size_ = size;
}

MappedFile::~MappedFile()
{
    if (data_) ::munmap(data_, size_);
}

}
