#include "dictionary/Parameter.hpp"
#include "base/words.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace sph
{

namespace
{

/// Text of a unit as engineers write it, where there is such a name, else in base units: "kg m s^-2".
std::string unitText(const DimensionSet& d)
{
    static const std::vector<std::pair<DimensionSet, std::string>> named{{units::none, ""},
                                                                         {units::density, "kg/m^3"},
                                                                         {units::pressure, "Pa"},
                                                                         {units::viscosity, "Pa s"},
                                                                         {units::kinematicViscosity, "m^2/s"},
                                                                         {units::surfaceTension, "N/m"},
                                                                         {units::mPerS, "m/s"},
                                                                         {units::mPerS2, "m/s^2"},
                                                                         {units::forcePerVolume, "N/m^3"},
                                                                         {units::none / units::s, "1/s"},
                                                                         {units::m3 / units::s, "m^3/s"}};
    for (const auto& [dimensions, text] : named)
        if (dimensions == d) return text;
    static const std::array<const char*, 7> base{"kg", "m", "s", "K", "mol", "A", "cd"};
    std::string text;
    for (std::size_t k = 0; k < base.size(); ++k)
        if (const double n = d.exponent[k]; n != 0)
            text += (text.empty() ? "" : " ") + std::string(base[k]) + (n == 1 ? "" : fmt::format("^{}", n));
    return text;
}

ParameterInfo describe(std::string keyword, std::string type, std::string unit, std::string range, std::string meaning,
                       ChoiceWords choices = {})
{
    return {.keyword = std::move(keyword),
            .type = std::move(type),
            .unit = std::move(unit),
            .fallback = {},
            .example = {},
            .range = std::move(range),
            .meaning = std::move(meaning),
            .choices = std::move(choices)};
}

}

Unit::Unit(const DimensionSet& d) : dimensions(d), text(unitText(d)) {}

bool Range::holds(double value) const
{
    return (lowIncluded ? value >= low : value > low) && (highIncluded ? value <= high : value < high);
}

double Range::harmless() const { return holds(0) ? 0 : holds(1) ? 1 : lowIncluded ? low : highIncluded ? high : 0.5 * (low + high); }

std::string Range::text() const
{
    const bool below = std::isfinite(high), above = std::isfinite(low);
    if (above && below && lowIncluded && highIncluded) return fmt::format("{} to {}", low, high);
    std::string text;
    if (above) text = fmt::format("{} {}", lowIncluded ? ">=" : ">", low);
    if (below) text += fmt::format("{}{} {}", above ? ", " : "", highIncluded ? "<=" : "<", high);
    return text;
}

std::string Range::wrong(const std::string& keyword, double value) const
{
    if (!complaint.empty()) return fmt::format(fmt::runtime(complaint), value);
    const bool below = std::isfinite(high);
    const auto must = low == 0 && !below      ? lowIncluded ? "not be negative" : "be positive"
                      : !below && lowIncluded ? fmt::format("be at least {}", low)
                                              : "be " + text();
    return fmt::format("\"{}\" must {}, found {}", keyword, must, value);
}

Range Range::saying(std::string reason) const
{
    auto r = *this;
    r.complaint = std::move(reason);
    return r;
}

std::vector<std::string> ChoiceWords::words() const
{
    std::vector<std::string> all;
    for (const auto& w : *this) all.push_back(w.word);
    return all;
}

void Parameter::checkPlane(const Dictionary& d, const Vector<3>& value, int dimension) const
{
    if (dimension == 2 && value.z != 0) error(d, fmt::format("in 2-D the z component of \"{}\" must be 0, found {}", keyword(), value.z));
}

std::string written(double x) { return fmt::format("{}", x); }
std::string written(int i) { return fmt::format("{}", i); }
std::string written(bool b) { return b ? "yes" : "no"; }
std::string written(const std::string& s) { return s; }
std::string written(const Vector<3>& v) { return fmt::format("({} {} {})", v.x, v.y, v.z); }

Scalar::Scalar(std::string keyword, const Unit& unit, const Default<double>& fallback, const Range& range, std::string meaning)
    : ValueParameter(describe(std::move(keyword), "number", unit.text, range.text(), std::move(meaning)), fallback, range.harmless()),
      dimensions_(unit.dimensions),
      range_(range)
{}

double Scalar::read(const Dictionary& d, const double& harmless) const
{
    // No number that can be read is NaN.
    const double value = d.get(keyword(), dimensions_, std::numeric_limits<double>::quiet_NaN());
    if (range_.holds(value)) return value;
    if (!std::isnan(value)) error(d, range_.wrong(keyword(), value));
    return harmless;
}

Scalar Scalar::in(const DimensionSet& dimensions) const
{
    auto other = *this;
    other.dimensions_ = dimensions;
    return other;
}

Count::Count(std::string keyword, const Default<int>& fallback, const Range& range, std::string meaning)
    : ValueParameter(describe(std::move(keyword), "whole number", "", range.text(), std::move(meaning)), fallback, int(range.harmless())),
      range_(range)
{}

int Count::read(const Dictionary& d, const int& harmless) const
{
    const int value = d.get(keyword(), harmless);
    if (range_.holds(value)) return value;
    error(d, range_.wrong(keyword(), value));
    return harmless;
}

Switch::Switch(std::string keyword, const Default<bool>& fallback, std::string meaning)
    : ValueParameter(describe(std::move(keyword), "switch", "", "", std::move(meaning)), fallback, false)
{}

VectorParameter::VectorParameter(std::string keyword, const Unit& unit, const Default<Vector<3>>& fallback, std::string meaning)
    : ValueParameter(describe(std::move(keyword), "vector", unit.text, "", std::move(meaning)), fallback, {}), dimensions_(unit.dimensions)
{}

Direction::Direction(std::string keyword, const Default<Vector<3>>& fallback, std::string meaning)
    : ValueParameter(describe(std::move(keyword), "direction", "", "not (0 0 0)", std::move(meaning)), fallback, {1, 0, 0})
{}

Vector<3> Direction::read(const Dictionary& d, const Vector<3>& harmless) const
{
    const auto v = d.getVector(keyword(), units::none, harmless);
    if (const double length = mag(v); length > 0) return scaled_ ? v / length : v;
    error(d, fmt::format("{} must have a direction, not (0 0 0)", keyword()));
    return harmless;
}

Vector<3> Direction::asGiven(const Dictionary& d) const
{
    auto unscaled = *this;
    unscaled.scaled_ = false;
    return unscaled(d);
}

Choice::Choice(std::string keyword, ChoiceWords choices, const Default<std::string>& fallback, std::string meaning)
    : ValueParameter(describe(std::move(keyword), "choice", "", "", std::move(meaning), choices), fallback, choices.front().word),
      words_(choices.words())
{}

int Choice::indexOf(const std::string& word) const { return int(std::ranges::find(words_, word) - words_.begin()); }

std::optional<std::string> Choice::known(const Dictionary& d) const
{
    const auto before = d.diagnostics().errors();
    auto word = (*this)(d);
    if (d.diagnostics().errors() == before) return word;
    for (const auto& other : d.keys()) d.ignore(other);
    return {};
}

Word::Word(std::string keyword, const Default<std::string>& fallback, std::string meaning)
    : ValueParameter(describe(std::move(keyword), "word", "", "", std::move(meaning)), fallback, "")
{
    if (!info_.isFixed) info_.example = "name";
}

Text::Text(std::string keyword, const Default<std::string>& fallback, std::string meaning)
    : Word(std::move(keyword), fallback, std::move(meaning))
{
    info_.type = "text";
    info_.example = info_.isFixed ? fmt::format("\"{}\"", info_.fallback) : "\"..\"";
    if (info_.isFixed) info_.fallback = info_.example;
}

template<class T>
ListOf<T>::ListOf(std::string keyword, const Unit& unit, const Default<std::vector<T>>& fallback, std::string meaning)
    : ValueParameter<std::vector<T>>(describe(std::move(keyword),
                                              std::is_same_v<T, double>        ? "list of numbers"
                                              : std::is_same_v<T, int>         ? "list of whole numbers"
                                              : std::is_same_v<T, std::string> ? "list of words"
                                              : std::is_same_v<T, Vector<3>>   ? "list of vectors"
                                                                               : "list of lists of numbers",
                                              unit.text, "", std::move(meaning)),
                                     fallback, {})
{}
template class ListOf<double>;
template class ListOf<int>;
template class ListOf<std::string>;
template class ListOf<Vector<3>>;
template class ListOf<std::vector<double>>;

Choices::Choices(std::string keyword, std::string things, ChoiceWords choices, const Default<std::vector<std::string>>& fallback,
                 std::string meaning)
    : ListOf(std::move(keyword), fallback, std::move(meaning)), things_(std::move(things))
{
    info_.choices = std::move(choices);
}

std::vector<std::string> Choices::operator()(const Dictionary& d) const { return among(d, info_.choices.words(), ListOf::operator()(d)); }
std::vector<std::string> Choices::operator()(const Dictionary& d, const std::vector<std::string>& fallback) const
{
    return among(d, info_.choices.words(), fallback);
}

std::vector<std::string> Choices::among(const Dictionary& d, std::span<const std::string> known,
                                        const std::vector<std::string>& fallback) const
{
    auto words = ListOf::operator()(d, fallback);
    std::erase_if(words,
                  [&](const std::string& word)
                  {
                      if (std::ranges::find(known, word) != known.end()) return false;
                      error(d, fmt::format("\"{}\" is unknown. {}", word, suggestion(word, things_, known)));
                      return true;
                  });
    return words;
}

PairValues::PairValues(std::string keyword, std::string what, const Unit& unit, const Range& range, std::string meaning)
    : Parameter(describe(std::move(keyword), "list of pairs with values", unit.text, range.text(), std::move(meaning))),
      what_(std::move(what)),
      range_(range)
{
    info_.fallback = "none";
    info_.example = fmt::format("( (a b) {} )", range.harmless());
}

std::vector<Dictionary::PairValue> PairValues::operator()(const Dictionary& d) const
{
    std::vector<Dictionary::PairValue> good;
    if (!given(d)) return good;
    for (const auto& pair : d.pairs(keyword()))
    {
        const auto& [first, second, value] = pair;
        const auto earlier = std::find_if(good.begin(), good.end(),
                                          [&](const auto& q)
                                          { return (q.first == first && q.second == second) || (q.first == second && q.second == first); });
        if (first == second) error(d, fmt::format("\"{}\" has no {} with itself", first, what_));
        else if (!range_.holds(value)) error(d, range_.wrong(fmt::format("{} of {} and {}", what_, first, second), value));
        else if (earlier != good.end())
            error(d, fmt::format("the {} of {} and {} is there twice, ({} {}) {} and ({} {}) {}: each pair has one", what_, first, second,
                                 earlier->first, earlier->second, earlier->value, first, second, value));
        else good.push_back(pair);
    }
    return good;
}

SubDictionary::SubDictionary(std::string keyword, Required, std::string meaning)
    : Parameter(describe(std::move(keyword), "dictionary", "", "", std::move(meaning)))
{
    info_.isRequired = true;
}
SubDictionary::SubDictionary(std::string keyword, ByScene how, std::string meaning)
    : Parameter(describe(std::move(keyword), "dictionary", "", "", std::move(meaning)))
{
    info_.fallback = std::move(how.text);
}

DictionaryList::DictionaryList(std::string keyword, Required, std::string meaning)
    : Parameter(describe(std::move(keyword), "list of dictionaries", "", "", std::move(meaning)))
{
    info_.isRequired = true;
}
DictionaryList::DictionaryList(std::string keyword, ByScene how, std::string meaning)
    : Parameter(describe(std::move(keyword), "list of dictionaries", "", "", std::move(meaning)))
{
    info_.fallback = std::move(how.text);
}

std::vector<Dictionary> DictionaryList::operator()(const Dictionary& d) const
{
    return info_.isRequired || given(d) ? d.dictionaries(keyword()) : std::vector<Dictionary>{};
}

FreeName::FreeName(std::string name, std::string type, std::string meaning)
    : Parameter(describe(std::move(name), std::move(type), "", "", std::move(meaning)))
{}

}
