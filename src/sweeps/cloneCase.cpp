#include "sweeps/cloneCase.hpp"
#include "base/words.hpp"
#include "sweeps/CaseCopy.hpp"
#include <fmt/format.h>
#include <set>
#include <sstream>

namespace sph
{

namespace entry
{
const FreeName variantOfCase{"<variant>", "dictionary", "a run beside the case itself; of a-b, b is on top of a"},
    changedFile{"<file>", "dictionary", "file of the case with the entries to change, \"system/sphSchemes\" { .. }; ~entry; removes one"};
}

namespace
{

namespace fs = std::filesystem;

/// A variant: files that are laid over those of the case, then entries.
struct Variant
{
    std::vector<fs::path> folders;
    std::vector<Override> overrides;
};

class Variants
{
    fs::path folder_;
    Dictionary entries_;

    fs::path folderOf(const std::string& name) const { return folder_ / "variants" / name; }
    bool knows(const std::string& name) const { return entries_.isDictionary(name) || fs::is_directory(folderOf(name)); }

    /// That of the name, or else those of the parts that it puts together.
    std::vector<fs::path> folders(const std::string& name) const
    {
        if (fs::is_directory(folderOf(name))) return {folderOf(name)};
        std::vector<fs::path> found;
        std::istringstream parts(name);
        for (std::string part; std::getline(parts, part, '-');)
            if (fs::is_directory(folderOf(part))) found.push_back(folderOf(part));
        return found;
    }

    std::vector<std::string> names() const
    {
        std::set<std::string> all;
        for (const auto& key : entries_.keys()) all.insert(key);
        std::error_code none;
        for (const auto& each : fs::directory_iterator(folder_ / "variants", none)) all.insert(each.path().filename().string());
        return {all.begin(), all.end()};
    }

public:
    explicit Variants(const Case& c)
        : folder_(c.folder()),
          entries_(c.has(variantsDictionary) ? c.dictionary(variantsDictionary)
                                             : Dictionary::empty(variantsDictionary, c.sharedDiagnostics()))
    {}

    /// The variant itself, or those that its name puts together.
    std::vector<Variant> parts(const std::string& name) const
    {
        std::vector<Variant> parts;
        for (std::size_t begin = 0; begin < name.size();)
        {
            // the longest part that is known, so that names may hold '-' themselves
            auto end = name.size();
            while (!knows(name.substr(begin, end - begin)))
            {
                end = name.rfind('-', end - 1);
                if (end == name.npos || end <= begin)
                {
                    const auto sought = name.substr(begin, name.find('-', begin) - begin);
                    throw CaseError(Location{variantsDictionary, 0},
                                    fmt::format("there is no variant \"{}\". {}", sought, suggestion(sought, "variants", names())));
                }
            }
            const auto part = name.substr(begin, end - begin);
            parts.push_back(
                {folders(part), entries_.isDictionary(part) ? readOverrides(entries_.subDict(part), folder_) : std::vector<Override>()});
            begin = end + 1;
        }
        return parts;
    }
};

}

EntryList variantEntries() { return {{entry::variantOfCase, {entry::changedFile}}}; }

fs::path cloneCase(const fs::path& caseFolder, const std::string& name)
{
    if (!isPlainName(name)) throw CaseError(fmt::format("variant \"{}\" needs a name of letters, digits and _-+.", name));
    const Case c(caseFolder);
    const auto parts = Variants(c).parts(name);
    c.diagnostics().throwIfAny();
    const auto copy = fs::path("run") / name;
    std::vector<fs::path> folders;
    for (const auto& part : parts) folders.insert(folders.end(), part.folders.begin(), part.folders.end());
    renewInputs(caseFolder, folders, caseFolder / copy);
    for (const auto& part : parts) apply(part.overrides, caseFolder / copy, c.diagnostics());
    c.diagnostics().throwIfAny();
    return copy;
}

}
