/// Reader that turns the tokens of a value into numbers, words, vectors and lists, in each form in which OpenFOAM writes them.
#pragma once
#include "dictionary/Token.hpp"
#include <stdexcept>

namespace sph
{

/// Message about a wrong value, to follow its keyword: "must be a number, found "abc"".
struct ValueError : std::runtime_error
{
    using runtime_error::runtime_error;
};

class TokenReader
{
    std::span<const Token> tokens_;
    std::size_t at_ = 0;

public:
    explicit TokenReader(std::span<const Token> tokens) : tokens_(tokens) {}

    bool atEnd() const { return at_ == tokens_.size(); }
    bool sees(char c, std::size_t ahead = 0) const { return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].is(c); }
    bool sees(Token::Kind kind, std::size_t ahead = 0) const { return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].kind == kind; }
    bool accept(char c);
    bool accept(const char* word);
    const Token& take(const char* expected);
    /// Text of all remaining tokens, as written.
    std::string rest() const;
    /// `[..]`, behind a name that repeats the keyword or not, if there is one.
    std::optional<DimensionSet> dimensions();
    /// Throws where tokens are left over.
    void finish() const;

    void read(double&);
    void read(int&);
    void read(bool&);
    void read(std::string&);
    void read(Vector<3>&);

    /// `(a b)`, `2(a b)`, `2{a}`, and any of them behind `List<type>` or `nonuniform`.
    template<class T> void read(std::vector<T>& list)
    {
        accept("nonuniform");
        const auto count = listHead();
        const char* const what = "a list \"( ... )\"";
        const bool uniform = count >= 0 && accept('{');
        if (!uniform && !accept('(')) failAt(what);
        const auto element = [&]
        {
            T value{};
            read(value);
            return value;
        };
        list.clear();
        if (uniform)
        {
            list.assign(std::size_t(count), element());
            if (!accept('}')) failAt("'}' behind one value");
            return;
        }
        while (!accept(')')) list.push_back(element());
        if (count >= 0 && std::size_t(count) != list.size()) failCount(count, list.size());
    }

private:
    [[noreturn]] void failAt(const char* expected) const;
    [[noreturn]] static void failCount(long announced, std::size_t found);
    /// Skips "List<type>" and the number of values; -1 where none is given.
    long listHead();
};

}
