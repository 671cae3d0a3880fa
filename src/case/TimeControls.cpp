#include "case/TimeControls.hpp"
#include "base/OutputFile.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Choice stopAt{"stopAt",
                    {"endTime",
                     {"writeNow", "write and stop"},
                     {"noWriteNow", "stop without writing"},
                     {"nextWrite", "stop at the next write"}}, // as StopAt
                    "endTime",
                    "when the run ends"};
const Scalar endTime{"endTime", units::s, byScene("needed with stopAt endTime"), "end of the run; with another stopAt it stands for later"},
    deltaT{"deltaT", units::s, byScene("that of the limits; needed with adjustTimeStep no"), positive,
           "time step; with adjustTimeStep yes the longest that the first one may be"},
    maxDeltaT{"maxDeltaT", units::s, byScene("none"), positive, "largest time step, with adjustTimeStep"},
    writeInterval{"writeInterval", Unit{units::s, "s or steps"}, byScene("needed with a writeControl"), positive, "between two writes"},
    maxClockTime{"maxClockTime", units::s, byScene("none"), positive, "clock time after which the run ends"};
const Switch adjustTimeStep{"adjustTimeStep", true, "steps as long as the limits of stability allow"},
    runTimeModifiable{"runTimeModifiable", true, "read controlDict anew where it changes during the run"};
/// Words in the order of WriteControl; OpenFOAM's second word for the same thing stands at the end.
const Choice writeControl{"writeControl",
                          {"none",
                           {"timeStep", "writeInterval counts steps"},
                           {"runTime", "writes after a time has passed"},
                           {"adjustable", "steps are fitted to the times of writing"},
                           {"clockTime", "by the clock"},
                           {"cpuTime", "by the processor's clock"},
                           {"adjustableRunTime", "as adjustable"}},
                          "none",
                          "when time folders are written"};
const Count purgeWrite{"purgeWrite", 0, nonNegative.saying("purgeWrite must not be negative, found {}"),
                       "number of time folders that are kept; 0: all"};
const Choice writeFormat{"writeFormat", {"ascii", "binary"}, "ascii", "of the files; packParticles writes binary by default"},
    timeFormat{"timeFormat", {"general", "fixed", "scientific"}, "general", "of the names of time folders"},
    writeCompression{"writeCompression",
                     {"off", "uncompressed", "no", "false", "none"},
                     "off",
                     "for OpenFOAM's sake: nothing is compressed"};
constexpr int mostDigits = std::numeric_limits<double>::max_digits10;
const Count writePrecision{"writePrecision", byScene("as many as a number needs"),
                           between(1, mostDigits).saying(fmt::format("writePrecision must be 1 to {} digits, found {{}}", mostDigits)),
                           "digits of numbers in ascii files"},
    timePrecision{"timePrecision", 6,
                  between(1, mostDigits).saying(fmt::format("timePrecision must be 1 to {} digits, found {{}}", mostDigits)),
                  "least digits of the names of time folders; more where a name would not be exact"};
}

namespace
{

constexpr double roundOff = std::numeric_limits<double>::epsilon();
/// Two times nearer than this part of a write interval are the same.
constexpr double sameTime = 1e-9;
/// Most write intervals in the end time: of shorter ones the rounding of time would be a part of 10^-6 and more.
constexpr double mostWrites = 1e9;

double readInterval(const Dictionary& d, WriteControl control)
{
    if (control == WriteControl::none && entry::writeInterval.given(d) && !entry::writeControl.given(d))
        entry::writeInterval.error(
            d, "writeInterval does nothing without writeControl, which says what it counts: give `writeControl adjustable` for "
               "seconds that steps are fitted to, or leave it out");
    if (control == WriteControl::none) return entry::writeInterval(d, 1.0);
    if (control != WriteControl::timeStep) return entry::writeInterval.needed(d);
    const double steps = entry::writeInterval.in(units::none).needed(d);
    if (steps != std::floor(steps)) entry::writeInterval.error(d, fmt::format("writeInterval must be a number of steps, found {}", steps));
    return std::max(1.0, std::floor(steps));
}

WriteOptions readOptions(const Dictionary& d)
{
    WriteOptions options;
    options.format = WriteFormat(entry::writeFormat.index(d));
    options.precision = entry::writePrecision(d, 0);
    if (options.format == WriteFormat::binary && entry::writePrecision.given(d))
        entry::writePrecision.error(d, "writePrecision does nothing with `writeFormat binary`, which keeps all digits; leave it out");
    if (options.format == WriteFormat::ascii && options.precision > 0 && options.precision < std::numeric_limits<double>::max_digits10)
        d.diagnostics().warning(entry::writePrecision.where(d),
                                fmt::format("{} digits lose the last ones of each number, and a restart from such files goes on "
                                            "slightly differently. Without writePrecision nothing is lost.",
                                            options.precision));
    entry::writeCompression(d);
    return options;
}

}

