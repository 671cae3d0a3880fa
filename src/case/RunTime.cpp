#include "case/RunTime.hpp"
#include "base/OutputFile.hpp"
#include "base/words.hpp"
#include "case/FoamHeader.hpp"
#include "case/TimeFolder.hpp"
#include "parallel/Ranks.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sys/stat.h>
#include <utility>

namespace sph
{

namespace entry
{
const Choice startFrom{"startFrom", {"firstTime", "startTime", "latestTime"}, "latestTime", "time folder that the run starts from"};
const Scalar startTime{"startTime", units::s, byScene("needed with startFrom startTime"),
                       "time folder to start from; with another startFrom it stands for later"};
/// Entries that OpenFOAM's users have in controlDict for other programs, and those that function objects read.
const FreeName foreign[]{{"application", "word", "the solver; read by workPrecision"},
                         {"functions", "dictionary", "function objects"},
                         {"libs", "list of words", "libraries of function objects that are loaded (doc/ownMeasure.md)"},
                         {"graphFormat", "word", "not looked at"},
                         {"DebugSwitches", "dictionary", "not looked at"},
                         {"InfoSwitches", "dictionary", "not looked at"},
                         {"OptimisationSwitches", "dictionary", "not looked at"}};
}

namespace
{

constexpr const char* controlDictFile = "system/controlDict";
constexpr const char* originalFolder = "0.orig";

std::string uniformFile(const std::string& time, const std::string& object, const std::string& entries)
{
    return foamHeader(WriteFormat::ascii, "dictionary", time + "/uniform", object) + entries;
}

std::string inWords(const StateNumbers& state)
{
    std::string text;
    for (const auto& [name, value] : state)
    {
        if (!std::isfinite(value)) throw CaseError(fmt::format("{} is {}: a run cannot restart from that", name, value));
        text += fmt::format("{} {};\n", name, shortestText(value));
    }
    return text;
}

std::string inWords(const Histories& histories)
{
    std::string text;
    for (const auto& [name, values] : histories)
    {
        text += name + " (";
        for (const double value : values) text += " " + shortestText(value);
        text += " );\n";
    }
    return text;
}

}

EntryList RunTime::entries()
{
    EntryList all{entry::startFrom, entry::startTime};
    all += TimeControls::entries();
    for (const auto& other : entry::foreign) all += {other};
    return all;
}

RunTime::RunTime(const Case& c, Place place) : caseFolder_(c.folder()), place_(std::move(place)), control_(c.dictionary(controlDictFile))
{
    stamp_ = stamp();
    const auto start = std::make_shared<Clock>();
    clocks_ = {[start] { return start->clockTime(); }, [] { return Clock::executionTime(); }};
    for (const auto& other : entry::foreign) control_.ignore(other.keyword());
    controls_ = TimeControls::read(control_);
    deltaT_ = controls_.deltaT;
    findStart(c);
    restore(c);
    startTime_ = value_;
    startIndex_ = index_;
    named_[startName_] = value_;
}

void RunTime::findStart(const Case& c)
{
    const auto startFrom = entry::startFrom(control_);
    const double wanted = startFrom == "startTime" ? entry::startTime.needed(control_) : entry::startTime(control_, 0);

    auto names = place_.times.empty() ? c.times(place_.folder) : place_.times;
    const bool hasZero = std::any_of(names.begin(), names.end(), [](const auto& name) { return timeValue(name) == 0; });
    const bool fromOriginal = !hasZero && place_.folder.empty() && c.has(originalFolder);
    if (fromOriginal)
        names.insert(std::lower_bound(names.begin(), names.end(), 0.0, [](const auto& name, double t) { return timeValue(name) < t; }),
                     "0");
    if (names.empty())
        return entry::startFrom.error(control_, "the case has no time folder to start from, and no folder 0.orig to make one of");

    auto chosen = startFrom == "firstTime" ? names.begin() : names.end() - 1;
    if (startFrom == "startTime")
    {
        const auto off = [wanted](const std::string& name) { return std::abs(*timeValue(name) - wanted); };
        chosen = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
        // The tolerance is that of the digits of a name written by hand.
        if (off(*chosen) > 1e-10 * std::abs(wanted))
            return entry::startTime.error(control_,
                                          fmt::format("there is no time folder {}. Times: {}.", shortestText(wanted), list(names)));
    }
    if (fromOriginal && *chosen == "0") copyFolder(caseFolder_, originalFolder, "0");
    startName_ = *chosen;
    value_ = *timeValue(startName_);
}

void RunTime::restore(const Case& c)
{
    const auto timeFile = startFolder() + "/uniform/time", stateFile = startFolder() + "/uniform/sphState";
    if (!c.has(timeFile))
    {
        if (c.has(stateFile)) c.diagnostics().warning({timeFile, 0}, fmt::format("is missing: the run starts afresh at {}", startName_));
        return;
    }
    const auto stored = c.dictionary(timeFile);
    const double exact = stored.get<double>("value");
    if (!couldBeNamed(exact, startName_))
    {
        // Copied from another time, as a packed bed that a new run begins with.
        c.diagnostics().warning(stored.where("value"), fmt::format("value {} does not belong to a folder named {}: the run starts "
                                                                   "afresh at {}",
                                                                   shortestText(exact), startName_, startName_));
        return;
    }
    value_ = exact;
    index_ = long(stored.get<double>("index", 0.0));
    if (controls_.adjustTimeStep) deltaT_ = stored.get<double>("deltaT", deltaT_);
    if (!c.has(stateFile))
        c.diagnostics().warning(
            {stateFile, 0},
            "is missing: the run goes on without the numbers that were stored with the fields, not as though it had never stopped");
    const auto state = c.dictionaryIfPresent(stateFile);
    for (const auto& key : state.keys()) restored_[key] = state.get<double>(key);
    const auto seen = c.dictionaryIfPresent(startFolder() + "/uniform/functionObjects");
    for (const auto& key : seen.keys()) histories_[key] = seen.get<std::vector<double>>(key);
}

std::string RunTime::name() const { return index_ == startIndex_ ? startName_ : writeTime() ? folderName() : stepName(); }

std::string RunTime::nameWithDigitsUntil(const std::function<bool(const std::string& candidate, int precision)>& enough) const
{
    constexpr int most = std::numeric_limits<double>::max_digits10;
    int precision = controls_.timePrecision;
    auto candidate = timeName(value_, controls_.timeFormat, precision);
    while (precision < most && !enough(candidate, precision)) candidate = timeName(value_, controls_.timeFormat, ++precision);
    return candidate;
}

std::string RunTime::folderName() const
{
    // 0.3 is 3 times 0.1, whatever the last bit of the product.
    const double same = std::max(1e-10 * deltaT_, 4 * std::numeric_limits<double>::epsilon() * std::abs(value_));
    return nameWithDigitsUntil(
        [&](const std::string& candidate, int)
        {
            const auto at = named_.find(candidate);
            const bool isTaken = at != named_.end() && at->second != value_;
            return !isTaken && std::abs(*timeValue(candidate) - value_) <= same;
        });
}

std::string RunTime::stepName() const
{
    const double before = value_ - deltaT_;
    return nameWithDigitsUntil([&](const std::string& candidate, int precision)
                               { return candidate != timeName(before, controls_.timeFormat, precision); });
}

bool RunTime::running() const { return !stopped_ && controls_.before(value_); }

double RunTime::nextDeltaT(double limit) const
{
    const bool isFirst = index_ == 0 && controls_.adjustTimeStep && controls_.deltaT > 0;
    const double step = controls_.step(value_, isFirst ? std::min(limit, controls_.deltaT) : limit);
    if (!(limit > 0)) throw CaseError(fmt::format("at time {} the limit of the time step is {}", name(), limit));
    if (!std::isfinite(step)) throw CaseError({controlDictFile, 0}, "nothing limits the time step: give maxDeltaT");
    return step;
}

void RunTime::advance(double deltaT)
{
    const double before = value_;
    value_ = controls_.advanced(before, deltaT);
    if (!(value_ > before))
        throw CaseError(fmt::format("a time step of {} s is too small to advance time {} s", deltaT, shortestText(before)));
    deltaT_ = deltaT;
    ++index_;
    switch (controls_.writeControl)
    {
    case WriteControl::none:
        scheduled_ = false;
        break;
    case WriteControl::timeStep:
        scheduled_ = std::fmod(double(index_), controls_.writeInterval) == 0;
        break;
    case WriteControl::runTime:
    case WriteControl::adjustable:
        scheduled_ = controls_.writeIndex(value_) > controls_.writeIndex(before);
        break;
    case WriteControl::clockTime:
    case WriteControl::cpuTime:
        scheduled_ = writesByClock();
        break;
    }
    if (controls_.stopAt == StopAt::nextWrite) stopped_ |= scheduled_;
    if (controls_.stopAt == StopAt::writeNow || controls_.stopAt == StopAt::noWriteNow) stopped_ = true;
    if (clocks_.wall() > controls_.maxClockTime) stopped_ = true;
}

double RunTime::clock() const { return controls_.writeControl == WriteControl::cpuTime ? clocks_.processor() : clocks_.wall(); }

bool RunTime::writesByClock()
{
    const double index = std::floor(clock() / controls_.writeInterval);
    return index > std::exchange(clockIndex_, index);
}

void RunTime::useClocks(Clocks clocks) { clocks_ = std::move(clocks); }

void RunTime::stopNow() { stopped_ = true; }

bool RunTime::writeTime() const
{
    if (index_ == startIndex_ || controls_.stopAt == StopAt::noWriteNow) return false;
    return scheduled_ || !running();
}

void RunTime::write(const std::function<void(const std::filesystem::path& folder)>& fill, const StateNumbers& state,
                    const Histories& histories)
{
    // Partial folders stay when the run starts: a utility that only reads times must not take away what a solver beside it is writing.
    if (written_.empty()) byFirst([&] { removePartialFolders(timesFolder()); });
    const auto time = index_ == startIndex_ ? startName_ : folderName();
    const auto writeUniform = [&](const std::filesystem::path& folder)
    {
        const auto timeText = fmt::format("value           {};\nname            \"{}\";\nindex           {};\n"
                                          "deltaT          {};\ndeltaT0         {};\n",
                                          shortestText(value_), time, index_, shortestText(deltaT_), shortestText(deltaT_));
        createFolders(folder / "uniform");
        writeFile(folder / "uniform" / "time", uniformFile(time, "time", timeText));
        writeFile(folder / "uniform" / "sphState", uniformFile(time, "sphState", inWords(state)));
        if (!histories.empty()) writeFile(folder / "uniform" / "functionObjects", uniformFile(time, "functionObjects", inWords(histories)));
    };
    writeFolder(timesFolder(), time,
                [&](const std::filesystem::path& folder)
                {
                    fill(folder);
                    byFirst([&] { writeUniform(folder); });
                    barrier_();
                });
    barrier_();
    named_[time] = value_;
    std::erase(written_, time);
    written_.push_back(time);
    purge();
}

void RunTime::purge()
{
    while (controls_.purgeWrite > 0 && written_.size() > std::size_t(controls_.purgeWrite))
    {
        if (written_.front() != startName_ && timeValue(written_.front()) != 0)
            byFirst([&] { removeFolder(timesFolder(), written_.front()); });
        written_.erase(written_.begin());
    }
}

RunTime::FileStamp RunTime::stamp() const
{
    struct stat status;
    if (::stat((caseFolder_ / controlDictFile).c_str(), &status) != 0) return {};
    return {status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

bool RunTime::controlDictModified() const
{
    if (!controls_.runTimeModifiable) return false;
    // An editor that writes anew may have taken the file away for a moment: that is no modification yet.
    const auto now = stamp();
    return now != FileStamp{} && now != stamp_;
}

std::string RunTime::rereadIfModified()
{
    if (!controlDictModified()) return "";
    // The stamp is taken before reading: a change meanwhile is seen the next time.
    stamp_ = stamp();
    const auto mistakes = std::make_shared<Diagnostics>();
    const auto control = Dictionary::read(caseFolder_, controlDictFile, mistakes);
    const auto next = TimeControls::read(control);
    try
    {
        mistakes->throwIfAny();
    }
    catch (const CaseError& e)
    {
        return fmt::format("{} has changed, but not all of it can be understood. The run goes on as before.\n{}", controlDictFile,
                           e.what());
    }
    const auto former = controls_.inWords(), now = next.inWords();
    std::string changes;
    for (std::size_t k = 0; k < now.size(); ++k)
        if (now[k] != former[k])
            changes += fmt::format("{}{} {} -> {}", changes.empty() ? "" : ", ", now[k].first, former[k].second, now[k].second);
    controls_ = next;
    if (!controls_.adjustTimeStep) deltaT_ = controls_.deltaT;
    // Writes by the clock are counted on from now, whatever the interval was.
    if (controls_.writeControl == WriteControl::clockTime || controls_.writeControl == WriteControl::cpuTime)
        clockIndex_ = std::floor(clock() / controls_.writeInterval);
    return fmt::format("{} has changed: {}", controlDictFile, changes.empty() ? "nothing that matters here" : changes);
}

std::filesystem::path RunTime::outputFile(const std::string& function, const std::string& file) const
{
    const auto folder = caseFolder_ / "postProcessing" / function / startName_;
    createFolders(folder);
    const auto path = folder / file;
    if (!std::filesystem::exists(path)) return path;
    return folder / fmt::format("{}_{}{}", path.stem().string(), startName_, path.extension().string());
}

}
