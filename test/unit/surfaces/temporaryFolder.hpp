/// A folder that goes when the test does.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace sph::test
{

class TemporaryFolder
{
    std::filesystem::path path_;

public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "surfacesXXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    void write(const std::string& file, const std::string& text) const
    {
        std::filesystem::create_directories((path_ / file).parent_path());
        std::ofstream(path_ / file) << text;
    }
};

inline std::string contents(const std::filesystem::path& file)
{
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

}
