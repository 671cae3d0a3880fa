#include "base/words.hpp"
#include "dictionary/DictionaryParser.hpp"
#include "dictionary/Tokeniser.hpp"
#include "dictionary/expandPath.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

using Kind = Token::Kind;

namespace
{

Token numberToken(double value, const Token& at)
{
    Token t = at;
    t.kind = Kind::number;
    t.text = fmt::format("{}", value);
    return t;
}

Token punctuationToken(const char* text, const Token& at)
{
    Token t = at;
    t.kind = Kind::punctuation;
    t.text = text;
    return t;
}

}

void DictionaryParser::take(DictionaryEntry& entry, int line) const
{
    entry.used = true;
    if (entry.taken.empty() || entry.taken.back().line != line || entry.taken.back().file != file_) entry.taken.push_back({file_, line});
}

/// `$base;` among entries takes over those of another dictionary; what is written behind it overrides them.
void DictionaryParser::mergeMacro(Dictionary::Node& scope, const Token& variable)
{
    const bool alone = atEnd() || peek().is(';') || peek().is('}') || peek().firstOnLine || peek().kind == Kind::variable;
    auto* found = scope.findScoped(variable.text);
    if (!alone && !(found && found->dictionary))
    {
        error(variable.line, fmt::format("\"${}\": a macro cannot be a keyword", variable.text));
        skipToNextEntry();
        return;
    }
    if (!atEnd() && peek().is(';')) ++at_;
    if (!found) undefinedMacro(scope, variable);
    else if (!found->dictionary)
        error(variable.line, fmt::format("\"${}\" stands among entries, but \"{}\" is not a dictionary", variable.text, found->keyword));
    else
    {
        take(*found, variable.line);
        const auto base = found->dictionary; // the entry itself may move while entries are added
        if (fits(variable.line, base->extent())) scope.mergeCopies(*base);
    }
}

std::vector<Token> DictionaryParser::expand(Dictionary::Node& scope, const Token& variable)
{
    if (auto* found = scope.findScoped(variable.text))
    {
        take(*found, variable.line);
        if (!found->dictionary) return fits(variable.line, extentOf(found->value)) ? found->value : std::vector<Token>{};
        error(variable.line, fmt::format("\"${}\" is a dictionary and cannot be a value; its entries are taken over by {{ ${}; }}",
                                         variable.text, variable.text));
        return {};
    }
    if (const auto fromEnvironment = environmentVariable(variable.text, context_.caseFolder))
    {
        Token t = variable;
        t.text = *fromEnvironment;
        t.kind = toNumber(t.text) ? Kind::number : Kind::string;
        return {t};
    }
    undefinedMacro(scope, variable);
    return {};
}

std::optional<std::string> DictionaryParser::textOf(Dictionary::Node& scope, const std::string& name, int line) const
{
    auto* found = scope.findScoped(name);
    if (!found) return {};
    if (found->value.size() != 1) throw PathError(fmt::format("names ${}, which is not one word", name));
    take(*found, line);
    return found->value[0].text;
}

void DictionaryParser::undefinedMacro(Dictionary::Node& scope, const Token& variable)
{
    std::vector<std::string> known;
    for (auto* s = &scope; s; s = s->parent)
        for (const auto& e : s->entries)
            if (!e.pattern && e.keyword != "FoamFile") known.push_back(e.keyword);
    const auto meant = nearest(variable.text, known);
    error(variable.line, fmt::format("\"${}\" is neither an entry that is defined above nor an environment variable{}", variable.text,
                                     meant.empty() ? "" : fmt::format(". Did you mean \"${}\"?", meant)));
}

ExpressionValue DictionaryParser::macroValue(Dictionary::Node& scope, const std::string& name, int line) const
{
    auto* found = scope.findScoped(name);
    if (!found)
    {
        const auto text = environmentVariable(name, context_.caseFolder);
        if (const auto number = text ? toNumber(*text) : std::nullopt) return {*number};
        std::vector<std::string> known;
        for (auto* s = &scope; s; s = s->parent)
            for (const auto& e : s->entries) known.push_back(e.keyword);
        const auto meant = nearest(name, known);
        throw ExpressionError(
            fmt::format("\"${}\" is not defined above{}", name, meant.empty() ? "" : fmt::format(". Did you mean \"${}\"?", meant)));
    }
    take(*found, line);
    const auto& v = found->value;
    // "nu [0 2 -1 0 0 0 0] 1e-6" gives its number
    if (!v.empty() && v.back().kind == Kind::number && (v.size() == 1 || v[v.size() - 2].kind == Kind::dimensions))
        return {*toNumber(v.back().text)};
    if (v.size() == 5 && v[0].is('(') && v[4].is(')'))
    {
        const auto x = toNumber(v[1].text), y = toNumber(v[2].text), z = toNumber(v[3].text);
        if (x && y && z) return {0, Vector<3>{*x, *y, *z}};
    }
    if (v.size() == 1)
        if (const auto yes = toSwitch(v[0].text)) return {double(*yes)};
    throw ExpressionError(fmt::format("\"${}\" is neither a number nor a vector", name));
}

std::vector<Token> DictionaryParser::eval(Dictionary::Node& scope, const Token& directive)
{
    if (directive.text != "eval")
    {
        if (directive.text == "calc" || directive.text == "codeStream") unsupported(directive);
        else error(directive.line, fmt::format("#{} cannot stand inside a value", directive.text));
        return {};
    }
    if (atEnd() || (peek().kind != Kind::verbatim && peek().kind != Kind::string))
    {
        error(directive.line, "#eval is not followed by \"...\" or { ... }");
        return {};
    }
    const Token& text = tokens_[at_++];
    try
    {
        const auto result = evaluate(text.text, [&](const std::string& name) { return macroValue(scope, name, directive.line); });
        if (!result.vector) return {numberToken(result.scalar, directive)};
        const auto [x, y, z] = *result.vector;
        return {punctuationToken("(", directive), numberToken(x, directive), numberToken(y, directive), numberToken(z, directive),
                punctuationToken(")", directive)};
    }
    catch (const ExpressionError& e)
    {
        const auto first = text.text.find_first_not_of(" \t\n"), last = text.text.find_last_not_of(" \t\n");
        const auto shown = first == std::string::npos ? "" : text.text.substr(first, last - first + 1);
        error(directive.line, fmt::format("#eval \"{}\": {}", beginning(shown), e.what()));
        return {numberToken(1, directive)};
    }
}

}
