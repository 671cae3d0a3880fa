#include "dictionary/DictionaryText.hpp"
#include "base/OutputFile.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryNode.hpp"
#include "dictionary/readWith.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

using Node = Dictionary::Node;
using Path = std::vector<DictionaryEntry*>;

std::string keywordText(const DictionaryEntry& e) { return e.pattern ? fmt::format("\"{}\"", e.keyword) : e.keyword; }

/// The entries on the way to `path`, the one it names last; empty where it is missing. Keywords may hold dots themselves.
Path walk(Node& node, const std::string& path, bool patterns)
{
    const auto find = [&](const std::string& key) { return patterns ? node.find(key) : node.findExact(key); };
    if (auto* entry = node.findExact(path)) return {entry};
    for (auto dot = path.find_first_of("./:"); dot != path.npos; dot = path.find_first_of("./:", dot + 1))
        if (auto* entry = find(path.substr(0, dot)); entry && entry->dictionary)
            if (auto rest = walk(*entry->dictionary, path.substr(dot + 1), patterns); !rest.empty())
            {
                rest.insert(rest.begin(), entry);
                return rest;
            }
    if (auto* entry = find(path)) return {entry};
    return {};
}

std::string withoutLeadingColon(const std::string& path) { return path.starts_with(':') ? path.substr(1) : path; }

DictionaryEntry& require(const Dictionary& dictionary, const std::string& path)
{
    const auto found = walk(dictionary.node(), withoutLeadingColon(path), true);
    if (!found.empty()) return *found.back();
    // The longest part of the path that is there tells where to look for the word that was meant.
    auto* parent = &dictionary.node();
    auto sought = withoutLeadingColon(path);
    for (auto dot = sought.find_last_of("./:"); dot != sought.npos && dot > 0; dot = sought.find_last_of("./:", dot - 1))
        if (const auto outer = walk(*parent, sought.substr(0, dot), true); !outer.empty() && outer.back()->dictionary)
        {
            parent = outer.back()->dictionary.get();
            sought = sought.substr(dot + 1);
            break;
        }
    std::vector<std::string> known;
    for (const auto& e : parent->entries)
        if (e.keyword != "FoamFile") known.push_back(e.keyword);
    const auto keyword = sought.substr(0, sought.find_first_of("./:"));
    throw CaseError(parent->where, fmt::format("there is no entry \"{}\". {}", path, suggestion(keyword, "entries", known)));
}

std::string entriesText(const Node&, int indent);

std::string valueText(const DictionaryEntry& e, int indent)
{
    const auto block = [&](const Node& node, int by) { return fmt::format("{{\n{}{:{}}}}", entriesText(node, by + 4), "", by); };
    if (e.dictionary) return block(*e.dictionary, indent);

    std::string text;
    for (const auto& token : e.value)
    {
        const bool tight = text.empty() || text.ends_with('(') || text.ends_with('{') || token.is(')') || token.is('}') || token.is('{');
        if (!tight) text += ' ';
        text += token.dictionary ? token.text + (token.text.empty() ? "" : " ") + block(*token.dictionary, indent) : toString(token);
    }
    return text;
}

/// Text of an entry in foamDictionary's layout.
std::string entryText(const DictionaryEntry& e, int indent)
{
    const auto keyword = keywordText(e);
    if (e.dictionary) return fmt::format("{:{}}{}\n{:{}}{}\n", "", indent, keyword, "", indent, valueText(e, indent));
    return fmt::format("{:{}}{:<15} {};\n", "", indent, keyword, valueText(e, indent));
}

std::string entriesText(const Node& node, int indent)
{
    std::string text;
    for (const auto& e : node.entries) text += entryText(e, indent);
    return text;
}

constexpr const char* blanks = " \t\r\n";

/// A dictionary, not a value.
bool isBlock(const std::string& value)
{
    const auto first = value.find_first_not_of(blanks);
    return first != value.npos && value[first] == '{';
}

