#include "dictionary/Dictionary.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryNode.hpp"
#include "dictionary/TokenReader.hpp"
#include "dictionary/expandPath.hpp"
#include "dictionary/readWith.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

std::shared_ptr<Dictionary::Node> newNode(const std::string& name, std::shared_ptr<Diagnostics> diagnostics)
{
    auto node = std::make_shared<Dictionary::Node>();
    node->name = name;
    node->keyword = std::filesystem::path(name).filename().string();
    node->where = {name, 0};
    node->diagnostics = std::move(diagnostics);
    return node;
}

std::string quoted(const std::string& key) { return '"' + key + '"'; }

Location place(Dictionary::Node& node, const std::string& key)
{
    const auto* entry = node.find(key);
    return entry ? entry->where : node.where;
}

void missing(Dictionary::Node& node, const std::string& key, const char* what)
{
    if (node.missing) return;
    std::vector<std::string> unread;
    for (const auto& e : node.entries)
        if (!e.used && !e.pattern) unread.push_back(e.keyword);
    const auto near = nearest(key, unread);
    const auto inside = node.name == node.where.file ? "" : fmt::format(" in \"{}\"", node.keyword);
    const auto hint = near.empty() ? "" : fmt::format(". Is \"{}\" in line {} meant?", near, place(node, near).line);
    node.diagnostics->error(node.where, fmt::format("{} \"{}\" is missing{}{}", what, key, inside, hint));
}

/// The entry, counted as read; none, and an error where it is required, if it is missing or a dictionary.
DictionaryEntry* valueEntry(Dictionary::Node& node, const std::string& key, bool required)
{
    node.lookUp(key);
    auto* entry = node.find(key);
    if (!entry)
    {
        if (required) missing(node, key, "entry");
        return nullptr;
    }
    entry->used = true;
    if (!entry->dictionary) return entry;
    node.diagnostics->error(entry->where, quoted(key) + " must be a value, found a dictionary");
    return nullptr;
}

/// Value that `read` makes of an entry; nothing where it is missing or wrong.
template<class Read>
auto valueOf(Dictionary::Node& node, const std::string& key, bool required, const Read& read)
    -> std::optional<decltype(read(std::declval<TokenReader&>()))>
{
    const auto* entry = valueEntry(node, key, required);
    if (!entry) return {};
    try
    {
        TokenReader tokens(entry->value);
        auto value = read(tokens);
        tokens.finish();
        return value;
    }
    catch (const ValueError& e)
    {
        node.diagnostics->error(entry->where, fmt::format("\"{}\" {}", key, e.what()));
        return {};
    }
}

template<class T> std::optional<T> plain(Dictionary::Node& node, const std::string& key, bool required)
{
    return valueOf(node, key, required,
                   [](TokenReader& tokens)
                   {
                       T value{};
                       tokens.read(value);
                       return value;
                   });
}

template<class T> std::optional<T> dimensioned(Dictionary::Node& node, const std::string& key, const DimensionSet& expected, bool required)
{
    return valueOf(node, key, required,
                   [&](TokenReader& tokens)
                   {
                       const auto before = tokens.dimensions();
                       T value{};
                       tokens.read(value);
                       const auto behind = tokens.dimensions();
                       if (const auto given = before ? before : behind; given && *given != expected)
                           throw ValueError(fmt::format("has dimensions {}, expected {}", toString(*given), toString(expected)));
                       return value;
                   });
}

}

Dictionary Dictionary::read(const std::filesystem::path& caseFolder, const std::string& file, std::shared_ptr<Diagnostics> diagnostics)
{
    const auto path = caseFolder / file;
    std::string reason;
    if (const auto text = readText(path, reason)) return readAs(*text, caseFolder, file, diagnostics);

    Dictionary d(newNode(file, diagnostics));
    d.node_->missing = true;
    std::vector<std::string> siblings;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(path.parent_path(), none))
        siblings.push_back(entry.path().filename().string());
    const auto near = nearest(path.filename().string(), siblings);
    diagnostics->error({file, 0}, reason + (near.empty() || near == path.filename() ? "" : fmt::format(". Is \"{}\" meant?", near)));
    return d;
}

Dictionary Dictionary::parse(const std::string& text, const std::string& file, std::shared_ptr<Diagnostics> diagnostics)
{
    return readAs(text, ".", file, std::move(diagnostics));
}

Dictionary Dictionary::empty(const std::string& name, std::shared_ptr<Diagnostics> diagnostics)
{
    return Dictionary(newNode(name, std::move(diagnostics)));
}

const std::string& Dictionary::name() const { return node_->name; }
std::string Dictionary::keyword() const { return node_->keyword; }
Location Dictionary::location() const { return node_->where; }

bool Dictionary::found(const std::string& key) const
{
    node_->lookUp(key);
    auto* entry = node_->find(key);
    if (entry) entry->used = true;
    return entry;
}

Location Dictionary::where(const std::string& key) const { return place(*node_, key); }

