#include "dictionary/UnitExpression.hpp"
#include "base/words.hpp"
#include "dictionary/Tokeniser.hpp"
#include "dictionary/limits.hpp"
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace sph
{

namespace
{

const std::map<std::string, DimensionSet>& knownUnits()
{
    static const DimensionSet newton = units::kg * units::m / units::s / units::s;
    static const std::map<std::string, DimensionSet> all{
        {"kg", units::kg},
        {"m", units::m},
        {"s", units::s},
        {"K", {0, 0, 0, 1}},
        {"mol", {0, 0, 0, 0, 1}},
        {"A", {0, 0, 0, 0, 0, 1}},
        {"cd", {0, 0, 0, 0, 0, 0, 1}},
        {"N", newton},
        {"Pa", units::pressure},
        {"J", newton * units::m},
        {"W", newton * units::m / units::s},
    };
    return all;
}

DimensionSet power(DimensionSet d, double exponent)
{
    for (auto& e : d.exponent) e *= exponent;
    return d;
}

class UnitParser
{
    const std::string& text_;
    std::size_t at_ = 0;

public:
    explicit UnitParser(const std::string& text) : text_(text) {}

    DimensionSet run()
    {
        const auto d = product();
        if (!atEnd()) throw std::invalid_argument(fmt::format("unexpected \"{}\" in the units [{}]", text_.substr(at_), text_));
        return d;
    }

private:
    bool atEnd()
    {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_ == text_.size();
    }
    bool accept(char c)
    {
        if (atEnd() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    std::string run(const auto& belongs)
    {
        const auto begin = at_;
        while (at_ < text_.size() && belongs(static_cast<unsigned char>(text_[at_]))) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    DimensionSet product()
    {
        DimensionSet d;
        if (atEnd() || accept('-')) return d;
        if (text_[at_] != '/' && !accept('1')) d = factor();
        while (!atEnd() && text_[at_] != ')')
        {
            if (accept('/')) d = d / factor();
            else
            {
                if (!accept('*')) accept('.');
                d = d * factor();
            }
        }
        return d;
    }
    DimensionSet factor()
    {
        DimensionSet d;
        if (accept('('))
        {
            d = product();
            if (!accept(')')) throw std::invalid_argument(fmt::format("'(' is not closed in the units [{}]", text_));
        }
        else d = unit();
        if (!accept('^')) return d;
        const bool bracket = accept('(');
        const auto exponent = run([](unsigned char c) { return std::isdigit(c) || c == '-' || c == '+' || c == '.'; });
        const auto value = toNumber(exponent);
        if (!value || (bracket && !accept(')')))
            throw std::invalid_argument(fmt::format("'^' is not followed by a number in the units [{}]", text_));
        return power(d, *value);
    }
    DimensionSet unit()
    {
        atEnd();
        const auto name = run([](unsigned char c) { return std::isalpha(c); });
        const auto found = knownUnits().find(name);
        if (found != knownUnits().end()) return found->second;
        std::vector<std::string> names;
        for (const auto& [known, dimensions] : knownUnits()) names.push_back(known);
        throw std::invalid_argument(name.empty() ? fmt::format("a unit is missing in [{}]", text_)
                                                 : fmt::format("unit \"{}\" is unknown. {}", name, suggestion(name, "units", names)));
    }
};

}

DimensionSet parseDimensions(const std::string& text)
{
    if (text.size() > limit::dimensions)
        throw std::invalid_argument(fmt::format("the text in the brackets is longer than {} characters", limit::dimensions));
    std::istringstream words(text);
    std::vector<double> exponents;
    std::string word;
    while (words >> word)
    {
        const auto value = toNumber(word);
        if (!value && !exponents.empty())
            throw std::invalid_argument(fmt::format("\"{}\" is no exponent in the dimensions [{}]", word, text));
        if (!value) return UnitParser(text).run();
        exponents.push_back(*value);
    }
    if (exponents.empty()) return {};
    if (exponents.size() != 5 && exponents.size() != 7)
        throw std::invalid_argument(fmt::format("[{}] has {} exponents, expected 7: [kg m s K mol A cd]", text, exponents.size()));
    exponents.resize(7);
    DimensionSet d;
    for (int k = 0; k < 7; ++k) d.exponent[k] = exponents[k];
    return d;
}

}
