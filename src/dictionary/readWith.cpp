#include "dictionary/readWith.hpp"
#include "base/readText.hpp"
#include "dictionary/DictionaryParser.hpp"
#include <fmt/format.h>

namespace sph
{

Dictionary readAs(const std::string& text, const std::filesystem::path& caseFolder, const std::string& file,
                  std::shared_ptr<Diagnostics> diagnostics)
{
    auto d = Dictionary::empty(file, diagnostics);
    const auto path = caseFolder / file;
    d.node().caseFolder = std::make_shared<const std::filesystem::path>(caseFolder);
    DictionaryParser::Context context{.caseFolder = caseFolder, .diagnostics = diagnostics};
    std::error_code none;
    context.open.push_back(std::filesystem::weakly_canonical(path, none));
    DictionaryParser(context, text, file, path.parent_path()).parse(d.node());
    return d;
}

Dictionary readWith(const std::string& entries, const std::filesystem::path& caseFolder, const std::string& file,
                    std::shared_ptr<Diagnostics> diagnostics)
{
    std::string reason;
    const auto text = readText(caseFolder / file, reason);
    if (!text) return Dictionary::read(caseFolder, file, diagnostics); // which says what is wrong with it

    const auto given = Dictionary::parse(entries, file, diagnostics).keys();
    auto d = readAs(entries + " " + *text, caseFolder, file, diagnostics);
    for (const auto& key : given)
    {
        if (const auto& entry = *d.node().findExact(key); entry.included || entry.begin > entries.size())
            d.error(key, fmt::format("\"{}\" is given from outside; an entry of your own needs another name", key));
        d.ignore(key);
    }
    return d;
}

}
