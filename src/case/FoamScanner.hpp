/// Tokens of a file in OpenFOAM's syntax, read in place, and the raw bytes of its binary lists.
#pragma once
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sph
{

/// Error that stops the reading of a file, and its line (0 in binary data, which has none).
struct ScanError : std::runtime_error
{
    int line;
    ScanError(int line_, const std::string& what) : runtime_error(what), line(line_) {}
};

class FoamScanner
{
    const char *begin_, *at_, *end_;
    bool inBinary_ = false;

    bool endsAt(const char* at) const { return at == end_ || isBlank(*at) || *at == '/' || std::strchr("(){}", *at); }
    static bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    void skipComment();

public:
    explicit FoamScanner(std::string_view text) : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {}

    /// Treats bytes from here on as data: line ends in them mean nothing.
    void enterBinary() { inBinary_ = true; }

    std::size_t remaining() const { return std::size_t(end_ - at_); }
    bool atEnd() const { return at_ == end_; }
    const char* here() const { return at_; }
    /// Counted only when asked for, which is when something is wrong: newlines cost nothing while all is well.
    int line() const;
    [[noreturn]] void fail(const std::string& what) const { throw ScanError(line(), what); }

    /// White space and comments; a NUL is neither: it is data, or what a crash has left of a file.
    void skip()
    {
        while (at_ != end_ && (isBlank(*at_) || *at_ == '/'))
        {
            if (*at_ != '/') ++at_;
            else if (at_ + 1 != end_ && (at_[1] == '/' || at_[1] == '*')) skipComment();
            else return;
        }
    }
    /// The next character after white space, '\0' at the end.
    char peek()
    {
        skip();
        return at_ == end_ ? '\0' : *at_;
    }
    /// Takes that character if it comes next.
    bool take(char c)
    {
        if (peek() != c || at_ == end_) return false;
        ++at_;
        return true;
    }
    /// Takes that character where nothing may stand before it, as behind binary data.
    bool takeHere(char c)
    {
        if (at_ == end_ || *at_ != c) return false;
        ++at_;
        return true;
    }
    /// Text at the present place, shortened and quoted for a message; "the end of the file" where there is none.
    std::string found();

    /// Up to white space or one of `; { } ( )`, parentheses within a word being part of it; or a quoted string without its quotes.
    std::string word();
    /// False, and nothing taken, where no number stands here, up to white space or a bracket: "1-2" is none, and no two either. May give NaN or
    /// infinity.
    bool number(double&);
    bool integer(std::int64_t&);

    /// Over bytes that are there.
    void advance(std::size_t bytes) { at_ += bytes; }
    template<class T> T raw()
    {
        T value;
        std::memcpy(&value, at_, sizeof(T));
        at_ += sizeof(T);
        return value;
    }
};

}
