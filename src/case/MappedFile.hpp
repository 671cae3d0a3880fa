/// A file's bytes, read-only, without a copy: field files of millions of particles are parsed where the system cache holds them.
#pragma once
#include <filesystem>
#include <string_view>

namespace sph
{

class MappedFile
{
    void* data_ = nullptr;
    std::size_t size_ = 0;

public:
    /// Throws std::runtime_error with the reason, as "No such file or directory"; anything but a regular file is refused.
    explicit MappedFile(const std::filesystem::path&);
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    std::string_view text() const { return {static_cast<const char*>(data_), size_}; }
};

}
