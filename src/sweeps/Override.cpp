#include "sweeps/Override.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryText.hpp"
#include <algorithm>
#include <cctype>
#include <cstring>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

std::vector<std::string> filesOf(const fs::path& folder)
{
    std::vector<std::string> files;
    std::error_code none;
    for (const char* part : {"system", "constant"})
        for (const auto& entry : fs::directory_iterator(folder / part, none))
            if (entry.is_regular_file(none)) files.push_back(fmt::format("{}/{}", part, entry.path().filename().string()));
    std::ranges::sort(files);
    return files;
}

void collectEntries(const Dictionary& d, Override under, std::vector<Override>& overrides)
{
    for (const auto& key : d.keys())
    {
        auto next = under;
        next.where = d.where(key);
        const bool goes = key.starts_with('~');
        next.keywords.push_back(goes ? key.substr(1) : key);
        if (d.isDictionary(key)) collectEntries(d.subDict(key), next, overrides);
        else
        {
            next.value = valueText(d, key);
            if (goes != next.value.empty())
                d.error(key, goes ? fmt::format("\"{}\" goes: it can have no value here", next.entry())
                                  : fmt::format("\"{}\" needs a value, or ~ ahead of it where it is to go", next.entry()));
            overrides.push_back(std::move(next));
        }
        d.ignore(key);
    }
}

/// How much of the way to an entry there is in a file, and whether all of that stands in the file itself.
struct Way
{
    std::size_t depth = 0; ///< keywords that are there
    bool own = true;       ///< none of them came from a file that this one includes
};

Way wayTo(const Override& o, const fs::path& caseFolder)
{
    Way way;
    auto d = Dictionary::read(caseFolder, o.file, std::make_shared<Diagnostics>());
    for (; way.depth < o.keywords.size() && d.found(o.keywords[way.depth]); ++way.depth)
    {
        const auto& key = o.keywords[way.depth];
        way.own &= d.where(key).file == o.file;
        d = d.subDictOrEmpty(key);
    }
    return way;
}

void apply(const Override& o, const fs::path& caseFolder)
{
    if (o.value.empty()) return removeEntry(caseFolder, o.file, o.entry());
    const auto way = wayTo(o, caseFolder);
    // The block { a { b value; } } behind an include merges with what that brings.
    if (!way.own)
    {
        auto value = o.value;
        for (auto key = o.keywords.rbegin(); key + 1 != o.keywords.rend(); ++key) value = fmt::format("{{ {} {}; }}", *key, value);
        return appendEntry(caseFolder, o.file, o.keywords.front(), value);
    }
    std::string outer;
    for (std::size_t depth = 1; depth < o.keywords.size(); ++depth)
    {
        outer += (depth > 1 ? "." : "") + o.keywords[depth - 1];
        if (depth > way.depth) setEntry(caseFolder, o.file, outer, "{ }");
    }
    setEntry(caseFolder, o.file, o.entry(), o.value);
}

}

std::string Override::entry() const { return fmt::format("{}", fmt::join(keywords, ".")); }

std::vector<Override> readOverrides(const Dictionary& d, const fs::path& baseCase)
{
    std::vector<Override> overrides;
    const auto known = filesOf(baseCase);
    for (const auto& file : d.keys())
    {
        if (!d.isDictionary(file))
            d.error(file, fmt::format("\"{}\" must be a file of the case with the entries to change in it: \"system/sphSchemes\" {{ .. }}",
                                      file));
        else if (std::ranges::find(known, file) == known.end())
            d.error(file, fmt::format("the case has no file \"{}\". {}", file, suggestion(file, "files", known)));
        else collectEntries(d.subDict(file), {file, {}, {}, {}}, overrides);
        d.ignore(file);
    }
    return overrides;
}

void apply(const std::vector<Override>& overrides, const fs::path& caseFolder, Diagnostics& diagnostics)
{
    for (const auto& o : overrides) try
        {
            apply(o, caseFolder);
        }
        catch (const CaseError& e)
        {
            diagnostics.error(o.where, fmt::format("\"{}\" of {} cannot be {}: {}", o.entry(), o.file, o.value.empty() ? "removed" : "set",
                                                   e.what()));
        }
}

Location placeOf(const Override& o, const fs::path& caseFolder)
{
    auto d = Dictionary::read(caseFolder, o.file, std::make_shared<Diagnostics>());
    for (std::size_t k = 0; k + 1 < o.keywords.size(); ++k) d = d.subDictOrEmpty(o.keywords[k]);
    return d.found(o.keywords.back()) ? d.where(o.keywords.back()) : Location{o.file, 0};
}

bool isPlainName(const std::string& name)
{
    return !name.empty() && name[0] != '.' &&
           std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || std::strchr("_-+.", c); });
}

}
