#include "base/words.hpp"
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>

namespace sph
{

namespace
{

std::string lower(std::string word)
{
    for (auto& c : word) c = char(std::tolower(static_cast<unsigned char>(c)));
    return word;
}

}

int distance(const std::string& a, const std::string& b)
{
    std::vector<int> beforeLast, last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        row[0] = int(i);
        for (std::size_t k = 1; k <= b.size(); ++k)
        {
            row[k] = std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + (a[i - 1] != b[k - 1])});
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1]) row[k] = std::min(row[k], beforeLast[k - 2] + 1);
        }
        beforeLast = last;
        last = row;
    }
    return last.back();
}

/// A third of the letters may be wrong, three at most: of two short words ("dx", "dt") neither is a slip of the other. A word
/// that is the beginning of one known word alone ("cubic" of "cubicSpline") means that one.
std::string nearest(const std::string& word, std::span<const std::string> known)
{
    const std::string* best = nullptr;
    const auto meant = lower(word);
    int least = std::min(3, int(word.size()) / 3) + 1;
    const auto near = [&](const std::string& k) { return std::abs(long(k.size()) - long(word.size())) < least; }; // the distance is no less
    for (const auto& k : known)
        if (const int d = near(k) ? distance(meant, lower(k)) : least; d < least)
        {
            least = d;
            best = &k;
        }
    if (best) return *best;

    int begins = 0;
    for (const auto& k : known)
        if (word.size() > 2 && lower(k).starts_with(meant))
        {
            ++begins;
            best = &k;
        }
    return begins == 1 ? *best : "";
}

std::string list(std::span<const std::string> words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::string beginning(const std::string& text)
{
    constexpr std::size_t longest = 60;
    return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

std::string suggestion(const std::string& word, const std::string& things, std::span<const std::string> known)
{
    const auto meant = nearest(word, known);
    const auto question = meant.empty() ? std::string() : fmt::format("Did you mean \"{}\"? ", meant);
    return known.empty() ? fmt::format("There are no {}.", things) : fmt::format("{}Known {}: {}.", question, things, list(known));
}

}