std::vector<std::string> Dictionary::keys() const
{
    std::vector<std::string> all;
    for (const auto& e : node_->entries)
        if (e.keyword != "FoamFile") all.push_back(e.keyword);
    return all;
}

bool Dictionary::isWord(const std::string& key, const std::string& word) const
{
    node_->lookUp(key);
    auto* entry = node_->find(key);
    const bool is = entry && entry->value.size() == 1 && entry->value[0].kind == Token::Kind::word && entry->value[0].text == word;
    if (is) entry->used = true;
    return is;
}

bool Dictionary::isDictionary(const std::string& key) const
{
    const auto* entry = node_->find(key);
    return entry && entry->dictionary;
}

Dictionary Dictionary::subDict(const std::string& key) const
{
    node_->lookUp(key);
    auto* entry = node_->find(key);
    if (entry && entry->dictionary)
    {
        entry->used = true;
        entry->dictionary->visited = true;
        return Dictionary(entry->dictionary);
    }
    if (!entry) missing(*node_, key, "dictionary");
    else
    {
        entry->used = true;
        node_->diagnostics->error(entry->where, quoted(key) + " must be a dictionary \"{ ... }\", found a value");
    }
    auto absent = node_->child(key, place(*node_, key));
    absent->parent = nullptr;
    absent->missing = true;
    return Dictionary(absent);
}

Dictionary Dictionary::subDictOrEmpty(const std::string& key) const
{
    if (node_->find(key)) return subDict(key);
    node_->lookUp(key);
    auto none = node_->child(key, node_->where);
    none->parent = nullptr;
    return Dictionary(none);
}

std::vector<Dictionary> Dictionary::dictionaries(const std::string& key) const
{
    std::vector<Dictionary> all;
    if (isDictionary(key))
    {
        const auto sub = subDict(key);
        for (const auto& name : sub.keys()) all.push_back(sub.subDict(name));
        return all;
    }
    valueOf(*node_, key, true,
            [&](TokenReader& tokens)
            {
                const char* const list = "a list of dictionaries \"( { .. } { .. } )\"";
                if (tokens.sees(Token::Kind::number)) tokens.take(list);
                if (!tokens.accept('(')) throw ValueError(fmt::format("must be {}, found \"{}\"", list, tokens.rest()));
                while (!tokens.accept(')'))
                {
                    const auto& token = tokens.take(list);
                    if (!token.dictionary) throw ValueError(fmt::format("must be {}, found \"{}\" in it", list, toString(token)));
                    token.dictionary->visited = true;
                    all.push_back(Dictionary(token.dictionary));
                }
                return true;
            });
    return all;
}

template<class T> T Dictionary::get(const std::string& key) const { return plain<T>(*node_, key, true).value_or(T{}); }
template<class T> T Dictionary::get(const std::string& key, const T& fallback) const
{
    return plain<T>(*node_, key, false).value_or(fallback);
}

template double Dictionary::get(const std::string&) const;
template double Dictionary::get(const std::string&, const double&) const;
template int Dictionary::get(const std::string&) const;
template int Dictionary::get(const std::string&, const int&) const;
template bool Dictionary::get(const std::string&) const;
template bool Dictionary::get(const std::string&, const bool&) const;
template std::string Dictionary::get(const std::string&) const;
template std::string Dictionary::get(const std::string&, const std::string&) const;
template Vector<3> Dictionary::get(const std::string&) const;
template Vector<3> Dictionary::get(const std::string&, const Vector<3>&) const;
template std::vector<double> Dictionary::get(const std::string&) const;
template std::vector<double> Dictionary::get(const std::string&, const std::vector<double>&) const;
template std::vector<int> Dictionary::get(const std::string&) const;
template std::vector<int> Dictionary::get(const std::string&, const std::vector<int>&) const;
template std::vector<bool> Dictionary::get(const std::string&) const;
template std::vector<bool> Dictionary::get(const std::string&, const std::vector<bool>&) const;
template std::vector<std::string> Dictionary::get(const std::string&) const;
template std::vector<std::string> Dictionary::get(const std::string&, const std::vector<std::string>&) const;
template std::vector<Vector<3>> Dictionary::get(const std::string&) const;
template std::vector<Vector<3>> Dictionary::get(const std::string&, const std::vector<Vector<3>>&) const;
template std::vector<std::vector<double>> Dictionary::get(const std::string&) const;
template std::vector<std::vector<double>> Dictionary::get(const std::string&, const std::vector<std::vector<double>>&) const;

std::string Dictionary::getPath(const std::string& key, const std::string& folder, const std::string& fallback) const
{
    const auto text = get(key, fallback);
    const auto& caseFolder = node_->caseFolder ? *node_->caseFolder : std::filesystem::path(".");
    try
    {
        const std::filesystem::path path = expandPath(text, caseFolder, [](const std::string&) { return std::nullopt; });
        if (path.is_relative()) return path.string();
        // The path is relative as the operating system sees folders, which may be links.
        return (std::filesystem::relative(path.parent_path(), caseFolder / folder) / path.filename()).lexically_normal().string();
    }
    catch (const PathError& e)
    {
        error(key, fmt::format("\"{}\": \"{}\" {}", key, text, e.what()));
        return fallback;
    }
}

