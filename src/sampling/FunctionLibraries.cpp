#include "sampling/FunctionLibraries.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryNode.hpp"
#include "dictionary/expandPath.hpp"
#include "sampling/Formulas.hpp"
#include "sampling/Measurement.hpp"
#include "sampling/functionLibrary.hpp"
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <fmt/format.h>
#include <functional>
#include <sstream>
#include <string_view>

namespace sph
{

namespace entry
{
const ListOf<std::string> libs{"libs", std::vector<std::string>{}, "libraries of function objects that are loaded (doc/ownMeasure.md)"};
}

namespace
{

struct Loaded
{
    std::filesystem::path file;
    std::vector<std::string> brings; ///< words of its function objects, formulas and measures
};
std::vector<Loaded>& loaded()
{
    static std::vector<Loaded> all;
    return all;
}

/// The file name of a library that is given by its word alone.
std::string fileName(const std::string& name)
{
    return name.find('/') == std::string::npos && name.find(".so") == std::string::npos ? "lib" + name + ".so" : name;
}

std::vector<std::filesystem::path> libraryFolders(const std::filesystem::path& caseFolder)
{
    std::vector<std::filesystem::path> folders{std::filesystem::absolute(caseFolder).lexically_normal()};
    if (const char* const listed = std::getenv("LD_LIBRARY_PATH"))
    {
        std::istringstream stream(listed);
        for (std::string folder; std::getline(stream, folder, ':');)
            if (!folder.empty()) folders.emplace_back(folder);
    }
    std::error_code none;
    const auto programs = std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
    folders.push_back(programs);
    folders.push_back((programs / SPH_LIBRARY_FOLDER).lexically_normal());
    return folders;
}

/// The file of a library, or the reason in words why there is none.
std::filesystem::path findLibrary(const std::string& name, const std::filesystem::path& caseFolder, std::string& reason)
{
    if (name.find_first_of("/<$~") != std::string::npos)
    {
        try
        {
            std::filesystem::path path = expandPath(name, caseFolder, [](const std::string&) { return std::nullopt; });
            if (path.is_relative()) path = caseFolder / path;
            path = std::filesystem::absolute(path).lexically_normal();
            if (std::filesystem::exists(path)) return path;
            reason = fmt::format("there is no {}", path.string());
        }
        catch (const PathError& e)
        {
            reason = e.what();
        }
        return {};
    }
    std::vector<std::string> places;
    for (const auto& folder : libraryFolders(caseFolder))
    {
        if (std::filesystem::exists(folder / name)) return folder / name;
        places.push_back(folder.string());
    }
    reason = fmt::format("it is in none of {}. A path, or a folder in LD_LIBRARY_PATH, leads to others", list(places));
    return {};
}

/// The tag of the first object of a library that was made for something else than this program, or nothing where all were made for this one; the reason is set
/// where it is no library of function objects.
std::optional<std::string> otherTag(std::string_view bytes, std::string& reason)
{
    // An end of the string that follows the mark, which the compiler has put somewhere else as well, is no tag.
    bool found = false;
    for (auto at = bytes.find(tagMark); at != std::string_view::npos; at = bytes.find(tagMark, at + 1))
    {
        const auto tag = bytes.substr(at, bytes.find('\0', at) - at);
        if (tag == tagMark) continue;
        found = true;
        if (tag != interfaceTag) return std::string(tag.substr(std::string_view(tagMark).size()));
    }
    if (!found) reason = "it is no library of function objects: none of its sources includes sampling/functionLibrary.hpp";
    return {};
}

/// True where the file ends before its table of sections, which linkers write last: the loader would read beyond it, and end the program by a signal.
bool isCutShort(std::string_view bytes)
{
    Elf64_Ehdr header;
    if (bytes.size() < sizeof header) return true;
    std::memcpy(&header, bytes.data(), sizeof header);
    return bytes.size() < header.e_shoff + std::size_t(header.e_shnum) * header.e_shentsize;
}

/// What the library added to the function objects, formulas and measures, of which there were so many before; `reason` is set where a word was taken.
struct Counts
{
    std::size_t types = functionTypes().size(), formulas = allFormulas().size(), measures = measureNames().size();
};
std::vector<std::string> addedSince(const Counts& before, std::string& reason)
{
    std::vector<std::string> added;
    const auto add = [&](const char* thing, const auto& all, std::size_t count, const auto& wordOf, const auto& isSame)
    {
        for (auto k = count; k < all.size(); ++k)
        {
            for (std::size_t other = 0; other < k && reason.empty(); ++other)
                if (isSame(all[k], all[other])) reason = fmt::format("its {} \"{}\" has the name of another one", thing, wordOf(all[k]));
            if (added.empty() || added.back() != wordOf(all[k])) added.push_back(wordOf(all[k]));
        }
    };
    const auto ofType = [](const FunctionType& t) { return t.name.word; };
    add("function object", functionTypes(), before.types, ofType, [&](const auto& a, const auto& b) { return ofType(a) == ofType(b); });
    add("formula", allFormulas(), before.formulas, std::mem_fn(&Formula::name),
        [](const Formula& a, const Formula& b) { return a.name == b.name && a.field == b.field; });
    add("measure", measureNames(), before.measures, std::identity(), std::equal_to<>());
    return added;
}

/// Loads a library; returns the reason why it is of no use, or an empty text.
std::string load(const std::filesystem::path& file)
{
    std::string reason;
    const auto bytes = readText(file, reason);
    if (!bytes) return reason;
    if (const auto other = otherTag(*bytes, reason))
        return fmt::format("it was made for version {}, this program is of version {}. Compile it again with what is installed here",
                           *other, std::string_view(interfaceTag).substr(std::string_view(tagMark).size()));
    if (!reason.empty()) return reason;
    if (isCutShort(*bytes)) return "it is cut short";
    const Counts before;
    if (!dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return fmt::format("it does not load: {}", dlerror());
    Loaded library{file, addedSince(before, reason)};
    if (!reason.empty()) return reason;
    if (library.brings.empty()) return "it brings no function objects: none of its sources has a constant `sph::AddedFunction`";
    loaded().push_back(std::move(library));
    return "";
}

}

void loadLibraries(const Dictionary& d)
{
    const auto& known = d.node().caseFolder;
    const auto caseFolder = known ? *known : std::filesystem::path(".");
    for (const auto& name : entry::libs(d))
    {
        std::string reason;
        const auto file = findLibrary(fileName(name), caseFolder, reason);
        if (std::ranges::find(loaded(), file, &Loaded::file) != loaded().end()) continue;
        if (!file.empty()) reason = load(file);
        if (!reason.empty()) entry::libs.error(d, fmt::format("library \"{}\": {}", name, reason));
    }
}

std::vector<std::string> loadedLibraries()
{
    std::vector<std::string> lines;
    for (const auto& [file, brings] : loaded()) lines.push_back(fmt::format("{}: {}", file.filename().string(), list(brings)));
    return lines;
}

}
