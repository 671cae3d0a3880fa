#include "base/readText.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryParser.hpp"
#include "dictionary/Tokeniser.hpp"
#include "dictionary/expandPath.hpp"
#include "dictionary/limits.hpp"
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <map>

namespace sph
{

using Kind = Token::Kind;

std::optional<bool> toSwitch(const std::string& word)
{
    static const std::map<std::string, bool> words{{"yes", true}, {"on", true},   {"true", true},   {"y", true},  {"t", true},
                                                   {"no", false}, {"off", false}, {"false", false}, {"n", false}, {"f", false}};
    const auto found = words.find(word);
    return found == words.end() ? std::nullopt : std::optional(found->second);
}

void DictionaryParser::directive(Dictionary::Node& scope, const Token& d)
{
    const auto& name = d.text;
    if (name == "include" || name == "includeIfPresent" || name == "sinclude" || name == "includeEtc" || name == "sincludeEtc")
        include(scope, d);
    else if (name == "inputMode") inputMode(d);
    else if (name == "default" || name == "merge" || name == "overwrite" || name == "warn" || name == "error") modifiedEntry(scope, d);
    else if (name == "remove") remove(scope, d);
    else if (name == "if" || name == "ifeq") openBranch(scope, d);
    else if (name == "else" || name == "elif" || name == "endif") endOrElse(scope, d);
    else unsupported(d);
}

void DictionaryParser::unsupported(const Token& d)
{
    static const std::vector<std::string> valid{
        "default",          "elif",      "else",  "endif",     "error",  "eval",     "if",          "ifeq", "include", "includeEtc",
        "includeIfPresent", "inputMode", "merge", "overwrite", "remove", "sinclude", "sincludeEtc", "warn"};
    if (d.text == "calc" || d.text == "codeStream")
        error(d.line, fmt::format("#{} is not supported: it compiles C++ code against OpenFOAM's own libraries while the case is read. "
                                  "#eval{{ ... }} calculates values",
                                  d.text));
    else if (d.text == "includeFunc")
        error(d.line, "#includeFunc is not supported: it names a function object of OpenFOAM. Write the function object out, or "
                      "#include a file with it");
    else error(d.line, fmt::format("directive \"#{}\" is unknown. {}", d.text, suggestion(d.text, "directives", valid)));

    // The argument of a refused directive goes with it.
    if (sameLine(d.line) && (peek().kind == Kind::string || peek().kind == Kind::verbatim)) ++at_;
    else if (!atEnd() && peek().is('{') && d.text == "codeStream") skipBlock();
    else
        while (d.firstOnLine && sameLine(d.line) && !peek().is('}')) ++at_;
}

void DictionaryParser::include(Dictionary::Node& scope, const Token& d)
{
    if (!sameLine(d.line) || !peek().isText())
    {
        error(d.line, fmt::format("#{} is not followed by a file name in quotes", d.text));
        return;
    }
    const auto wanted = tokens_[at_++].text;
    const bool optional = d.text == "includeIfPresent" || d.text == "sinclude" || d.text == "sincludeEtc";
    std::filesystem::path file;
    try
    {
        const std::filesystem::path path =
            expandPath(wanted, context_.caseFolder, [&](const std::string& name) { return textOf(scope, name, d.line); });
        const bool fromEtc = path.is_relative() && (d.text == "includeEtc" || d.text == "sincludeEtc");
        file = fromEtc ? etcFile(path) : folder_ / path;
    }
    catch (const PathError& e)
    {
        // A file in a folder that is known nowhere is not present.
        if (!optional) error(d.line, fmt::format("#{} \"{}\" {}", d.text, wanted, e.what()));
        return;
    }
    std::error_code none;
    const auto canonical = std::filesystem::weakly_canonical(file, none);
    if (std::find(context_.open.begin(), context_.open.end(), canonical) != context_.open.end())
    {
        error(d.line, fmt::format("\"{}\" includes itself", wanted));
        return;
    }
    std::string reason;
    const auto text = readText(file, reason);
    // Messages name files of the case relative to the case folder.
    const auto relative = canonical.lexically_relative(std::filesystem::weakly_canonical(context_.caseFolder, none));
    const auto shown = relative.empty() || relative.begin()->string() == ".." ? canonical.string() : relative.string();
    if (!text)
    {
        if (std::filesystem::exists(file, none)) error(d.line, fmt::format("\"{}\" cannot be included: {}", shown, reason));
        else if (!optional) error(d.line, fmt::format("there is no file \"{}\" to include", shown));
        return;
    }
    if (++context_.included > limit::includes) return stop(d.line, fmt::format("more than {} files are included", limit::includes));
    context_.open.push_back(canonical);
    DictionaryParser(context_, *text, shown, file.parent_path()).parse(scope);
    context_.open.pop_back();
}

void DictionaryParser::inputMode(const Token& d)
{
    static const std::map<std::string, InputMode> modes{{"merge", InputMode::merge},         {"default", InputMode::merge},
                                                        {"overwrite", InputMode::overwrite}, {"protect", InputMode::protect},
                                                        {"warn", InputMode::warn},           {"error", InputMode::error}};
    const auto word = sameLine(d.line) ? tokens_[at_++].text : std::string();
    if (sameLine(d.line) && peek().is(';')) ++at_;
    const auto mode = modes.find(word);
    if (mode != modes.end())
    {
        context_.mode = mode->second;
        return;
    }
    std::vector<std::string> names;
    for (const auto& [name, value] : modes) names.push_back(name);
    error(d.line, fmt::format("input mode \"{}\" is unknown. {}", word, suggestion(word, "modes", names)));
}

/// `#default b 2;` sets what is not there yet; the other modes likewise hold for the one entry that follows.
void DictionaryParser::modifiedEntry(Dictionary::Node& scope, const Token& d)
{
    static const std::map<std::string, InputMode> modes{{"default", InputMode::protect},
                                                        {"merge", InputMode::merge},
                                                        {"overwrite", InputMode::overwrite},
                                                        {"warn", InputMode::warn},
                                                        {"error", InputMode::error}};
    if (!atEnd() && peek().isText()) entry(scope, tokens_[at_++], modes.at(d.text));
    else error(d.line, fmt::format("#{} is not followed by an entry", d.text));
}

/// `#remove x`, `#remove (x "y.*")`
void DictionaryParser::remove(Dictionary::Node& scope, const Token& d)
{
    std::vector<Token> names;
    if (sameLine(d.line) && peek().is('('))
    {
        const auto opening = at_++;
        while (!atEnd() && peek().isText()) names.push_back(tokens_[at_++]);
        if (!atEnd() && peek().is(')')) ++at_;
        else error(tokens_[opening].line, "the '(' of #remove is never closed");
    }
    else if (sameLine(d.line) && peek().isText()) names.push_back(tokens_[at_++]);
    else error(d.line, "#remove is not followed by a keyword or a list of keywords");
    if (!atEnd() && sameLine(d.line) && peek().is(';')) ++at_;

    for (const auto& name : names) try
        {
            const KeywordPattern pattern(name.kind == Kind::string ? name.text : "");
            scope.removeIf([&](const DictionaryEntry& e)
                           { return e.keyword == name.text || (name.kind == Kind::string && pattern.matches(e.keyword)); });
        }
        catch (const PatternError& e)
        {
            error(name.line, fmt::format("\"{}\" {}", beginning(name.text), e.what()));
        }
}

std::vector<Token> DictionaryParser::restOfLine(Dictionary::Node& scope, int line)
{
    std::vector<Token> tokens;
    while (sameLine(line) && !(peek().kind == Kind::directive && peek().text != "eval"))
    {
        const Token& t = tokens_[at_++];
        if (t.kind == Kind::variable)
            for (auto& expanded : expand(scope, t)) tokens.push_back(std::move(expanded));
        else if (t.kind == Kind::directive)
            for (auto& result : eval(scope, t)) tokens.push_back(std::move(result));
        else tokens.push_back(t);
    }
    return tokens;
}

bool DictionaryParser::condition(Dictionary::Node& scope, const Token& d)
{
    const auto before = context_.diagnostics->errors();
    const auto values = restOfLine(scope, d.line);
    if (context_.diagnostics->errors() > before) return false; // a macro or an #eval of it was reported
    if (d.text == "ifeq")
    {
        if (values.size() != 2)
        {
            error(d.line, fmt::format("#ifeq compares 2 values, found {} on its line", values.size()));
            return false;
        }
        const auto &a = values[0], &b = values[1];
        if (a.kind == Kind::number && b.kind == Kind::number) return *toNumber(a.text) == *toNumber(b.text);
        return a.text == b.text && (a.kind == b.kind || (a.isText() && b.isText()));
    }
    if (values.size() == 1)
    {
        if (const auto yes = toSwitch(values[0].text)) return *yes;
        if (values[0].kind == Kind::number) return *toNumber(values[0].text) != 0;
    }
    std::string found;
    for (const auto& v : values) found += (found.empty() ? "" : " ") + toString(v);
    error(d.line,
          fmt::format("#{} needs a number or yes/no, found \"{}\"; comparisons are written #{} #eval{{ ... }}", d.text, found, d.text));
    return false;
}

void DictionaryParser::openBranch(Dictionary::Node& scope, const Token& d)
{
    const bool holds = condition(scope, d);
    branches_.push_back({d.text, d.line});
    if (!holds) skipBranch(scope, true);
}

/// Met while a branch is read, so the branches that follow are not.
void DictionaryParser::endOrElse(Dictionary::Node& scope, const Token& d)
{
    if (branches_.empty())
    {
        error(d.line, fmt::format("#{} without an #if or #ifeq before it", d.text));
        while (sameLine(d.line)) ++at_;
        return;
    }
    if (d.text == "endif")
    {
        branches_.pop_back();
        return;
    }
    auto& branch = branches_.back();
    if (branch.elseSeen) error(d.line, fmt::format("#{} after the #else of the #{} in line {}", d.text, branch.directive, branch.line));
    branch.elseSeen = true;
    skipBranch(scope, false);
}

/// An entry that a macro of the branch not taken names is no misspelt one.
void DictionaryParser::markMentioned(Dictionary::Node& scope, const Token& t) const
{
    if (t.kind == Kind::variable)
        if (auto* mentioned = scope.findScoped(t.text)) mentioned->used = true;
    if (t.kind == Kind::verbatim || t.kind == Kind::string)
        for (auto dollar = t.text.find('$'); dollar != t.text.npos; dollar = t.text.find('$', dollar + 1))
        {
            const auto begin = t.text.find_first_not_of("${", dollar);
            const auto end = begin == t.text.npos ? begin : t.text.find_first_of(" \t\n+-*/%^()<>=!&|?,}$", begin);
            if (begin == t.text.npos) break;
            if (auto* mentioned = scope.findScoped(t.text.substr(begin, end - begin))) mentioned->used = true;
        }
}

void DictionaryParser::skipBranch(Dictionary::Node& scope, bool seekElse)
{
    for (int depth = 0; !atEnd();)
    {
        const Token& t = tokens_[at_++];
        markMentioned(scope, t);
        if (t.kind != Kind::directive) continue;
        if (t.text == "if" || t.text == "ifeq") ++depth;
        else if (t.text == "endif" && depth-- == 0)
        {
            branches_.pop_back();
            return;
        }
        else if (depth == 0 && seekElse && t.text == "else")
        {
            branches_.back().elseSeen = true;
            return;
        }
        else if (depth == 0 && seekElse && t.text == "elif" && condition(scope, t)) return;
    }
}

}
