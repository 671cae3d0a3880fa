#include "sampling/ModelNumber.hpp"
#include "base/CaseError.hpp"
#include "base/words.hpp"
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <ranges>

namespace sph
{

namespace entry
{
const Text number{"number", required, "name of the number in the model's report, \"power(hot)\""};
const Scalar value{"value", Unit{units::none, "of the number"}, required, "the exact value"},
    meanFrom{"meanFrom", units::s, notGiven, nonNegative, "time from which on the mean of all samples is taken"};
}

ModelNumber::ModelNumber(const Dictionary& d, const Geometry&, const std::vector<std::string>&)
    : number_(entry::number(d)), reference_(entry::value(d)), meanFrom_(entry::meanFrom.ifGiven(d)), where_(entry::number.where(d))
{}

EntryList ModelNumber::entries() { return {entry::number, entry::value, entry::meanFrom}; }

Measurement ModelNumber::operator()(const ParticleView& view)
{
    Measurement result{std::numeric_limits<double>::quiet_NaN(), reference_, view.n, ""};
    const auto found = view.numbers.find(number_);
    if (found == view.numbers.end() && view.numbers.empty())
    {
        result.note = "stored times have no numbers of models";
        return result;
    }
    if (found == view.numbers.end())
    {
        const auto names = std::views::keys(view.numbers);
        const std::vector<std::string> known(names.begin(), names.end());
        throw CaseError(where_, fmt::format("no model publishes a number \"{}\". {}", number_, suggestion(number_, "numbers", known)));
    }
    result.value = found->second;
    if (!meanFrom_) return result;
    if (view.time < *meanFrom_)
    {
        result.reference = std::numeric_limits<double>::quiet_NaN(); // no row before there is a mean
        return result;
    }
    if (times_.empty() || view.time > times_.back()) // a restarted run samples the time of its folder again
    {
        times_.push_back(view.time);
        values_.push_back(found->second);
    }
    result.value = std::accumulate(values_.begin(), values_.end(), 0.0) / double(values_.size());
    return result;
}

}
