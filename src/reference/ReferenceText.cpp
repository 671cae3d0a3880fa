#include "reference/ReferenceText.hpp"
#include "base/words.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

using Entries = std::vector<ListedEntry>;

bool isFreeName(const ListedEntry& e) { return e.info.keyword.starts_with('<'); }

/// Descends by one word: a keyword, the word of a choice, or either of these below a freely named dictionary or another word.
std::optional<Entries> below(const Entries& entries, const std::string& word)
{
    for (const auto& e : entries)
        if (e.info.keyword == word) return e.inside.empty() ? Entries{e} : e.inside;
    for (const auto& e : entries)
        for (const auto& [choice, beside] : e.cases)
            if (choice == word) return beside;
    for (const auto& e : entries)
    {
        if (isFreeName(e))
            if (auto found = below(e.inside, word)) return found;
        for (const auto& [choice, beside] : e.cases)
            if (auto found = below(beside, word)) return found;
    }
    return {};
}

void collectWords(const Entries& entries, std::vector<std::string>& words)
{
    for (const auto& e : entries)
    {
        if (isFreeName(e)) collectWords(e.inside, words);
        else words.push_back(e.info.keyword);
        for (const auto& [choice, beside] : e.cases)
        {
            words.push_back(choice);
            collectWords(beside, words);
        }
    }
}

/// "number [m], > 0"
std::string typeText(const ParameterInfo& i)
{
    return i.type + (i.unit.empty() ? "" : " [" + i.unit + "]") + (i.range.empty() ? "" : ", " + i.range);
}

std::string defaultText(const ParameterInfo& i) { return i.isRequired ? "required" : i.fallback; }

/// True where words alone do not tell all.
bool wordsNeedLines(const ListedEntry& e)
{
    return !e.cases.empty() || std::ranges::any_of(e.info.choices, [](const ChoiceWord& c) { return !c.meaning.empty(); });
}

std::string inText(const Entries& entries, int depth)
{
    const std::string indent(std::size_t(4 * depth), ' ');
    std::string text;
    for (const auto& e : entries)
    {
        const auto& i = e.info;
        const auto head =
            defaultText(i).empty() ? typeText(i) : fmt::format("{}; {}{}", typeText(i), i.isRequired ? "" : "default ", defaultText(i));
        text += fmt::format("{}{:<16} {}\n", indent, i.keyword, head);
        if (!i.meaning.empty()) text += fmt::format("{}{:16} {}\n", indent, "", i.meaning);
        if (!i.choices.empty() && !wordsNeedLines(e)) text += fmt::format("{}{:16} {}\n", indent, "", list(i.choices.words()));
        for (const auto& [word, meaning] : wordsNeedLines(e) ? i.choices : ChoiceWords{})
        {
            text += fmt::format("{}    {}{}\n", indent, word, meaning.empty() ? "" : ": " + meaning);
            for (const auto& [choice, beside] : e.cases)
                if (choice == word) text += inText(beside, depth + 2);
        }
        text += inText(e.inside, depth + 1);
    }
    return text;
}

