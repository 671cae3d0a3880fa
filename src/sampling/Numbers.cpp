#include "sampling/Numbers.hpp"
#include "geometry/contains.hpp"
#include "geometry/forEachFoot.hpp"
#include "geometry/wallNames.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/readBox.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace sph
{

namespace entry
{
const SubDictionary numbers{"numbers", byScene("none"), "numbers by names of the case's own, found in the order in which they stand"};
const FreeName ownNumber{"<number>", "dictionary", "a number; its name is that of its column, and $name in what stands below it"};
const Choice reduction{"operation",
                       {{"formula", "none: `value` is one of the numbers above, of the time and of constants"},
                        {"sum", "sum f"},
                        {"mean", "sum w f/sum w"},
                        "min",
                        "max",
                        {"percentile", "least value with a share of the weight at or below it"},
                        {"timeMean", "mean of a formula over the rows"},
                        {"arrival", "time at which a formula goes past a level"},
                        {"fit", "a constant of a law that is fitted to the history of a formula"},
                        {"contour", "a figure of a level set's shape"}}, // in the order of Numbers::Operation
                       "formula",
                       "what makes one number of those of the particles, or of the rows so far"};
const Text numberValue{"value", required, "expression of fields, position, time, constants and the numbers above"},
    weight{"weight", byScene("\"$volume\""), "expression of the weight w"},
    where{"where", notGiven, "expression: particles count where it is not 0"};
const Scalar percent{"percent", Unit{units::none, "%"}, required, between(0, 100), "share of the weight"},
    numberLevel{"level", Unit{units::none, "of the value"}, required, "level that is reached, from below or from above"},
    within{"within", Unit{units::none, "spacings"}, 1, positive, "of `wall`: particles count that are nearer to it"};
const Word phaseOfNumber{"phase", byScene("all"), "its particles count alone"},
    wallOfNumber{"wall", notGiven, "particles count that are beside it"};

static Choice figure()
{
    ChoiceWords words;
    for (const auto& f : contourFigures()) words.push_back({f.column.name, f.column.meaning});
    return {"gives", words, required, "figure of the contour"};
}
const SubDictionary regionOfNumber{"region", byScene("everywhere"), "particles count within this box"};
}

bool Numbers::given(const Dictionary& d) { return entry::numbers.given(d); }

Dictionary Numbers::of(const Dictionary& d, const std::string& name) { return entry::numbers(d).subDict(name); }

EntryList Numbers::entries(const EntryList& beside)
{
    const EntryList choice{
        entry::where, entry::phaseOfNumber, {entry::regionOfNumber, {entry::min, entry::max}}, entry::wallOfNumber, entry::within};
    const auto weighed = EntryList{entry::weight} + choice;
    const EntryList value{entry::numberValue}, span{entry::from, entry::to};
    const EntryList number{{entry::reduction,
                            {{"formula", value},
                             {"sum", value + choice},
                             {"mean", value + weighed},
                             {"min", value + choice},
                             {"max", value + choice},
                             {"percentile", value + EntryList{entry::percent} + weighed},
                             {"timeMean", value + span},
                             {"arrival", value + EntryList{entry::numberLevel} + span},
                             {"fit", value + HistoryFit::entries() + span},
                             {"contour", EntryList{entry::figure()} + ContourShape::entries()}}}};
    return {{entry::numbers, {{entry::ownNumber, number + beside}}}};
}

Numbers::Numbers(const Dictionary& dict, const FunctionContext& context)
{
    const auto numbers = entry::numbers.needed(dict);
    const auto keys = numbers.keys();
    const auto walls = wallNames(context.geometry);
    std::vector<std::string> above, below(keys.begin(), keys.end());
    for (const auto& name : keys)
    {
        if (!numbers.isDictionary(name))
        {
            numbers.ignore(name);
            numbers.error(name, fmt::format("{} must be a dictionary: {} {{ operation mean; value \"$p\"; }}", name, name));
            continue;
        }
        if (name.find_first_of("\t\n") != name.npos) numbers.error(name, "heads a column of a table, which tabs part: a name without them");
        const auto d = numbers.subDict(name);
        const auto expression = [&](const Text& entry, const std::string& text)
        { return ParticleExpression(entry, d, text, above, below); };
        const auto operation = Operation(entry::reduction.index(d));
        Number number;
        number.name = name;
        number.operation = operation;
        if (operation == Operation::contour)
        {
            const auto figure = entry::figure();
            number.figure = std::size_t(figure.index(d));
            number.contour.emplace(d, context, above, below);
            if (figure(d) == "angle" && !number.contour->hasWall())
                figure.error(d, "the angle is that with a wall: name it, `wall floor;`");
        }
        else number.value = expression(entry::numberValue, entry::numberValue(d));
        if (number.isOverTime())
        {
            number.history = History(d);
            if (operation == Operation::arrival) number.level = entry::numberLevel(d);
            if (operation == Operation::fit) number.fit.emplace(d);
        }
        else if (operation != Operation::formula && operation != Operation::contour)
        {
            if (operation == Operation::mean || operation == Operation::percentile)
                number.weight = expression(entry::weight, entry::weight(d, "$volume"));
            if (operation == Operation::percentile) number.percent = entry::percent(d);
            if (entry::where.given(d)) number.condition = expression(entry::where, entry::where.needed(d));
            if (entry::phaseOfNumber.given(d))
            {
                const auto phase = entry::phaseOfNumber.among(d, context.phases);
                number.phase = std::size_t(std::ranges::find(context.phases, phase) - context.phases.begin());
            }
            if (entry::regionOfNumber.given(d)) number.region = readBox(entry::regionOfNumber(d), context.geometry);
            if (entry::wallOfNumber.given(d))
            {
                number.wall = int(std::ranges::find(walls, entry::wallOfNumber.among(d, walls)) - walls.begin());
                number.within = entry::within(d);
            }
        }
        numbers_.push_back(std::move(number));
        above.push_back(name);
        below.erase(below.begin());
    }
}

std::vector<std::string> Numbers::names() const
{
    std::vector<std::string> all;
    for (const auto& n : numbers_) all.push_back(n.name);
    return all;
}

std::vector<char> Numbers::chosen(const Number& number, const ParticleView& view, const NamedNumbers& known)
{
    std::vector<double> condition;
    if (number.condition) condition = number.condition->atParticles(view, known);
    const auto isBeside = [&](std::size_t i)
    {
        const auto [foot, patch] = nearestFoot(*view.geometry, position(view, i));
        return patch >= 0 && view.geometry->patches[std::size_t(patch)].wall == *number.wall &&
               foot.distance < number.within * view.spacing;
    };
    std::vector<char> result(view.n);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < view.n; ++i)
        result[i] = view.inScene(i) && (!number.phase || phaseOf(view, i) == *number.phase) &&
                    (!number.region || contains(*number.region, position(view, i), view.dimension)) &&
                    (condition.empty() || (condition[i] != 0 && !std::isnan(condition[i]))) && (!number.wall || isBeside(i));
    return result;
}

