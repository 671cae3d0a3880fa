#include "sampling/HistoryFit.hpp"
#include "sampling/ModeFit.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph
{

namespace entry
{
const Choice form{"form",
                  {{"exponential", "A exp(s t)"},
                   {"power", "A t^n"},
                   {"growth", "A exp(s t) + B exp(-s t), an interface from a displacement, a velocity or both"},
                   {"oscillation", "Re[A exp(s t)] + B"}},
                  required,
                  "law that is fitted to the history"};
const Choice ofExponential{"gives", {{"rate", "s [1/s]"}, {"amplitude", "A"}}, "rate", "which of its constants"},
    ofPower{"gives", {{"exponent", "n"}, {"factor", "A"}}, "exponent", "which of its constants"},
    ofOscillation{"gives", {{"period", "2 pi/Im s [s]"}, {"decayRate", "-Re s [1/s]"}}, "period", "which of its constants"};
const Scalar guessOfRate{"guess", Unit{units::none, "1/s"}, byScene("that of an exponential"), positive,
                         "a rate s from which the fit begins, a tenth to four times of what it is"},
    guessOfPeriod{"guess", units::s, byScene("that of the crossings of the mean"), positive, "a period from which the fit begins"};
}

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

struct Line
{
    double slope = nan, atZero = nan;
};

/// The line through (x, y) with the least squares in y; NaN where the x are one.
Line fitLine(const std::vector<double>& x, const std::vector<double>& y)
{
    const double n = double(x.size());
    double meanX = 0, meanY = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        meanX += x[k] / n;
        meanY += y[k] / n;
    }
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        xx += (x[k] - meanX) * (x[k] - meanX);
        xy += (x[k] - meanX) * (y[k] - meanY);
    }
    if (!(xx > 0)) return {};
    return {xy / xx, meanY - xy / xx * meanX};
}

/// ln |a| over t, or over ln t, where a keeps its sign. A power begins at t = 0, which has no logarithm.
Line fitLogarithm(const History& history, bool overLogarithm)
{
    std::vector<double> x, y;
    for (std::size_t k = 0; k < history.times.size(); ++k)
    {
        const double t = history.times[k], a = history.values[k];
        if (overLogarithm && !(t > 0)) continue;
        if (!(a * history.values.back() > 0)) return {};
        x.push_back(overLogarithm ? std::log(t) : t);
        y.push_back(std::log(std::abs(a)));
    }
    return fitLine(x, y);
}

/// The period by the times at which the values cross their mean; NaN where there are less than two.
double periodOfCrossings(const History& history)
{
    double mean = 0;
    for (const double a : history.values) mean += a / double(history.values.size());
    double first = nan, last = nan;
    int crossings = 0;
    for (std::size_t k = 1; k < history.times.size(); ++k)
    {
        const double before = history.values[k - 1] - mean, after = history.values[k] - mean;
        if (!(before * after < 0)) continue;
        last = history.times[k - 1] + before / (before - after) * (history.times[k] - history.times[k - 1]);
        if (crossings++ == 0) first = last;
    }
    return crossings < 2 ? nan : 2 * (last - first) / (crossings - 1);
}

}

EntryList HistoryFit::entries()
{
    return {{entry::form,
             {{"exponential", {entry::ofExponential}},
              {"power", {entry::ofPower}},
              {"growth", {entry::guessOfRate}},
              {"oscillation", {entry::ofOscillation, entry::guessOfPeriod}}}}};
}

HistoryFit::HistoryFit(const Dictionary& d) : form_(entry::form(d))
{
    if (form_ == "exponential") gives_ = entry::ofExponential(d);
    if (form_ == "power") gives_ = entry::ofPower(d);
    if (form_ == "growth") guess_ = entry::guessOfRate.ifGiven(d);
    if (form_ == "oscillation")
    {
        gives_ = entry::ofOscillation(d);
        guess_ = entry::guessOfPeriod.ifGiven(d);
    }
}

double HistoryFit::operator()(const History& history) const
{
    if (history.times.empty()) return nan;
    const auto &t = history.times, &a = history.values;
    if (std::ranges::any_of(a, [](double value) { return !std::isfinite(value); })) return nan;
    if (form_ == "exponential" || form_ == "power")
    {
        const auto line = fitLogarithm(history, form_ == "power");
        return gives_ == "rate" || gives_ == "exponent" ? line.slope : std::copysign(std::exp(line.atZero), a.back());
    }
    if (form_ == "growth")
    {
        const double guess = guess_.value_or(fitLogarithm(history, false).slope);
        return guess > 0 ? fitGrowth(t, a, guess).value_or(nan) : nan;
    }
    const double period = guess_.value_or(periodOfCrossings(history));
    if (!(period > 0)) return nan;
    const auto s = fitOscillation(t, a, {0, 2 * pi / period});
    if (!s) return nan;
    return gives_ == "period" ? 2 * pi / s->imag() : -s->real();
}

}
