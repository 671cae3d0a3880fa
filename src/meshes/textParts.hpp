/// Lines and words of a text. For the sources of this module alone.
#pragma once
#include <algorithm>
#include <charconv>
#include <string_view>

namespace sph
{

/// Takes it from `rest`, without the end of the line.
inline std::string_view nextLine(std::string_view& rest)
{
    const auto end = rest.find('\n');
    const auto line = rest.substr(0, end);
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    return line;
}

/// Takes it from `line`, with the blanks before it; empty at the end.
inline std::string_view nextWord(std::string_view& line)
{
    constexpr auto blank = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(blank), line.size()));
    const auto word = line.substr(0, line.find_first_of(blank));
    line.remove_prefix(word.size());
    return word;
}

/// 0 where there is none.
inline std::size_t number(std::string_view word)
{
    std::size_t n = 0;
    std::from_chars(word.data(), word.data() + word.size(), n);
    return n;
}

}
