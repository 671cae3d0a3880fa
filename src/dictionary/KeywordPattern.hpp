/// A keyword in quotes: an extended regular expression that stands for all keywords that it matches as a whole.
#pragma once
#include <regex>
#include <stdexcept>
#include <string>

namespace sph
{

struct PatternError : std::runtime_error
{
    using runtime_error::runtime_error;
};

class KeywordPattern
{
    std::regex expression_;

public:
    /// Throws PatternError, in words that follow the quoted expression, where it is none or too large.
    explicit KeywordPattern(const std::string& expression);
    /// Whether the keyword matches as a whole, found in a time proportional to the length of the expression times that of the keyword.
    bool matches(const std::string& keyword) const;
};

}