NamedNumber Numbers::reduced(const Number& number, const ParticleView& view, const NamedNumbers& known)
{
    constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    const auto f = number.value->atParticles(view, known);
    const auto isChosen = chosen(number, view, known);
    const auto particles = count(view.n, [&](std::size_t i) { return isChosen[i] != 0; });
    const auto is = [&](double value) { return NamedNumber{number.name, value, particles}; };
    if (number.operation == Operation::sum) return is(sum(view.n, [&](std::size_t i) { return isChosen[i] ? f[i] : 0; }));
    if (particles == 0) return is(nan);
    const auto least = [&] { return sph::least(view.n, [&](std::size_t i) { return isChosen[i] ? f[i] : infinity; }); };
    const auto mostUpTo = [&](double bound)
    { return most(view.n, [&](std::size_t i) { return isChosen[i] && !(f[i] > bound) ? f[i] : -infinity; }); };
    if (number.operation == Operation::min) return is(least());
    if (number.operation == Operation::max) return is(mostUpTo(infinity));

    const auto w = number.weight->atParticles(view, known);
    if (number.operation == Operation::mean)
        return is(sum(view.n, [&](std::size_t i) { return isChosen[i] ? VolumeMean<>::of(w[i], f[i]) : VolumeMean<>{}; }).value());

    const auto weightUpTo = [&](double bound)
    { return sum(view.n, [&](std::size_t i) { return isChosen[i] && f[i] <= bound ? w[i] : 0; }); };
    double low = least(), high = mostUpTo(infinity);
    constexpr double roundOff = 1e-12; // of sums: ten particles of a hundred are 10 %
    const double wanted = (1 - roundOff) * number.percent / 100 * weightUpTo(high);
    if (!(low < high) || weightUpTo(low) >= wanted) return is(low);
    constexpr int halvings = 64; // more than a double has digits
    for (int k = 0; k < halvings; ++k)
    {
        const double middle = low + 0.5 * (high - low);
        (weightUpTo(middle) >= wanted ? high : low) = middle;
    }
    return is(mostUpTo(high));
}

NamedNumber Numbers::Number::overTime(const ParticleView& view, double now)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    history.add(view.time, now);
    const auto &t = history.times, &a = history.values;
    const auto is = [&](double found) { return NamedNumber{name, found, view.n, operation != Operation::timeMean || !t.empty()}; };
    if (operation == Operation::timeMean) return is(t.empty() ? nan : std::accumulate(a.begin(), a.end(), 0.0) / double(a.size()));
    if (operation == Operation::fit) return is((*fit)(history));
    return is(history.passage(level));
}

NamedNumbers Numbers::operator()(const ParticleView& view)
{
    NamedNumbers known;
    for (auto& number : numbers_)
    {
        if (number.contour)
        {
            const auto figures = (*number.contour)(view, known);
            known.push_back({number.name, contourFigures()[number.figure].of(figures), figures.places});
            continue;
        }
        if (number.operation != Operation::formula && !number.isOverTime())
        {
            known.push_back(reduced(number, view, known));
            continue;
        }
        const double value = number.value->ofScene(view, known);
        const double now =
            std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value; // without a sign, which 0/0 has by the machine
        known.push_back(number.isOverTime() ? number.overTime(view, now) : NamedNumber{number.name, now, view.n});
    }
    return known;
}

Histories Numbers::histories() const
{
    Histories all;
    for (const auto& number : numbers_)
        if (!number.history.times.empty())
        {
            all[number.name + ".t"] = number.history.times;
            all[number.name + ".a"] = number.history.values;
        }
    return all;
}

void Numbers::restore(const Histories& stored)
{
    for (auto& number : numbers_)
    {
        const auto times = stored.find(number.name + ".t"), values = stored.find(number.name + ".a");
        if (times == stored.end() || values == stored.end()) continue;
        number.history.times = times->second;
        number.history.values = values->second;
    }
}

}
