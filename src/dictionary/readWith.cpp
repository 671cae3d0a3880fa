#include "readWith.hpp"
#include "DictionaryParser.hpp"
#include <fmt/format.h>

namespace sph
{

Dictionary readWith(const std::string& entries, const std::filesystem::path& caseFolder, const std::string& file,
                    std::shared_ptr<Diagnostics> diagnostics)
{
    const auto path = caseFolder / file;
    const auto text = readText(path);
    if (!text) return Dictionary::read(caseFolder, file, diagnostics); // which says what is wrong with it

    const auto given = Dictionary::parse(entries, file, diagnostics).keys();
    auto d = Dictionary::empty(file, diagnostics);
    DictionaryParser::Context context{.caseFolder = caseFolder, .diagnostics = diagnostics};
    context.open.push_back(std::filesystem::weakly_canonical(path));
    DictionaryParser(context, entries + " " + *text, file, path.parent_path()).parse(d.node());
    for (const auto& key : given)
    {
        if (const auto& entry = *d.node().findExact(key); entry.included || entry.begin > entries.size())
            d.error(key, fmt::format("\"{}\" is given from outside; an entry of your own needs another name", key));
        d.ignore(key);
    }
    return d;
}

}
