#include "TimeControls.hpp"
#include "OutputFile.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

using Words = std::vector<std::string>;

const Words stopWords{"endTime", "writeNow", "noWriteNow", "nextWrite"};
/// In the order of WriteControl; OpenFOAM's second word for the same thing stands at the end.
const Words writeWords{"none", "timeStep", "runTime", "adjustable", "clockTime", "cpuTime", "adjustableRunTime"};
const Words formatWords{"ascii", "binary"};
const Words timeFormatWords{"general", "fixed", "scientific"};
const Words compressionWords{"off", "uncompressed", "no", "false", "none"};

constexpr double roundOff = std::numeric_limits<double>::epsilon();
/// Two times nearer than this part of a write interval are the same.
constexpr double sameTime = 1e-9;
/// Nobody means more, and shorter intervals would be lost in the rounding of time.
constexpr double mostWrites = 1e9;

int chosen(const Dictionary& d, const std::string& key, const Words& valid, const std::string& fallback)
{
    const auto word = d.choose(key, valid, fallback);
    const auto at = std::find(valid.begin(), valid.end(), word);
    return at == valid.end() ? 0 : int(at - valid.begin());
}

int digits(const Dictionary& d, const std::string& key, int fallback)
{
    const int value = d.get<int>(key, fallback);
    constexpr int most = std::numeric_limits<double>::max_digits10;
    if (d.found(key) && (value < 1 || value > most))
        d.error(key, fmt::format("{} must be 1 to {} digits, found {}", key, most, value));
    return std::clamp(value, 0, most);
}

/// A positive time, or `absent` where the entry is missing; looked up in both cases, so that the keyword is known.
double optionalTime(const Dictionary& d, const std::string& key, double absent)
{
    const double value = d.getPositive(key, units::s, 1.0);
    return d.found(key) ? value : absent;
}

double readInterval(const Dictionary& d, WriteControl control)
{
    if (control == WriteControl::none) return d.getPositive("writeInterval", units::s, 1.0);
    if (control != WriteControl::timeStep) return d.getPositive("writeInterval", units::s);
    const double steps = d.getPositive("writeInterval", units::none);
    if (steps != std::floor(steps))
        d.error("writeInterval", fmt::format("writeInterval must be a number of steps, found {}", steps));
    return std::max(1.0, std::floor(steps));
}

WriteOptions readOptions(const Dictionary& d)
{
    WriteOptions options;
    options.format = WriteFormat(chosen(d, "writeFormat", formatWords, "ascii"));
    options.precision = digits(d, "writePrecision", 0);
    if (options.format == WriteFormat::ascii && options.precision > 0 &&
        options.precision < std::numeric_limits<double>::max_digits10)
        d.diagnostics().warning(d.where("writePrecision"),
                                fmt::format("{} digits lose the last ones of each number, and a restart from such files goes on "
                                            "slightly differently. Without writePrecision nothing is lost.",
                                            options.precision));
    d.choose("writeCompression", compressionWords, "off");
    return options;
}

}

