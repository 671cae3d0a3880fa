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

class Variants
{
    fs::path folder_;
    Dictionary entries_;

    fs::path folderOf(const std::string& name) const { return folder_ / "variants" / name; }
    bool knows(const std::string& name) const { return entries_.isDictionary(name) || fs::is_directory(folderOf(name)); }

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
    std::vector<std::string> parts(const std::string& name) const
    {
        std::vector<std::string> parts;
        if (name.ends_with('-'))
            throw CaseError(Location{variantsDictionary, 0}, fmt::format("\"{}\" names no variant behind its last -", name));
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
                    if (entries_.found(sought))
                        entries_.error(sought, "is no variant: a variant is a dictionary of files, { \"system/controlDict\" { .. } }");
                    entries_.diagnostics().throwIfAny();
                    throw CaseError(Location{variantsDictionary, 0},
                                    fmt::format("there is no variant \"{}\". {}", sought, suggestion(sought, "variants", names())));
                }
            }
            parts.push_back(name.substr(begin, end - begin));
            begin = end + 1;
        }
        return parts;
    }

    /// The folder of that name, or else those of the words between its '-'.
    std::vector<fs::path> folders(const std::string& name) const
    {
        if (fs::is_directory(folderOf(name))) return {folderOf(name)};
        std::vector<fs::path> found;
        std::istringstream words(name);
        for (std::string word; std::getline(words, word, '-');)
            if (fs::is_directory(folderOf(word))) found.push_back(folderOf(word));
        return found;
    }

    /// Reads the entries that a variant changes in the files of a copy.
    std::vector<Override> overrides(const std::string& name, const fs::path& copy) const
    {
        return entries_.isDictionary(name) ? readOverrides(entries_.subDict(name), copy) : std::vector<Override>();
    }
};

}

EntryList variantEntries() { return {{entry::variantOfCase, {entry::changedFile}}}; }

fs::path cloneCase(const fs::path& caseFolder, const std::string& name)
{
    if (!isPlainName(name)) throw CaseError(fmt::format("variant \"{}\" needs a name of letters, digits and _-+.", name));
    const Case c(caseFolder);
    const Variants variants(c);
    const auto parts = variants.parts(name);
    c.diagnostics().throwIfAny();
    const auto path = fs::path("run") / name, copy = caseFolder / path;
    const bool isNew = !fs::exists(copy);
    std::vector<fs::path> folders;
    for (const auto& part : parts)
        for (const auto& folder : variants.folders(part)) folders.push_back(folder);
    renewInputs(caseFolder, folders, copy);
    for (const auto& part : parts) apply(variants.overrides(part, copy), copy, c.diagnostics());
    if (isNew && c.diagnostics().errors() > 0) fs::remove_all(copy); // no case that looks like the variant
    c.diagnostics().throwIfAny();
    return path;
}

}
