#include "dictionary/KeywordPattern.hpp"
#include "dictionary/limits.hpp"
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// Characters with the repetitions {n} and {n,m} written out, those within one another multiplied; a bound from above.
double writtenOut(const std::string& expression)
{
    double times = 1;
    for (auto open = expression.find('{'); open != expression.npos; open = expression.find('{', open + 1))
    {
        double most = 1;
        for (auto at = open + 1; at < expression.size() && expression[at] != '}'; ++at)
            if (at == open + 1 || expression[at - 1] == ',') most = std::max(most, std::strtod(expression.c_str() + at, nullptr));
        times *= most;
    }
    return double(expression.size()) * times;
}
}

KeywordPattern::KeywordPattern(const std::string& expression)
{
    if (writtenOut(expression) > double(limit::pattern))
        throw PatternError(
            fmt::format("is too long for a regular expression: at most {} characters, repetitions written out", limit::pattern));
    try
    {
        // The search of libstdc++ that follows all branches at once: the usual one takes a time exponential in the length of the word for
        // expressions such as (a|aa)+b. It has no back-references.
        expression_.assign(expression, std::regex::extended | std::regex_constants::__polynomial);
    }
    catch (const std::regex_error&)
    {
        throw PatternError("is not a valid regular expression");
    }
}

bool KeywordPattern::matches(const std::string& keyword) const
{
    return keyword.size() <= limit::pattern && std::regex_match(keyword, expression_);
}

}