TimeControls TimeControls::read(const Dictionary& d)
{
    TimeControls c;
    c.stopAt = StopAt(chosen(d, "stopAt", stopWords, "endTime"));
    // Otherwise endTime stands for later: the run stops at a write, as in OpenFOAM.
    if (c.stopAt == StopAt::endTime)
        c.endTime = d.get<double>("endTime");
    else
        d.get<double>("endTime", 0.0);

    c.adjustTimeStep = d.get<bool>("adjustTimeStep", true);
    // The limits decide adjusted steps alone: nothing is left for deltaT to say.
    c.deltaT = c.adjustTimeStep ? optionalTime(d, "deltaT", 0) : d.getPositive("deltaT", units::s);
    c.maxDeltaT = optionalTime(d, "maxDeltaT", infinity);

    const int control = chosen(d, "writeControl", writeWords, "none");
    c.writeControl = writeWords[std::size_t(control)] == "adjustableRunTime" ? WriteControl::adjustable : WriteControl(control);
    c.writeInterval = readInterval(d, c.writeControl);
    const bool byTime = c.writeControl == WriteControl::runTime || c.writeControl == WriteControl::adjustable;
    if (byTime && std::isfinite(c.endTime) && std::abs(c.endTime) > mostWrites * c.writeInterval)
        d.error("writeInterval", fmt::format("writeInterval {} s would make {:.2g} time folders until endTime {}", c.writeInterval,
                                             std::abs(c.endTime) / c.writeInterval, c.endTime));
    c.purgeWrite = d.get<int>("purgeWrite", 0);
    if (c.purgeWrite < 0) d.error("purgeWrite", fmt::format("purgeWrite must not be negative, found {}", c.purgeWrite));
    c.writeOptions = readOptions(d);
    c.timeFormat = TimeFormat(chosen(d, "timeFormat", timeFormatWords, "general"));
    c.timePrecision = digits(d, "timePrecision", 6);
    c.runTimeModifiable = d.get<bool>("runTimeModifiable", true);
    c.maxClockTime = optionalTime(d, "maxClockTime", infinity);
    return c;
}

std::vector<std::pair<std::string, std::string>> TimeControls::inWords() const
{
    const auto flag = [](bool on) { return std::string(on ? "yes" : "no"); };
    return {{"stopAt", stopWords[std::size_t(stopAt)]},
            {"endTime", shortestText(endTime)},
            {"deltaT", shortestText(deltaT)},
            {"adjustTimeStep", flag(adjustTimeStep)},
            {"maxDeltaT", shortestText(maxDeltaT)},
            {"writeControl", writeWords[std::size_t(writeControl)]},
            {"writeInterval", shortestText(writeInterval)},
            {"purgeWrite", fmt::format("{}", purgeWrite)},
            {"writeFormat", formatWords[std::size_t(writeOptions.format)]},
            {"writePrecision", writeOptions.precision ? fmt::format("{}", writeOptions.precision) : "shortest"},
            {"timeFormat", timeFormatWords[std::size_t(timeFormat)]},
            {"timePrecision", fmt::format("{}", timePrecision)},
            {"runTimeModifiable", flag(runTimeModifiable)},
            {"maxClockTime", shortestText(maxClockTime)}};
}

double TimeControls::writeIndex(double t) const
{
    const double k = t / writeInterval;
    return std::floor(k + sameTime + 4 * roundOff * std::abs(k));
}

double TimeControls::end() const
{
    if (!fitsSteps() || !std::isfinite(endTime)) return endTime;
    const double write = std::round(endTime / writeInterval) * writeInterval;
    return std::abs(write - endTime) <= sameTime * writeInterval + 4 * roundOff * std::abs(endTime) ? write : endTime;
}

double TimeControls::nextTarget(double t) const
{
    return fitsSteps() ? std::min((writeIndex(t) + 1) * writeInterval, end()) : infinity;
}

double TimeControls::step(double t, double limit) const
{
    if (!adjustTimeStep) return deltaT;
    const double longest = std::min(limit, maxDeltaT);
    const double left = nextTarget(t) - t;
    // At the most a tenth beyond the limit rather than a step of almost nothing behind it; maxDeltaT is never passed.
    if (left <= std::min(1.1 * limit, maxDeltaT)) return left;
    // Two equal steps rather than a long one and a short one.
    return left < 2 * longest ? 0.5 * left : longest;
}

double TimeControls::advanced(double t, double dt) const
{
    const double sum = t + dt;
    if (!adjustTimeStep)
    {
        const double n = std::round(t / deltaT);
        const bool onGrid = dt == deltaT && std::abs(t - n * deltaT) <= 1e-6 * deltaT;
        return onGrid ? (n + 1) * deltaT : sum;
    }
    const double target = nextTarget(t);
    return std::abs(sum - target) <= sameTime * dt + 4 * roundOff * std::abs(t) ? target : sum;
}

bool TimeControls::before(double t) const { return adjustTimeStep ? t < end() : t < endTime - 0.5 * deltaT; }

}
