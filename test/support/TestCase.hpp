/// A case folder of a test's own, in which applications of the suite run; removed at its end.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace sph::test
{

/// What an application left behind. `code` as the shell sees it; 124 where it was stopped for taking too long.
struct Outcome
{
    int code = 0;
    std::string out, err;
};

using Files = std::map<std::string, std::string>;

inline std::string contentsOf(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class TestCase
{
    std::filesystem::path folder_;

public:
    /// `files` by path relative to the folder.
    explicit TestCase(const Files& files, const std::filesystem::path& parent = std::filesystem::temp_directory_path())
    {
        std::string name = (parent / "sphTestXXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder in " + parent.string());
        folder_ = name;
        for (const auto& [file, text] : files) write(file, text);
    }
    TestCase(const TestCase&) = delete;
    ~TestCase()
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    const std::filesystem::path& folder() const { return folder_; }
    bool has(const std::string& file) const { return std::filesystem::exists(folder_ / file); }
    std::string read(const std::string& file) const { return contentsOf(folder_ / file); }
    void write(const std::string& file, const std::string& text) const
    {
        std::filesystem::create_directories((folder_ / file).parent_path());
        std::ofstream(folder_ / file, std::ios::binary) << text;
    }
    /// Exactly one occurrence of `from`, or the test itself is wrong.
    void replace(const std::string& file, const std::string& from, const std::string& to) const
    {
        auto text = read(file);
        const auto at = text.find(from);
        if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
            throw std::logic_error("\"" + from + "\" is not once in " + file);
        write(file, text.replace(at, from.size(), to));
    }
    void copyFrom(const TestCase& other, const std::string& file) const
    {
        std::filesystem::copy(other.folder_ / file, folder_ / file,
                              std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    }

    /// Runs `application -case <folder> <arguments>`, for at most `seconds`.
    Outcome run(const std::string& application, const std::string& arguments = "", int threads = 1, int seconds = 20) const
    {
        // Beside the case, so that a full disk in the case does not swallow the message.
        const auto log = std::filesystem::temp_directory_path() / (folder_.filename().string() + "." + application);
        const std::string command = "OMP_NUM_THREADS=" + std::to_string(threads) + " timeout " + std::to_string(seconds) +
                                    " '" SPH_APPLICATIONS "/" + application + "' -case '" + folder_.string() + "' " + arguments +
                                    " < /dev/null > '" + log.string() + ".out' 2> '" + log.string() + ".err'";
        const int status = std::system(command.c_str());
        Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128, contentsOf(log.string() + ".out"),
                        contentsOf(log.string() + ".err")};
        std::filesystem::remove(log.string() + ".out");
        std::filesystem::remove(log.string() + ".err");
        return outcome;
    }
    /// Throws where an application fails, with its message: for the steps that a test takes for granted.
    std::string runWell(const std::string& application, const std::string& arguments = "", int threads = 1, int seconds = 60) const
    {
        const auto outcome = run(application, arguments, threads, seconds);
        if (outcome.code != 0)
            throw std::runtime_error(application + " failed with code " + std::to_string(outcome.code) + ": " + outcome.err);
        return outcome.out;
    }

    /// Every file below `under`, by its path there.
    Files files(const std::string& under) const
    {
        Files all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / under))
            if (entry.is_regular_file()) all[std::filesystem::relative(entry.path(), folder_ / under).string()] = contentsOf(entry.path());
        return all;
    }
};

/// What differs, in words; "" where both are the same to the last byte.
inline std::string difference(const Files& a, const Files& b)
{
    std::string different;
    for (const auto& [name, text] : a)
        if (const auto other = b.find(name); other == b.end()) different += name + " is missing; ";
        else if (other->second != text) different += name + " differs; ";
    for (const auto& [name, _] : b)
        if (!a.contains(name)) different += name + " is new; ";
    return different;
}

}
