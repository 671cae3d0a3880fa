#include "dictionary/Tokeniser.hpp"
#include "dictionary/limits.hpp"
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <string_view>

namespace sph
{

std::optional<double> toNumber(std::string_view text)
{
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto first = text.find_first_not_of('-');
    if (first == text.npos || first > 1 || !(std::isdigit(static_cast<unsigned char>(text[first])) || text[first] == '.')) return {};
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range)
        return text.find("e-") != text.npos || text.find("E-") != text.npos ? 0 : std::numeric_limits<double>::infinity();
    return value;
}

std::string toString(const Token& token)
{
    switch (token.kind)
    {
    case Token::Kind::string:
    {
        std::string escaped;
        for (const char c : token.text)
        {
            if (c == '"' || c == '\n') escaped += '\\';
            escaped += c;
        }
        return fmt::format("\"{}\"", escaped);
    }
    case Token::Kind::verbatim:
        return fmt::format("#{{{}#}}", token.text);
    case Token::Kind::dimensions:
        return fmt::format("[{}]", token.text);
    case Token::Kind::variable:
        return fmt::format("${}", token.text);
    case Token::Kind::directive:
        return fmt::format("#{}", token.text);
    default:
        return token.text;
    }
}

namespace
{

class Tokeniser
{
    const std::string& text_;
    const std::string& file_;
    Diagnostics& diagnostics_;
    std::size_t at_ = 0, lineBegin_ = 0;
    int line_ = 1, lastTokenLine_ = 0;
    std::vector<Token> tokens_;

public:
    Tokeniser(const std::string& text, const std::string& file, Diagnostics& d) : text_(text), file_(file), diagnostics_(d)
    {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = lineBegin_ = 3;
    }

    std::vector<Token> run()
    {
        const auto most = diagnostics_.errors() + limit::mistakes;
        while (skipBlanks() && tokens_.size() <= limit::words && diagnostics_.errors() < most) next();
        if (diagnostics_.errors() >= most)
            error(line_, fmt::format("{} mistakes until here: nothing behind this is read", limit::mistakes));
        return std::move(tokens_);
    }

private:
    char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
    bool atEnd() const { return at_ >= text_.size(); }
    bool sees(std::string_view s) const { return text_.compare(at_, s.size(), s) == 0; }

    char take()
    {
        const char c = text_[at_++];
        if (c == '\n')
        {
            ++line_;
            lineBegin_ = at_;
        }
        return c;
    }
    void take(std::size_t n)
    {
        while (n-- > 0) take();
    }
    void error(int line, std::string what) { diagnostics_.error({file_, line}, std::move(what)); }

    /// Blanks and comments. False at the end of the text.
    bool skipBlanks()
    {
        while (!atEnd())
        {
            if (std::isspace(static_cast<unsigned char>(peek()))) take();
            else if (sees("//"))
                while (!atEnd() && peek() != '\n') take();
            else if (sees("/*"))
            {
                const int opened = line_;
                const auto close = text_.find("*/", at_ + 2);
                if (close == text_.npos) error(opened, "this comment is never closed by */");
                take((close == text_.npos ? text_.size() : close + 2) - at_);
            }
            else return true;
        }
        return false;
    }

    Token& begin(Token::Kind kind)
    {
        Token t{.kind = kind, .text = "", .line = line_, .column = int(at_ - lineBegin_) + 1, .begin = at_};
        t.firstOnLine = line_ > lastTokenLine_;
        tokens_.push_back(std::move(t));
        return tokens_.back();
    }
    void finish()
    {
        tokens_.back().lastLine = lastTokenLine_ = line_;
        tokens_.back().end = at_;
    }

    void next()
    {
        const char c = peek();
        const bool digitFollows = std::isdigit(static_cast<unsigned char>(peek(1))) || peek(1) == '.';
        if (c == '"') readString();
        else if (sees("#{")) readVerbatim();
        else if (c == '#') readDirective();
        else if (c == '$') readVariable();
        else if (c == '[') readDimensions();
        else if (std::isdigit(static_cast<unsigned char>(c)) || ((c == '-' || c == '+' || c == '.') && digitFollows)) readNumber();
        else if (std::string_view(";{}(),/=]").find(c) != std::string_view::npos) readPunctuation();
        else readWord();
        finish();
    }

    void readPunctuation()
    {
        begin(Token::Kind::punctuation).text = peek();
        take();
        if (tokens_.back().text != "]") return;
        error(line_, "']' closes nothing: there is no open '['");
        tokens_.back().text = ",";
    }

    void readString()
    {
        auto& t = begin(Token::Kind::string);
        take();
        while (!atEnd() && peek() != '"' && peek() != '\n')
        {
            if (sees("\\\"") || sees("\\\n")) take();
            else if (sees("\\\r\n")) take(2);
            else if (sees("\\\\")) t.text += take();
            t.text += take();
        }
        if (peek() == '"' && !atEnd())
        {
            take();
            return;
        }
        error(t.line, "this string is not closed by '\"' on its line");
        // A ';' at the end of the line was most likely meant to close the entry.
        const auto last = t.text.find_last_not_of(" \t\r");
        if (last != t.text.npos && t.text[last] == ';')
        {
            while (text_[at_ - 1] != ';') --at_;
            --at_;
            t.text.resize(last);
        }
    }

