#include "sweeps/CaseCopy.hpp"
#include "base/OutputFile.hpp"
#include "base/readText.hpp"
#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <regex>
#include <set>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

/// Fowler-Noll-Vo's FNV-1a of 64 bits: to notice a change, not to withstand an attack.
class Stamp
{
    std::uint64_t value_ = 0xcbf29ce484222325u;

public:
    void add(std::string_view bytes)
    {
        for (const unsigned char c : bytes) value_ = (value_ ^ c) * 0x100000001b3u;
    }
    /// Adds a word with its end, so that "ab" "c" differs from "a" "bc".
    void addWord(std::string_view word)
    {
        add(word);
        add(std::string_view("\0", 1));
    }
    void addFile(const fs::path& path)
    {
        std::ifstream in(path, std::ios::binary);
        char block[1 << 16];
        while (in.read(block, sizeof block), in.gcount() > 0) add({block, std::size_t(in.gcount())});
        addWord("");
    }
    std::string text() const { return fmt::format("{:016x}", value_); }
};

/// An include by a path out of the case leads to the same file from the copy.
void keepIncludes(const fs::path& from, const fs::path& to)
{
    static const std::regex include(R"((#s?include(?:IfPresent)?\s+")([^"/$~<][^"]*)("))");
    std::error_code unreadable;
    for (const char* part : {"constant", "system"})
        for (const auto& entry : fs::directory_iterator(to / part, unreadable))
        {
            std::string ignored, kept;
            const auto text = readText(entry.path(), ignored).value_or("");
            if (text.find("#") == std::string::npos) continue;
            auto at = text.cbegin();
            for (std::sregex_iterator found(text.begin(), text.end(), include), end; found != end; ++found)
            {
                const auto& m = *found;
                const auto meant = fs::weakly_canonical(from / part / m.str(2));
                const bool inCase = !meant.lexically_relative(fs::weakly_canonical(from)).string().starts_with("..");
                kept.append(at, m[2].first);
                kept += inCase ? m.str(2) : meant.lexically_relative(fs::weakly_canonical(to / part)).string();
                at = m[2].second;
            }
            kept.append(at, text.cend());
            if (kept != text) writeFile(entry.path(), kept);
        }
}

/// A folder of a case, without what meshToGhost and the solver write.
void copyFiles(const fs::path& from, const fs::path& to, const fs::path& part)
{
    static const std::set<fs::path> written{
        "constant/polyMesh",   "constant/walls",  "constant/triSurface/walls.stl", "constant/triSurface/walls.vtp",
        "constant/lagrangian", "constant/uniform"};
    createFolders(to / part);
    for (const auto& each : fs::directory_iterator(from / part))
    {
        const auto name = part / each.path().filename();
        if (written.contains(name)) continue;
        if (each.is_directory()) copyFiles(from, to, name);
        else fs::copy_file(each.path(), to / name, fs::copy_options::overwrite_existing);
    }
}

/// Copies the folders that a run begins with.
void copyParts(const fs::path& from, const fs::path& to, const fs::path& start)
{
    try
    {
        createFolders(to);
        for (const fs::path& part : {fs::path("constant"), fs::path("system"), fs::path("reference"), start})
            if (fs::exists(from / part)) copyFiles(from, to, part);
    }
    catch (const fs::filesystem_error& e)
    {
        throw CaseError({to.string(), 0}, "cannot be made: " + e.code().message());
    }
}

}

void copyInputs(const fs::path& from, const fs::path& to, bool withStart)
{
    std::error_code reason;
    fs::remove_all(to, reason);
    copyParts(from, to, withStart && !fs::exists(from / "0.orig") ? "0" : "0.orig");
    keepIncludes(from, to);
}

void renewInputs(const fs::path& from, const std::vector<fs::path>& laidOver, const fs::path& to)
{
    copyParts(from, to, "0.orig");
    keepIncludes(from, to);
    for (const auto& folder : laidOver) copyParts(folder, to, "0.orig");
}

std::string inputsStamp(const fs::path& folder, const std::vector<std::string>& without, const std::vector<std::string>& more)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    Stamp stamp;
    for (const auto& file : files)
    {
        const auto name = file.lexically_relative(folder).string();
        if (std::ranges::find(without, name) != without.end()) continue;
        stamp.addWord(name);
        stamp.addFile(file);
    }
    for (const auto& word : more) stamp.addWord(word);
    return stamp.text();
}

std::string fileStamp(const fs::path& file)
{
    Stamp stamp;
    stamp.addFile(file);
    return stamp.text();
}

}
