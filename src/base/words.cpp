#include "words.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>
#include <utility>

namespace sph
{

int distance(const std::string& a, const std::string& b)
{
    std::vector<int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        int diagonal = std::exchange(row[0], int(i));
        for (std::size_t k = 1; k <= b.size(); ++k)
            diagonal = std::exchange(row[k], std::min({row[k] + 1, row[k - 1] + 1, diagonal + (a[i - 1] != b[k - 1])}));
    }
    return row.back();
}

std::string nearest(const std::string& word, std::span<const std::string> known)
{
    const std::string* best = nullptr;
    int least = std::max(1, std::min(3, int(word.size())/2)) + 1;
    for (const auto& k : known)
        if (const int d = distance(word, k); d < least) { least = d; best = &k; }
    return best ? *best : "";
}

std::string list(std::span<const std::string> words)
{
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string suggestion(const std::string& word, const std::string& things, std::span<const std::string> known)
{
    const auto meant = nearest(word, known);
    const auto question = meant.empty() ? std::string() : fmt::format("Did you mean \"{}\"? ", meant);
    return known.empty() ? fmt::format("There are no {}.", things) : fmt::format("{}Known {}: {}.", question, things, list(known));
}

}