/// Checks that the edited text is readable, and that the given value is all of the entry's: it may name an unknown macro, or end too early.
void checkEdited(const Dictionary& edited, const std::string& path, const std::string& value, std::size_t begin)
{
    try
    {
        edited.diagnostics().throwIfAny();
    }
    catch (const CaseError& e)
    {
        throw CaseError(fmt::format("With \"{}\" for \"{}\" the file would be unreadable and is left as it is:\n{}", beginning(value),
                                    beginning(path), e.what()));
    }
    const auto found = walk(edited.node(), withoutLeadingColon(path), false);
    if (found.empty()) throw CaseError({edited.name(), 0}, fmt::format("\"{}\" cannot be an entry of this file", beginning(path)));
    const auto& e = *found.back();
    const auto first = value.find_first_not_of(blanks), last = value.find_last_not_of(blanks);
    const bool whole = first == value.npos ? e.value.empty() : e.begin == begin + first && e.end == begin + last + 1;
    if (!whole || bool(e.dictionary) != isBlock(value))
        throw CaseError(fmt::format("\"{}\" cannot be the value of an entry: brackets and quotes must be balanced, without ';' behind it",
                                    beginning(value)));
    if (const auto* header = edited.node().findExact("FoamFile"); header && !header->dictionary)
        throw CaseError(header->where, "the header FoamFile is a dictionary");
}

/// A file that is to be edited: what it says, and its characters. Throws CaseError where it has mistakes.
struct EditedFile
{
    Dictionary dictionary;
    std::string text;
};

EditedFile readToEdit(const std::filesystem::path& caseFolder, const std::string& file)
{
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto dictionary = Dictionary::read(caseFolder, file, diagnostics);
    diagnostics->throwIfAny();
    std::string reason;
    return {dictionary, readText(caseFolder / file, reason).value()};
}

/// The text of what is to be edited belongs to it alone.
void checkOwn(const Path& entries, const std::string& file, const std::string& path)
{
    for (const auto* e : entries)
        if (e->copied || e->where.file != file)
            throw CaseError(e->where, fmt::format("\"{}\" of \"{}\" stands here, where changing it would change more than this entry; "
                                                  "give it a line of its own in \"{}\" first",
                                                  e->keyword, path, file));
}

/// Place behind the last entry of a dictionary: before the line of its closing brace, or at the end of the file, where it is before the
/// "// **** //" that closes OpenFOAM's files.
std::size_t placeOfNewEntry(const std::string& text, const Node& node)
{
    auto at = std::min(node.end, text.size());
    if (at == text.size())
        if (const auto last = text.find_last_not_of(" \t\n"); last != text.npos)
            if (const auto begin = text.rfind('\n', last); begin != text.npos && text.compare(begin + 1, 4, "// *") == 0) return begin + 1;
    const auto line = text.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
    if (line != text.npos && line < at && text[line] == '\n') at = line + 1;
    return at;
}

}

std::string valueText(const Dictionary& dictionary, const std::string& path) { return valueText(require(dictionary, path), 0); }

std::string entryText(const Dictionary& dictionary, const std::string& path)
{
    return path.empty() ? entriesText(dictionary.node(), 0) : entryText(require(dictionary, path), 0);
}

std::vector<std::string> keywords(const Dictionary& dictionary, const std::string& path)
{
    const auto* node = &dictionary.node();
    if (!path.empty())
    {
        const auto& entry = require(dictionary, path);
        if (!entry.dictionary) throw CaseError(entry.where, fmt::format("\"{}\" is not a dictionary", path));
        node = entry.dictionary.get();
    }
    std::vector<std::string> all;
    for (const auto& e : node->entries) all.push_back(keywordText(e));
    return all;
}

