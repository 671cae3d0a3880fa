/// Texts damaged at random, the same ones in each run, and how many a test reads.
///
/// SPH_FUZZ_MUTANTS sets the number for long runs, SPH_FUZZ_SEED the first seed: mutant k of seed s is mutant 0 of seed s + k, so that one that
/// fails is made again by its seed alone.
#pragma once
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace sph::test
{

inline long fuzzNumber(const char* variable, long usual)
{
    const char* text = std::getenv(variable);
    return text ? std::strtol(text, nullptr, 10) : usual;
}

class Mutator
{
    std::mt19937_64 random_;

public:
    explicit Mutator(std::uint64_t seed) : random_(seed) {}

    std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
    const std::string& oneOf(const std::vector<std::string>& texts) { return texts[below(texts.size())]; }

    /// One to four changes: single bytes and bits, pieces lost, doubled, moved or taken from `others`, words that readers stumble over, the end
    /// cut off, a piece repeated very often.
    std::string of(std::string text, const std::vector<std::string>& others)
    {
        for (auto changes = below(4) + 1; changes > 0; --changes) change(text, others);
        return text;
    }

private:
    void change(std::string& text, const std::vector<std::string>& others)
    {
        using namespace std::string_literals;
        static const auto special = "{}()[];\"$#/*\\\n :.,=<>-+eE0123456789\0\xff"s;
        static const std::vector<std::string> words{"nan",
                                                    "inf",
                                                    "-inf",
                                                    "1e999",
                                                    "1e-999",
                                                    "-0",
                                                    "0x10",
                                                    "2147483648",
                                                    "-2147483649",
                                                    "9223372036854775808",
                                                    "99999999999999999999",
                                                    "1e",
                                                    "--1",
                                                    "1.5.5",
                                                    "{",
                                                    "}",
                                                    "(",
                                                    ")",
                                                    ";",
                                                    "\"",
                                                    "/*",
                                                    "*/",
                                                    "//",
                                                    "#{",
                                                    "#}",
                                                    "$",
                                                    "$x",
                                                    "${",
                                                    "$..x",
                                                    "$:a.b",
                                                    "#eval{ 1/0 }",
                                                    "#eval{",
                                                    "#include \"constant/d\"",
                                                    "#include \"/dev/zero\"",
                                                    "#if 1",
                                                    "#ifeq a a",
                                                    "#else",
                                                    "#endif",
                                                    "#remove \".*\"",
                                                    "#inputMode error",
                                                    "uniform",
                                                    "nonuniform List<scalar>",
                                                    "3(1 2)",
                                                    "3{",
                                                    "[0 1 -2 0 0 0 0]",
                                                    "[m^2/s",
                                                    "\"(a|aa)+b\"",
                                                    "\".*\"",
                                                    "FoamFile",
                                                    "FoamFile { format binary; }",
                                                    "format binary;",
                                                    "class vectorField;",
                                                    "arch \"LSB;label=64;scalar=32\";",
                                                    "\r\n",
                                                    "\t",
                                                    "\xEF\xBB\xBF"};
        const auto at = below(text.size() + 1), length = std::min(below(30), text.size() - at);
        switch (below(11))
        {
        case 0:
            if (at < text.size()) text[at] = char(text[at] ^ (1 << below(8)));
            break;
        case 1:
            if (at < text.size()) text[at] = special[below(special.size())];
            break;
        case 2:
            text.insert(at, 1, special[below(special.size())]);
            break;
        case 3:
            text.erase(at, length);
            break;
        case 4:
            text.insert(at, text.substr(below(text.size() + 1), length));
            break;
        case 5:
            text.insert(at, oneOf(words));
            break;
        case 6:
            text.replace(at, length, oneOf(words));
            break;
        case 7:
        {
            const auto& other = oneOf(others);
            text.insert(at, other.substr(below(other.size() + 1), below(100)));
            break;
        }
        case 8:
            if (below(4) == 0) text.resize(at);
            else text.erase(at, 1);
            break;
        case 9: // a line doubled or lost
        {
            const auto begin = text.rfind('\n', at == 0 ? 0 : at - 1), end = text.find('\n', at);
            if (begin == text.npos || end == text.npos || end <= begin) break;
            if (below(2) == 0) text.erase(begin, end - begin);
            else text.insert(begin, text.substr(begin, end - begin));
            break;
        }
        default:
            if (below(20) == 0)
            {
                const auto piece = text.substr(at, length % 8 + 1);
                std::string often;
                for (auto n = below(20'000); n > 0; --n) often += piece;
                text.insert(at, often);
            }
        }
    }
};

/// `read(mutator, seed)` for so many seeds, each within ten seconds.
inline void fuzz(long usual, const auto& read)
{
    const long first = fuzzNumber("SPH_FUZZ_SEED", 1), mutants = fuzzNumber("SPH_FUZZ_MUTANTS", usual);
    for (long seed = first; seed < first + mutants; ++seed)
    {
        SCOPED_TRACE("SPH_FUZZ_SEED=" + std::to_string(seed));
        Mutator mutator(static_cast<std::uint64_t>(seed));
        const auto begin = std::chrono::steady_clock::now();
        read(mutator);
        ASSERT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
        if (::testing::Test::HasFailure()) return;
    }
}

}