double Dictionary::get(const std::string& key, const DimensionSet& expected) const
{
    return dimensioned<double>(*node_, key, expected, true).value_or(0);
}
double Dictionary::get(const std::string& key, const DimensionSet& expected, double fallback) const
{
    return dimensioned<double>(*node_, key, expected, false).value_or(fallback);
}
Vector<3> Dictionary::getVector(const std::string& key, const DimensionSet& expected) const
{
    return dimensioned<Vector<3>>(*node_, key, expected, true).value_or(Vector<3>{});
}
Vector<3> Dictionary::getVector(const std::string& key, const DimensionSet& expected, Vector<3> fallback) const
{
    return dimensioned<Vector<3>>(*node_, key, expected, false).value_or(fallback);
}

/// The harmless value of a positive quantity is 1: something may be divided by it before the errors are reported.
double Dictionary::getPositive(const std::string& key, const DimensionSet& expected) const
{
    const auto value = dimensioned<double>(*node_, key, expected, true);
    if (value && *value <= 0) error(key, fmt::format("\"{}\" must be positive, found {}", key, *value));
    return value && *value > 0 ? *value : 1;
}
double Dictionary::getPositive(const std::string& key, const DimensionSet& expected, double fallback) const
{
    return node_->find(key) ? getPositive(key, expected) : get(key, expected, fallback);
}
double Dictionary::getNonNegative(const std::string& key, const DimensionSet& expected, double fallback) const
{
    const double value = get(key, expected, fallback);
    if (value >= 0 || !node_->find(key)) return value;
    error(key, fmt::format("\"{}\" must not be negative, found {}", key, value));
    return fallback;
}

std::string Dictionary::choose(const std::string& key, std::span<const std::string> valid) const
{
    const auto word = plain<std::string>(*node_, key, true);
    if (word && std::find(valid.begin(), valid.end(), *word) != valid.end()) return *word;
    if (word) error(key, fmt::format("{} \"{}\" is unknown. {}", key, *word, suggestion(*word, key, valid)));
    return valid.empty() ? "" : valid.front();
}
std::string Dictionary::choose(const std::string& key, std::span<const std::string> valid, const std::string& fallback) const
{
    if (node_->find(key)) return choose(key, valid);
    node_->lookUp(key);
    return fallback;
}

std::vector<Dictionary::PairValue> Dictionary::pairs(const std::string& key) const
{
    return valueOf(*node_, key, true,
                   [](TokenReader& tokens)
                   {
                       const char* const list = "a list of pairs with values \"( (a b) 0.07 .. )\"";
                       std::vector<PairValue> all;
                       if (!tokens.accept('(')) throw ValueError(fmt::format("must be {}, found \"{}\"", list, tokens.rest()));
                       while (!tokens.accept(')'))
                       {
                           PairValue pair;
                           if (!tokens.accept('(')) throw ValueError(fmt::format("must be {}, found \"{}\" in it", list, tokens.rest()));
                           tokens.read(pair.first);
                           tokens.accept("and");
                           tokens.read(pair.second);
                           if (!tokens.accept(')'))
                               throw ValueError(fmt::format("must be {}, found \"{}\" in a pair", list, tokens.rest()));
                           tokens.read(pair.value);
                           all.push_back(std::move(pair));
                       }
                       return all;
                   })
        .value_or(std::vector<PairValue>{});
}

void Dictionary::error(const std::string& key, const std::string& what) const { node_->diagnostics->error(where(key), what); }
Diagnostics& Dictionary::diagnostics() const { return *node_->diagnostics; }
std::shared_ptr<Diagnostics> Dictionary::sharedDiagnostics() const { return node_->diagnostics; }

namespace
{

void reportUnusedIn(Dictionary::Node& node)
{
    for (const auto& e : node.entries)
    {
        if (e.ignored || e.keyword == "FoamFile") continue;
        if (e.used)
        {
            if (e.dictionary && e.dictionary->visited) reportUnusedIn(*e.dictionary);
            for (const auto& token : e.value)
                if (token.dictionary && token.dictionary->visited) reportUnusedIn(*token.dictionary);
            continue;
        }
        // An included file may serve several dictionaries, each of which reads a part of it: there, a near miss alone is a
        // mistake.
        const auto meant = nearest(e.keyword, node.lookedUp);
        if (e.included && (meant.empty() || node.find(meant))) continue;
        node.diagnostics->error(e.where, fmt::format("{} \"{}\" is not used here. {}", e.dictionary ? "dictionary" : "entry", e.keyword,
                                                     suggestion(e.keyword, "entries", node.lookedUp)));
    }
}

}

void Dictionary::reportUnused() const { reportUnusedIn(*node_); }

void Dictionary::ignore(const std::string& key) const
{
    if (auto* entry = node_->find(key)) entry->ignored = true;
}

}
