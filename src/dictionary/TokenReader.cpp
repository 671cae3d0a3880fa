#include "dictionary/TokenReader.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryParser.hpp"
#include "dictionary/Tokeniser.hpp"
#include "dictionary/UnitExpression.hpp"
#include "dictionary/limits.hpp"
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

using Kind = Token::Kind;

bool TokenReader::accept(char c)
{
    if (!sees(c)) return false;
    ++at_;
    return true;
}

bool TokenReader::accept(const char* word)
{
    if (!sees(Kind::word) || tokens_[at_].text != word) return false;
    ++at_;
    return true;
}

void TokenReader::failAt(const char* expected) const
{
    throw ValueError(atEnd() ? fmt::format("must be {}, but its value {}", expected, at_ == 0 ? "is missing" : "ends too early")
                             : fmt::format("must be {}, found \"{}\"", expected, beginning(toString(tokens_[at_]))));
}

void TokenReader::failCount(long announced, std::size_t found)
{
    throw ValueError(fmt::format("is a list that announces {} values and has {}", announced, found));
}

const Token& TokenReader::take(const char* expected)
{
    if (atEnd()) failAt(expected);
    return tokens_[at_++];
}

std::string TokenReader::rest() const
{
    std::string text;
    for (auto i = at_; i < tokens_.size(); ++i)
    {
        const bool tight = text.empty() || text.ends_with('(') || tokens_[i].is(')');
        text += (tight ? "" : " ") + toString(tokens_[i]);
        if (const auto shown = beginning(text); shown != text) return shown;
    }
    return text;
}

void TokenReader::finish() const
{
    if (!atEnd()) throw ValueError(fmt::format("has more than one value: \"{}\" is left over; is a ';' missing?", rest()));
}

std::optional<DimensionSet> TokenReader::dimensions()
{
    if (sees(Kind::word) && sees(Kind::dimensions, 1)) ++at_;
    if (!sees(Kind::dimensions)) return {};
    try
    {
        return parseDimensions(tokens_[at_++].text);
    }
    catch (const std::invalid_argument& e)
    {
        throw ValueError(fmt::format("has wrong dimensions: {}", e.what()));
    }
}

void TokenReader::read(double& value)
{
    accept("uniform");
    if (sees(Kind::dimensions)) throw ValueError("has dimensions, but a plain number is expected");
    if (!sees(Kind::number))
    {
        const auto word = atEnd() ? std::string() : tokens_[at_].text;
        for (const auto* special : {"nan", "NaN", "NAN", "-nan", "inf", "Inf", "INF", "-inf", "+inf", "infinity", "-infinity"})
            if (word == special) throw ValueError(fmt::format("must be a finite number, found \"{}\"", word));
        failAt("a number");
    }
    value = *toNumber(tokens_[at_].text);
    if (!std::isfinite(value)) throw ValueError(fmt::format("must be a finite number, \"{}\" is too large", tokens_[at_].text));
    ++at_;
}

/// 1e6 is accepted: it is an integer, and easier to read than its digits.
void TokenReader::read(int& value)
{
    if (!sees(Kind::number)) failAt("an integer");
    const double number = *toNumber(tokens_[at_].text);
    if (number != std::floor(number)) failAt("an integer");
    if (std::fabs(number) > std::numeric_limits<int>::max()) failAt("an integer of at most 2147483647");
    value = int(number);
    ++at_;
}

void TokenReader::read(bool& value)
{
    std::optional<bool> yes;
    if (sees(Kind::word)) yes = toSwitch(tokens_[at_].text);
    else if (sees(Kind::number) && (tokens_[at_].text == "0" || tokens_[at_].text == "1")) yes = tokens_[at_].text == "1";
    if (!yes) failAt("yes or no (on/off, true/false)");
    value = *yes;
    ++at_;
}

/// A number is accepted as a word, since names of times and of bodies may be numbers.
void TokenReader::read(std::string& value)
{
    if (!sees(Kind::word) && !sees(Kind::string) && !sees(Kind::verbatim) && !sees(Kind::number)) failAt("a word");
    value = tokens_[at_++].text;
}

void TokenReader::read(Vector<3>& value)
{
    accept("uniform");
    if (sees(Kind::dimensions)) throw ValueError("has dimensions, but a plain vector is expected");
    std::vector<double> components;
    if (!sees('(')) failAt("a vector \"(x y z)\"");
    read(components);
    if (components.size() != 3) throw ValueError(fmt::format("must be a vector \"(x y z)\", found {} components", components.size()));
    value = {components[0], components[1], components[2]};
}

long TokenReader::listHead()
{
    if (sees(Kind::word) && tokens_[at_].text.starts_with("List<")) ++at_;
    if (!sees(Kind::number) || (!sees('(', 1) && !sees('{', 1))) return -1;
    int count = 0;
    read(count);
    if (count < 0 || std::size_t(count) > limit::words)
        throw ValueError(fmt::format("is a list of {} values; 0 to {} are possible", count, limit::words));
    return count;
}

}