    void readVerbatim()
    {
        auto& t = begin(Token::Kind::verbatim);
        const auto close = text_.find("#}", at_ + 2);
        if (close == text_.npos) error(t.line, "\"#{\" is never closed by \"#}\"");
        const auto end = close == text_.npos ? text_.size() : close;
        t.text = text_.substr(at_ + 2, end - at_ - 2);
        take((close == text_.npos ? end : end + 2) - at_);
    }

    void readDirective()
    {
        auto& t = begin(Token::Kind::directive);
        take();
        while (std::isalnum(static_cast<unsigned char>(peek())) && !atEnd()) t.text += take();
        if (t.text != "eval") return;
        finish();
        if (skipBlanks() && peek() == '{') readBraced();
    }

    /// { text } as it stands, braces inside balanced.
    void readBraced()
    {
        auto& t = begin(Token::Kind::verbatim);
        int depth = 0;
        std::size_t end = at_;
        for (; end < text_.size() && text_[end] != ';'; ++end)
        {
            depth += text_[end] == '{' ? 1 : text_[end] == '}' ? -1 : 0;
            if (depth == 0) break;
        }
        const bool closed = end < text_.size() && text_[end] == '}';
        if (!closed) error(t.line, "the '{' of #eval is never closed");
        t.text = text_.substr(at_ + 1, end - at_ - 1);
        take((closed ? end + 1 : end) - at_);
    }

    void readVariable()
    {
        auto& t = begin(Token::Kind::variable);
        take();
        if (peek() == '{')
        {
            while (!atEnd() && peek() != '}' && peek() != '\n') t.text += take();
            t.text.erase(0, 1);
            if (peek() != '}' || atEnd())
            {
                error(t.line, "\"${\" is not closed by '}' on its line");
                return;
            }
            take();
        }
        else
        {
            t.text = wordHere();
            while (peek() == '/' && (t.text.empty() || t.text[0] == '/')) // $/top/entry
            {
                t.text += take();
                t.text += wordHere();
            }
        }
        if (t.text.empty()) error(t.line, "'$' is not followed by a name");
        const bool goesOn = isWordCharacter(peek()) && peek() != '(' && peek() != ')' && peek() != ',';
        if (t.text.find('$') != t.text.npos || goesOn)
        {
            wordHere();
            const auto whole = text_.substr(t.begin, at_ - t.begin);
            error(t.line, fmt::format("\"{}\": a macro must stand alone, it is not replaced inside a word", whole));
        }
    }

    void readDimensions()
    {
        auto& t = begin(Token::Kind::dimensions);
        take();
        while (!atEnd() && peek() != ']' && peek() != ';' && peek() != '\n') t.text += take();
        if (peek() == ']' && !atEnd()) take();
        else error(t.line, "'[' is not closed by ']' on its line");
    }

    /// "3(1 2 3)" and "5{0.5}" are a number and a list; "2D" is a word.
    void readNumber()
    {
        auto& t = begin(Token::Kind::number);
        while (isWordCharacter(peek()) && peek() != '(' && peek() != ')' && peek() != ',') t.text += take();
        if (!toNumber(t.text)) t.kind = Token::Kind::word;
    }

    void readWord()
    {
        auto& t = begin(Token::Kind::word);
        t.text = wordHere();
        if (t.text.empty()) t.text = take();
        if (t.text.find('$') != t.text.npos)
            error(t.line, fmt::format("\"{}\": a macro must stand alone, it is not replaced inside a word", t.text));
    }

    bool isWordCharacter(char c) const
    {
        return c != '\0' && !std::isspace(static_cast<unsigned char>(c)) && std::string_view("\"'/;{}[]").find(c) == std::string_view::npos;
    }

    /// A word may hold balanced parentheses, "div(phi,U)", and ends before one that closes a list.
    std::string wordHere()
    {
        std::size_t end = at_, opened = 0;
        int depth = 0;
        for (; end < text_.size() && isWordCharacter(text_[end]); ++end)
        {
            if (text_[end] == '(' && depth++ == 0) opened = end;
            if (text_[end] == ')' && --depth < 0) break;
            if (text_[end] == ',' && depth == 0) break;
        }
        if (depth > 0)
        {
            error(line_, fmt::format("'(' is not closed in the word \"{}\": is a blank missing before '('?", text_.substr(at_, end - at_)));
            end = opened;
        }
        const auto word = text_.substr(at_, end - at_);
        at_ = end;
        return word;
    }
};

}

std::vector<Token> tokenise(const std::string& text, const std::string& file, Diagnostics& diagnostics)
{
    return Tokeniser(text, file, diagnostics).run();
}

}
