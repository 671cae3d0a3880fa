#include "dictionary/DictionaryParser.hpp"
#include "base/words.hpp"
#include "dictionary/Tokeniser.hpp"
#include "dictionary/limits.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sph
{

using Kind = Token::Kind;

DictionaryParser::DictionaryParser(Context& context, const std::string& text, std::string file, std::filesystem::path folder)
    : context_(context),
      file_(std::move(file)),
      folder_(std::move(folder)),
      tokens_(tokenise(text, file_, *context.diagnostics)),
      textSize_(text.size()),
      mostErrors_(context.diagnostics->errors() + limit::mistakes)
{}

void DictionaryParser::error(int line, std::string what)
{
    if (context_.stopped) return;
    context_.diagnostics->error({file_, line}, std::move(what));
    if (context_.diagnostics->errors() >= mostErrors_) stop(line, fmt::format("{} mistakes until here", limit::mistakes));
}

void DictionaryParser::stop(int line, const std::string& why)
{
    if (!std::exchange(context_.stopped, true)) context_.diagnostics->error({file_, line}, why + ": nothing behind this is read");
}

bool DictionaryParser::fits(int line, const Dictionary::Node::Extent& more)
{
    context_.words += more.words;
    if (context_.words > limit::words)
        stop(line, fmt::format("more than {} words, with what macros and included files bring in", limit::words));
    else if (context_.nesting + more.levels > limit::nesting)
        stop(line, fmt::format("dictionaries nest deeper than {} levels", limit::nesting));
    return !context_.stopped;
}

void DictionaryParser::parse(Dictionary::Node& into)
{
    top_ = &into;
    if (fits(1, {tokens_.size(), 1})) entries(into, nullptr);
    if (context_.open.size() <= 1) into.end = textSize_;
    for (const auto& branch : branches_) error(branch.line, fmt::format("#{} is never ended by #endif", branch.directive));
}

void DictionaryParser::entries(Dictionary::Node& scope, const Token* opening)
{
    ++context_.nesting;
    while (!atEnd() && !context_.stopped)
    {
        const Token& t = tokens_[at_++];
        if (t.is(';')) continue;
        if (t.is('}'))
        {
            if (opening)
            {
                scope.end = t.begin;
                checkBraces(scope, *opening, t);
                --context_.nesting;
                return;
            }
            error(t.line, "'}' closes nothing: there is no open '{'");
        }
        else if (t.kind == Kind::directive) directive(scope, t);
        else if (t.kind == Kind::variable) mergeMacro(scope, t);
        else if (t.isText()) entry(scope, t, context_.mode);
        else
        {
            error(t.line, fmt::format("expected a keyword, found \"{}\"", toString(t)));
            --at_;
            skipToNextEntry();
        }
    }
    --context_.nesting;
    if (!opening) return;
    scope.end = textSize_;
    if (suspect_) error(suspectLine_, *suspect_);
    else error(opening->line, fmt::format("the '{{' of \"{}\" is never closed", scope.keyword));
}

void DictionaryParser::checkBraces(const Dictionary::Node& scope, const Token& opening, const Token& closing)
{
    if (suspect_ || !opening.firstOnLine || !closing.firstOnLine || opening.column == closing.column) return;
    suspect_ =
        fmt::format("the '{{' of \"{}\" is never closed, to judge by the indentation of the '}}' in line {}", scope.keyword, closing.line);
    suspectLine_ = opening.line;
}

void DictionaryParser::entry(Dictionary::Node& scope, const Token& keyword, InputMode mode)
{
    DictionaryEntry e{.keyword = keyword.text, .where = {file_, keyword.line}, .value = {}};
    e.included = context_.open.size() > 1;
    if (keyword.kind == Kind::string)
    {
        try
        {
            e.pattern = std::make_shared<KeywordPattern>(keyword.text);
        }
        catch (const PatternError& what)
        {
            error(keyword.line, fmt::format("\"{}\" {}", beginning(keyword.text), what.what()));
        }
    }
    if (!atEnd() && peek().is('{'))
    {
        if (isOthersHeader(scope, keyword)) skipBlock();
        else subDictionary(scope, std::move(e), mode);
        return;
    }
    value(scope, e, keyword);
    scope.add(std::move(e), mode);
}

bool DictionaryParser::isOthersHeader(const Dictionary::Node& scope, const Token& keyword) const
{
    return context_.open.size() > 1 && &scope == top_ && keyword.text == "FoamFile";
}

void DictionaryParser::subDictionary(Dictionary::Node& scope, DictionaryEntry e, InputMode mode)
{
    const Token& opening = tokens_[at_++];
    e.dictionary = scope.child(e.keyword, e.where);
    if (fits(opening.line, {0, 1})) entries(*e.dictionary, &opening);
    e.begin = opening.begin;
    e.end = std::min(e.dictionary->end + 1, textSize_);
    scope.add(std::move(e), mode);
}

void DictionaryParser::value(Dictionary::Node& scope, DictionaryEntry& e, const Token& keyword)
{
    std::vector<std::size_t> open;
    std::size_t unnamed = 0;
    const auto begin = at_;
    const auto finish = [&]
    {
        e.begin = at_ > begin ? tokens_[begin].begin : keyword.end;
        e.end = at_ > begin ? tokens_[at_ - 1].end : keyword.end;
    };
    for (;;)
    {
        if (context_.stopped) return finish();
        if (open.empty() ? atEnd() || semicolonMissing(keyword, at_ > begin) : false)
        {
            error(tokens_[at_ - 1].lastLine, fmt::format("entry \"{}\" is not closed by ';'", e.keyword));
            finish();
            return;
        }
        const bool blockEnds = !atEnd() && peek().is('}') && peek().firstOnLine && !open.empty() && tokens_[open.back()].is('(');
        if (atEnd() || blockEnds || (peek().is(';') && !open.empty()))
        {
            finish();
            listNotClosed(keyword, tokens_[open.back()]);
            return;
        }
        const Token& t = peek();
        if (t.is(';') && open.empty())
        {
            finish();
            ++at_;
            return;
        }
        if (t.is('{') && tokens_[at_ - 1].kind != Kind::number && (!open.empty() || (at_ > begin && blockClosesValue())))
        {
            listedDictionary(scope, e, unnamed);
            continue;
        }
        if (t.is('{') && open.empty() && (at_ == begin || tokens_[at_ - 1].kind != Kind::number))
        {
            error(t.line, fmt::format("'{{' is not expected in the value of \"{}\": a ';' is missing before it, or the name of a "
                                      "dictionary has a blank",
                                      e.keyword));
            skipBlock();
            finish();
            return;
        }
        ++at_;
        if (t.kind == Kind::variable)
        {
            for (auto& expanded : expand(scope, t)) e.value.push_back(std::move(expanded));
            continue;
        }
        if (t.kind == Kind::directive)
        {
            for (auto& result : eval(scope, t)) e.value.push_back(std::move(result));
            continue;
        }
        if (t.is('=') && at_ == begin + 1)
        {
            error(t.line, fmt::format("\"{}\": an entry is written without '='", e.keyword));
            continue;
        }
        if (t.is('(') || t.is('{')) open.push_back(at_ - 1);
        if (t.is(')') || t.is('}'))
        {
            const char opening = t.is(')') ? '(' : '{';
            if (open.empty() || !tokens_[open.back()].is(opening))
            {
                error(t.line, fmt::format("'{}' closes nothing: there is no open '{}' in the value of \"{}\"", t.text, opening, e.keyword));
                continue;
            }
            open.pop_back();
        }
        e.value.push_back(t);
    }
}

/// Whether the value ended with the token before, although no ';' was written: the next token begins a line (or closes the
/// block) and reads like the next entry. Values may go on over several lines, so a word that is indented further than its
/// keyword continues a value that ends in a word; it cannot continue a number, a string or a list.
bool DictionaryParser::semicolonMissing(const Token& keyword, bool hasValue) const
{
    const Token& t = peek();
    if (t.is('}')) return true;
    if (!t.firstOnLine) return false;
    if (t.kind == Kind::directive) return t.text != "eval" && t.text != "calc" && t.text != "codeStream";

    const bool outdented = t.column <= keyword.column;
    if (t.kind == Kind::variable) return hasValue && outdented;
    if (!t.isText() || at_ + 1 >= tokens_.size()) return false;
    const Token& next = tokens_[at_ + 1];
    if (next.is('{')) return true;
    if (t.text.starts_with("List<") || t.text == "uniform" || t.text == "nonuniform") return false;
    if (next.firstOnLine || next.is(';') || next.is('}')) return false;
    const bool complete = hasValue && tokens_[at_ - 1].kind != Kind::word;
    return outdented || (complete && t.kind == Kind::word);
}

void DictionaryParser::listedDictionary(Dictionary::Node& scope, DictionaryEntry& e, std::size_t& unnamed)
{
    const Token& opening = tokens_[at_++];
    const bool named = tokens_[at_ - 2].isText() && !e.value.empty();
    const auto name = named ? e.value.back().text : std::to_string(unnamed++);
    const auto written = named ? toString(e.value.back()) : "";
    if (named) e.value.pop_back();
    Token t{.kind = Kind::dictionary, .text = written, .line = opening.line, .lastLine = opening.line};
    t.dictionary = scope.child(e.keyword + "." + name, {file_, named ? tokens_[at_ - 2].line : opening.line});
    t.dictionary->keyword = name;
    if (fits(opening.line, {0, 1})) entries(*t.dictionary, &opening);
    e.value.push_back(std::move(t));
}

/// Coefficients of a scheme may stand in its value: `div(phi,Y) Gauss multivariate { U upwind; };`. The ';' behind the block
/// tells them from a dictionary whose name has a blank.
bool DictionaryParser::blockClosesValue() const
{
    int depth = 0;
    for (auto i = at_; i < tokens_.size(); ++i)
    {
        depth += tokens_[i].is('{') ? 1 : tokens_[i].is('}') ? -1 : 0;
        if (depth == 0) return i + 1 < tokens_.size() && tokens_[i + 1].is(';');
    }
    return false;
}

/// Goes on at the first line behind the opening bracket that begins, no further in than the keyword, with a word; else behind
/// the ';'.
void DictionaryParser::listNotClosed(const Token& keyword, const Token& opening)
{
    error(opening.line, fmt::format("the '{}' of \"{}\" is never closed", opening.text, keyword.text));
    const auto begin = std::size_t(&opening - tokens_.data()) + 1;
    for (auto i = begin; i < at_; ++i)
        if (tokens_[i].firstOnLine && tokens_[i].kind == Kind::word && tokens_[i].column <= keyword.column)
        {
            at_ = i;
            return;
        }
    if (!atEnd() && peek().is(';')) ++at_;
}

/// Skips a block, from a '{' to behind the '}' that closes it.
void DictionaryParser::skipBlock()
{
    for (int depth = 0; !atEnd();)
    {
        const Token& t = tokens_[at_++];
        depth += t.is('{') ? 1 : t.is('}') ? -1 : 0;
        if (depth == 0) return;
    }
}

/// Skips to behind the next ';', or before a '}', a block, a directive, or a word that begins a line.
void DictionaryParser::skipToNextEntry()
{
    for (bool first = true; !atEnd(); first = false)
    {
        const Token& t = peek();
        if (t.is('}') || t.kind == Kind::directive || (!first && t.firstOnLine && t.isText())) return;
        if (t.is('{'))
        {
            skipBlock();
            return;
        }
        ++at_;
        if (t.is(';')) return;
    }
}

}
