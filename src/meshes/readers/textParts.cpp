#include "meshes/readers/textParts.hpp"
#include "dictionary/Tokeniser.hpp"
#include "meshes/readers/NumberedMesh.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{

constexpr auto blanks = " \t\r\n\v\f";

}

TextLines::TextLines(std::string_view text, std::size_t before) : rest_(text), number_(before)
{
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) throw UnusableMesh("it is text in UTF-16: save it in UTF-8 or ASCII");
    if (text.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool TextLines::next(std::string_view& line)
{
    if (rest_.empty()) return false;
    const auto end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1), rest_.size()));
    ++number_;
    return true;
}

void TextLines::fail(const std::string& what) const { throw UnusableMesh(fmt::format("line {}: {}", number_, what)); }

std::string_view nextWord(std::string_view& line)
{
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const auto word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

std::string_view trimmed(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool isWord(std::string_view word, std::string_view lowerCase)
{
    return std::equal(word.begin(), word.end(), lowerCase.begin(), lowerCase.end(),
                      [](char c, char lower) { return (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) == lower; });
}

std::string quoted(std::string_view text)
{
    constexpr std::size_t most = 40;
    std::string shown(text.substr(0, most));
    for (auto& c : shown)
        if (c < ' ' || c > '~') c = '?';
    return '"' + shown + (text.size() > most ? "...\"" : "\"");
}

std::optional<double> toFinite(std::string_view word)
{
    const auto value = toNumber(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> toFiniteOrNan(std::string_view word)
{
    const auto magnitude = word.substr(word.starts_with('-') ? 1 : 0);
    return isWord(magnitude, "nan") || isWord(magnitude, "inf") ? std::numeric_limits<double>::quiet_NaN() : toFinite(word);
}

std::optional<std::int64_t> toWhole(std::string_view word)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

Vector<3> takePoint(const TextLines& lines, std::string_view& line)
{
    Vector<3> x;
    for (const auto c : {&Vector<3>::x, &Vector<3>::y, &Vector<3>::z})
    {
        const auto word = nextWord(line);
        const auto value = toFinite(word);
        if (!value && word.empty()) lines.fail("expected three coordinates, and the line ends");
        if (!value)
            lines.fail(fmt::format("the coordinate {} is no finite number{}", quoted(word),
                                   word.find(',') != word.npos ? ": decimals need a point" : ""));
        x.*c = *value;
    }
    return x;
}

void expectNumbers(const TextLines& lines, std::string_view line)
{
    for (auto word = nextWord(line); !word.empty(); word = nextWord(line))
        if (!toFinite(word)) lines.fail(fmt::format("expected nothing but numbers behind the coordinates, found {}", quoted(word)));
}

}