void setEntry(const std::filesystem::path& caseFolder, const std::string& file, const std::string& path, const std::string& value)
{
    auto [dictionary, text] = readToEdit(caseFolder, file);

    const auto name = withoutLeadingColon(path);
    std::size_t begin = 0; // of the value
    if (const auto found = walk(dictionary.node(), name, false); !found.empty())
    {
        checkOwn(found, file, path);
        const auto& e = *found.back();
        // "keyword;" has no value to replace: one is put behind the keyword. A dictionary has no ';' that a value could use.
        const bool needsEnd = e.dictionary && !isBlock(value);
        begin = e.begin + (e.begin == e.end);
        text.replace(e.begin, e.end - e.begin, (e.begin == e.end ? " " : "") + value + (needsEnd ? ";" : ""));
    }
    else
    {
        const auto dot = name.find_last_of("./:");
        const auto outer = dot == name.npos ? Path{} : walk(dictionary.node(), name.substr(0, dot), false);
        if (dot != name.npos && (outer.empty() || !outer.back()->dictionary))
            throw CaseError({file, 0},
                            fmt::format("there is no dictionary \"{}\" to add \"{}\" to", name.substr(0, dot), name.substr(dot + 1)));
        checkOwn(outer, file, path);
        const auto& node = outer.empty() ? dictionary.node() : *outer.back()->dictionary;
        const auto at = placeOfNewEntry(text, node);
        const bool ownLine = at == 0 || text[at - 1] == '\n';
        const auto keyword =
            fmt::format("{:{}}{:<15} ", "", ownLine ? 4 * outer.size() : std::size_t(1), dot == name.npos ? name : name.substr(dot + 1));
        begin = at + keyword.size();
        text.insert(at, keyword + value + (ownLine ? ";\n" : "; "));
    }

    checkEdited(readAs(text, caseFolder, file, std::make_shared<Diagnostics>()), path, value, begin);
    writeFile(caseFolder / file, text);
}

void appendEntry(const std::filesystem::path& caseFolder, const std::string& file, const std::string& keyword, const std::string& value)
{
    auto [dictionary, text] = readToEdit(caseFolder, file);
    text.insert(placeOfNewEntry(text, dictionary.node()),
                fmt::format("{}{:<15} {}{}\n", text.ends_with('\n') ? "" : "\n", keyword, value, isBlock(value) ? "" : ";"));
    readAs(text, caseFolder, file, std::make_shared<Diagnostics>()).diagnostics().throwIfAny();
    writeFile(caseFolder / file, text);
}

void removeEntry(const std::filesystem::path& caseFolder, const std::string& file, const std::string& path)
{
    auto [dictionary, text] = readToEdit(caseFolder, file);
    require(dictionary, path);
    const auto found = walk(dictionary.node(), withoutLeadingColon(path), false);
    if (found.empty()) throw CaseError({file, 0}, fmt::format("\"{}\" is given by a pattern, which stays", path));
    checkOwn(found, file, path);
    const auto& e = *found.back();
    auto begin = text.rfind(e.keyword, e.begin - 1);
    if (e.pattern) --begin; // its quote
    auto end = e.dictionary ? e.end : text.find(';', e.end) + 1;
    const auto lineBegin = text.find_last_not_of(" \t", begin == 0 ? 0 : begin - 1), lineEnd = text.find_first_not_of(" \t", end);
    const bool ownsBegin = begin == 0 || lineBegin == text.npos || text[lineBegin] == '\n',
               ownsEnd = lineEnd == text.npos || text[lineEnd] == '\n';
    if (ownsBegin && ownsEnd)
    {
        begin = lineBegin == text.npos || begin == 0 ? 0 : lineBegin + 1;
        end = lineEnd == text.npos ? text.size() : lineEnd + 1;
    }
    text.erase(begin, end - begin);
    const auto edited = readAs(text, caseFolder, file, std::make_shared<Diagnostics>());
    edited.diagnostics().throwIfAny();
    writeFile(caseFolder / file, text);
    if (!walk(edited.node(), withoutLeadingColon(path), false).empty()) removeEntry(caseFolder, file, path); // it was given twice
}

}