TimeControls TimeControls::read(const Dictionary& d)
{
    TimeControls c;
    c.stopAt = StopAt(entry::stopAt.index(d));
    // Otherwise endTime stands for later: the run stops at a write, as in OpenFOAM.
    if (c.stopAt == StopAt::endTime) c.endTime = entry::endTime.needed(d);
    else entry::endTime(d, 0);

    c.adjustTimeStep = entry::adjustTimeStep(d);
    c.deltaT = c.adjustTimeStep ? entry::deltaT(d, 0) : entry::deltaT.needed(d);
    if (c.adjustTimeStep && entry::deltaT.given(d) && !entry::adjustTimeStep.given(d))
        entry::deltaT.error(
            d, "without adjustTimeStep the limits of stability decide on all steps but the first: give `adjustTimeStep no` for "
               "steps of deltaT, or `adjustTimeStep yes` where deltaT is that of the first step");
    c.maxDeltaT = entry::maxDeltaT(d, infinity);
    if (!c.adjustTimeStep && entry::maxDeltaT.given(d))
        entry::maxDeltaT.error(d, "maxDeltaT does nothing with `adjustTimeStep no`: steps are deltaT; leave it out");

    const auto control = entry::writeControl(d);
    c.writeControl = control == "adjustableRunTime" ? WriteControl::adjustable : WriteControl(entry::writeControl.indexOf(control));
    c.writeInterval = readInterval(d, c.writeControl);
    const bool byTime = c.writeControl == WriteControl::runTime || c.writeControl == WriteControl::adjustable;
    if (byTime && std::isfinite(c.endTime) && std::abs(c.endTime) > mostWrites * c.writeInterval)
        entry::writeInterval.error(
            d, fmt::format("writeInterval {} s is less than {:.0e} of endTime {:.10g} s: moments so close to one another are lost "
                           "in the rounding of time; give a longer interval, or count time from nearer to 0",
                           c.writeInterval, 1 / mostWrites, c.endTime));
    c.purgeWrite = entry::purgeWrite(d);
    if (c.purgeWrite > 0 && c.writeControl == WriteControl::none)
        entry::purgeWrite.error(d, "purgeWrite does nothing without writeControl: the end of the run is all that is written; leave it out");
    c.writeOptions = readOptions(d);
    c.timeFormat = TimeFormat(entry::timeFormat.index(d));
    c.timePrecision = entry::timePrecision(d);
    c.runTimeModifiable = entry::runTimeModifiable(d);
    c.maxClockTime = entry::maxClockTime(d, infinity);
    return c;
}

EntryList TimeControls::entries()
{
    using namespace entry;
    return {entry::stopAt,        entry::endTime,           entry::deltaT,        entry::adjustTimeStep,
            entry::maxDeltaT,     entry::writeControl,      entry::writeInterval, entry::purgeWrite,
            writeFormat,          writePrecision,           writeCompression,     entry::timeFormat,
            entry::timePrecision, entry::runTimeModifiable, entry::maxClockTime};
}

std::vector<std::pair<std::string, std::string>> TimeControls::inWords() const
{
    const auto word = [](const Choice& choice, auto number) { return choice.words()[std::size_t(number)]; };
    const auto flag = [](bool on) { return std::string(on ? "yes" : "no"); };
    return {{"stopAt", word(entry::stopAt, stopAt)},
            {"endTime", shortestText(endTime)},
            {"deltaT", shortestText(deltaT)},
            {"adjustTimeStep", flag(adjustTimeStep)},
            {"maxDeltaT", shortestText(maxDeltaT)},
            {"writeControl", word(entry::writeControl, writeControl)},
            {"writeInterval", shortestText(writeInterval)},
            {"purgeWrite", fmt::format("{}", purgeWrite)},
            {"writeFormat", word(entry::writeFormat, writeOptions.format)},
            {"writePrecision", writeOptions.precision ? fmt::format("{}", writeOptions.precision) : "shortest"},
            {"timeFormat", word(entry::timeFormat, timeFormat)},
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

double TimeControls::nextTarget(double t) const { return fitsSteps() ? std::min((writeIndex(t) + 1) * writeInterval, end()) : infinity; }

double TimeControls::step(double t, double limit) const
{
    if (!adjustTimeStep) return deltaT;
    const double longest = std::min(limit, maxDeltaT);
    const double left = nextTarget(t) - t;
    // The step is at most a tenth beyond the limit, rather than one of almost nothing behind it; maxDeltaT is never passed.
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
