/// A case folder of a test's own, removed at its end.
#pragma once
#include "base/CaseError.hpp"
#include "messages.hpp"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace sph
{

class TemporaryCase
{
    std::filesystem::path folder_;

public:
    TemporaryCase()
    {
        std::string name = (std::filesystem::temp_directory_path() / "sphCaseXXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        folder_ = name;
    }
    TemporaryCase(const TemporaryCase&) = delete;
    ~TemporaryCase() { std::filesystem::remove_all(folder_); }

    const std::filesystem::path& folder() const { return folder_; }
    bool has(const std::string& file) const { return std::filesystem::exists(folder_ / file); }
    void write(const std::string& file, const std::string& text) const
    {
        std::filesystem::create_directories((folder_ / file).parent_path());
        std::ofstream(folder_ / file, std::ios::binary) << text;
    }
    std::string read(const std::string& file) const
    {
        std::ifstream in(folder_ / file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

}