/// A cell of a table must not end it.
std::string cellText(std::string text)
{
    for (auto at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
    for (auto at = text.find('<'); at != std::string::npos; at = text.find('<', at + 4)) text.replace(at, 1, "&lt;");
    return text;
}

/// `with`: the words of choices that these entries come with.
void addTables(const Entries& entries, const std::string& path, const std::string& with, const std::string& meaning, std::string& page)
{
    page += fmt::format("{}`{}`{}\n\n{}| entry | type | unit | default | meaning |\n|---|---|---|---|---|\n", page.empty() ? "# " : "\n## ",
                        path, with, meaning.empty() ? "" : meaning + "\n\n");
    for (const auto& [i, inside, cases] : entries)
    {
        std::string says = i.meaning;
        for (const auto& [word, what] : i.choices)
            says += fmt::format("{}`{}`{}", &word == &i.choices.front().word ? ": " : ", ", word, what.empty() ? "" : " (" + what + ")");
        const auto type = i.range.empty() ? i.type : i.type + " " + i.range;
        const auto fallback = i.isRequired ? "**required**" : i.isFixed ? "`" + i.fallback + "`" : cellText(i.fallback);
        page += fmt::format("| `{}` | {} | {} | {} | {} |\n", i.keyword, cellText(type), i.unit, fallback, cellText(says));
    }
    for (const auto& [i, inside, cases] : entries)
    {
        for (const auto& [word, beside] : cases) addTables(beside, path, fmt::format("{}, {} `{}`", with, i.keyword, word), "", page);
        if (!inside.empty()) addTables(inside, path + "." + i.keyword, with, "", page);
    }
}

std::string commentedOut(const std::string& lines)
{
    std::string text;
    for (std::size_t at = 0; at < lines.size();)
    {
        const auto end = lines.find('\n', at);
        const auto line = lines.substr(at, end - at);
        const auto first = std::min(line.find_first_not_of(' '), line.size());
        text += line.substr(0, first) + (line.substr(first, 2) == "//" ? "" : "// ") + line.substr(first) + "\n";
        at = end + 1;
    }
    return text;
}

std::string asTemplate(const Entries& entries, int depth)
{
    const std::string indent(std::size_t(4 * depth), ' ');
    std::string text;
    for (const auto& e : entries)
    {
        const auto& i = e.info;
        std::string says = i.meaning;
        if (!i.unit.empty()) says += fmt::format(" [{}]", i.unit);
        if (!i.range.empty()) says += fmt::format(", {}", i.range);
        if (!i.choices.empty() && !wordsNeedLines(e)) says += ": " + list(i.choices.words());
        if (!i.isRequired && !i.isFixed && !i.fallback.empty()) says += fmt::format("; default: {}", i.fallback);
        std::string lines;
        if (i.type.ends_with("of dictionaries"))
            lines = fmt::format("{0}{1}    // {2}\n{0}(\n{0}    {{\n{3}{0}    }}\n{0});\n", indent, i.keyword, says,
                                asTemplate(e.inside, depth + 2));
        else if (!e.inside.empty() || i.type == "dictionary")
            lines = fmt::format("{0}{1}    // {2}\n{0}{{\n{3}{0}}}\n", indent, i.keyword, says, asTemplate(e.inside, depth + 1));
        else lines = fmt::format("{}{:<16} {:<16} // {}\n", indent, i.keyword, (i.example.empty() ? "name" : i.example) + ";", says);
        if (wordsNeedLines(e))
            for (const auto& [word, meaning] : i.choices)
                lines += fmt::format("{}//-     {}{}\n", indent, word, meaning.empty() ? "" : ": " + meaning);
        const auto chosen = i.isFixed ? i.fallback : i.choices.empty() ? "" : i.choices.front().word;
        text += i.isRequired ? lines : commentedOut(lines);
        for (const auto& [word, beside] : e.cases)
        {
            const auto rest = asTemplate(beside, depth);
            text += word == chosen ? rest : fmt::format("{}//- with {} {}:\n{}", indent, i.keyword, word, commentedOut(rest));
        }
    }
    return text;
}

}

std::string pathOf(const TableInfo& table) { return "postProcessing/" + table.writer; }
std::string meaningOf(const TableInfo& table) { return fmt::format("`{}`: {}", table.file, table.meaning); }

ReferencePart findPart(const EntryRegistry& registry, const std::string& path)
{
    for (const auto& table : registry.tables())
        if (path == pathOf(table)) return {path, meaningOf(table), {}, table.columns};
    const EntryRegistry::File* file = nullptr;
    for (const auto& f : registry.files())
        if (path == f.name || path.starts_with(f.name + ".")) file = &f;
    if (!file)
    {
        std::vector<std::string> names;
        for (const auto& f : registry.files()) names.push_back(f.name);
        for (const auto& table : registry.tables()) names.push_back(pathOf(table));
        throw CaseError(
            fmt::format("There is no reference of \"{0}\". {1}", path, suggestion(path.substr(0, path.find('.')), "files", names)));
    }
    ReferencePart part{path, path == file->name ? file->meaning : "", file->entries, {}};
    for (std::size_t at = file->name.size(); at < path.size();)
    {
        const auto end = std::min(path.find('.', at + 1), path.size());
        const auto word = path.substr(at + 1, end - at - 1);
        auto found = below(part.entries, word);
        if (!found)
            throw CaseError(
                fmt::format("{} has no entry \"{}\". {}", path.substr(0, at), word, suggestion(word, "entries", wordsBelow(part))));
        part.entries = std::move(*found);
        at = end;
    }
    return part;
}

std::vector<std::string> wordsBelow(const ReferencePart& part)
{
    std::vector<std::string> words;
    collectWords(part.entries, words);
    std::ranges::sort(words);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
}

std::string listText(const ReferencePart& part)
{
    std::string columns;
    for (const auto& column : part.columns) columns += fmt::format("{:<24} {}\n{:24} {}\n", column.name, column.unit, "", column.meaning);
    return fmt::format("{}{}\n\n{}{}", part.path, part.meaning.empty() ? "" : ": " + part.meaning, columns, inText(part.entries, 0));
}

std::string markdownText(const ReferencePart& part)
{
    std::string page;
    if (!part.columns.empty())
    {
        page = fmt::format("\n## `{}`\n\n{}\n\n| column | unit | meaning |\n|---|---|---|\n", part.path, part.meaning);
        for (const auto& column : part.columns)
            page += fmt::format("| `{}` | {} | {} |\n", column.name, column.unit, cellText(column.meaning));
        return page;
    }
    addTables(part.entries, part.path, "", part.meaning, page);
    return page;
}

std::string templateText(const ReferencePart& part)
{
    if (!part.columns.empty())
        throw CaseError(fmt::format("{} is written by the suite, and not to be filled in; its columns: -list {}", part.path, part.path));
    const auto slash = part.path.rfind('/');
    return fmt::format("FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n//- {}\n\n{}",
                       part.path.substr(slash == std::string::npos ? 0 : slash + 1), part.meaning, asTemplate(part.entries, 0));
}

}
