#include "sampling/CsvReference.hpp"
#include "base/csv.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include "sampling/sharedEntries.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace sph
{

namespace entry
{
const FileName file{"file", "", required, "table, relative to the case; its first line names the columns, # begins a note"};
const SubDictionary columns{"columns", required, "names of the columns"}, units{"units", byScene("1 each"), "SI value of 1 in each column"},
    select{"select", byScene("all rows"), "only the rows that have these words or numbers"};
const Word coordinate{"coordinate", required, "column of the coordinate"},
    csvTime{"time", byScene("none: a steady reference"), "column of the time"}, timeAlone{"time", required, "column of the time"},
    csvValue{"value", required, "column of the value"};
const Scalar coordinateUnit{"coordinate", Unit{sph::units::none, "SI"}, 1, "of the coordinate"},
    timeUnit{"time", Unit{sph::units::none, "SI"}, 1, positive, "of the time"},
    valueUnit{"value", Unit{sph::units::none, "SI"}, 1, "of the value"};
const FreeName column{"<column>", "word or number", "what the column must hold"};
const Direction axis{"axis", byScene("that of the coordinate column x, y or z"), "coordinate of a point: (point - origin).axis"};
const Switch mirror{"mirror", false, "take the coordinate's absolute value, for profiles given from the middle"};
const Choice interpolation{"interpolation", {"linear", {"cubic", "through the four nearest rows"}}, "linear", "between the rows"};
}

namespace
{

/// Lagrange's polynomial through `count` (2 or 4) points of ascending x around `at`.
double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at, std::size_t count)
{
    count = std::min(count, x.size());
    const auto above = std::size_t(std::upper_bound(x.begin(), x.end(), at) - x.begin());
    const auto first = std::min(above > count / 2 ? above - count / 2 : 0, x.size() - count);
    double sum = 0;
    for (auto i = first; i < first + count; ++i)
    {
        double term = y[i];
        for (auto k = first; k < first + count; ++k)
            if (k != i) term *= (at - x[k]) / (x[i] - x[k]);
        sum += term;
    }
    return sum;
}

}

CsvReference::CsvReference(const Dictionary& d, const std::filesystem::path& caseFolder, Over over) : over_(over)
{
    if (over == Over::space)
    {
        origin_ = entry::origin(d);
        mirror_ = entry::mirror(d);
    }
    cubic_ = entry::interpolation(d) == "cubic";
    read(d, caseFolder);
}

EntryList CsvReference::entries(Over over)
{
    const EntryList rest{{entry::select, {entry::column}}, entry::interpolation};
    if (over == Over::time)
        return EntryList{entry::file,
                         {entry::columns, {entry::timeAlone, entry::csvValue}},
                         {entry::units, {entry::timeUnit, entry::valueUnit}}} +
               rest;
    return EntryList{entry::file,
                     {entry::columns, {entry::coordinate, entry::csvTime, entry::csvValue}},
                     {entry::units, {entry::coordinateUnit, entry::timeUnit, entry::valueUnit}},
                     entry::axis,
                     entry::origin,
                     entry::mirror} +
           rest;
}

void CsvReference::read(const Dictionary& d, const std::filesystem::path& caseFolder)
{
    const auto fileName = entry::file(d);
    const auto columns = entry::columns(d);
    const bool inSpace = over_ == Over::space;
    const Word& coordinateWord = inSpace ? entry::coordinate : entry::timeAlone;
    const auto coordinateName = coordinateWord(columns), valueName = entry::csvValue(columns);
    const auto timeName = inSpace ? entry::csvTime(columns, "") : "";
    steady_ = timeName.empty();
    if (inSpace)
        axis_ = entry::axis(d, coordinateName == "x"   ? Vector<3>{1, 0, 0}
                               : coordinateName == "z" ? Vector<3>{0, 0, 1}
                                                       : Vector<3>{0, 1, 0});
    if (inSpace && !entry::axis.given(d) && coordinateName != "x" && coordinateName != "y" && coordinateName != "z")
        entry::axis.error(d, fmt::format("axis is needed: coordinate column \"{}\" does not say x, y or z", coordinateName));

    const auto unitsOf = entry::units(d);
    const double coordinateUnit = (inSpace ? entry::coordinateUnit : entry::timeUnit)(unitsOf),
                 timeUnit = inSpace ? entry::timeUnit(unitsOf) : 1, valueUnit = entry::valueUnit(unitsOf);
    for (const auto* unit : {inSpace ? &entry::coordinateUnit : &entry::timeUnit, &entry::valueUnit})
        if ((*unit)(unitsOf) == 0) unit->error(unitsOf, "must not be 0");
    const auto select = entry::select(d);
    std::map<std::string, std::string> wanted;
    for (const auto& key : select.keys()) wanted[key] = select.get<std::string>(key);
    if (fileName.empty() || coordinateName.empty() || valueName.empty()) return;

    std::string reason;
    const auto text = readText(caseFolder / fileName, reason);
    if (!text) return entry::file.error(d, fmt::format("cannot read {}: {}", fileName, reason));
    CsvLines lines(*text);
    const auto header = lines.next().value_or(std::vector<std::string>{});
    if (header.empty()) return entry::file.error(d, fmt::format("cannot read {}: it is empty", fileName));
    const auto column = [&](const Dictionary& asked, const std::string& key, const std::string& name)
    {
        const auto found = std::find(header.begin(), header.end(), name);
        if (found == header.end())
            asked.error(key, fmt::format("{} has no column \"{}\". {}", fileName, name, suggestion(name, "columns", header)));
        return std::size_t(found - header.begin());
    };
    const auto c = column(columns, coordinateWord.keyword(), coordinateName), v = column(columns, entry::csvValue.keyword(), valueName);
    const auto t = steady_ ? 0 : column(columns, entry::csvTime.keyword(), timeName);
    std::map<std::size_t, std::string> filter;
    for (const auto& [key, word] : wanted) filter[column(select, key, key)] = word;
    if (std::max({c, v, t}) >= header.size() || filter.contains(header.size())) return;

    std::map<double, std::map<double, double>> table;
    while (const auto row = lines.next())
    {
        const auto& cells = *row;
        const Location here{fileName, lines.number()};
        if (cells.size() != header.size())
        {
            d.diagnostics().error(here, fmt::format("{} cells under {} columns", cells.size(), header.size()));
            continue;
        }
        if (!std::ranges::all_of(filter, [&](const auto& f) { return sameCell(cells[f.first], f.second); })) continue;
        const auto number_ = [&](std::size_t k)
        {
            const auto value = finiteNumber(cells[k]);
            if (!value) d.diagnostics().error(here, fmt::format("\"{}\" in column {} is not a number", cells[k], header[k]));
            return value.value_or(0);
        };
        const double time = steady_ ? 0 : timeUnit * number_(t), coordinate = coordinateUnit * number_(c);
        if (!table[time].emplace(coordinate, valueUnit * number_(v)).second)
            d.diagnostics().error(here,
                                  fmt::format("a second value at {} = {}: say by `select` which rows are meant", coordinateName, cells[c]));
    }
    for (const auto& [time, rows] : table)
    {
        Profile profile;
        for (const auto& [coordinate, value] : rows)
        {
            profile.coordinate.push_back(coordinate);
            profile.value.push_back(value);
        }
        if (rows.size() < 2) entry::file.error(d, fmt::format("{} has only one row at {} = {}", fileName, timeName, time / timeUnit));
        profiles_.push_back(std::move(profile));
        times_.push_back(time);
    }
    if (profiles_.empty()) d.error(wanted.empty() ? "file" : "select", fmt::format("no row of {} is selected", fileName));
}

std::optional<double> CsvReference::at(double coordinate, double t) const
{
    const std::size_t points = cubic_ ? 4 : 2;
    const auto in = [&](const Profile& profile) -> std::optional<double>
    {
        const auto& x = profile.coordinate;
        if (x.size() < 2) return {};
        if (over_ == Over::time && (coordinate < x.front() || coordinate > x.back())) return {};
        if (coordinate < 2 * x[0] - x[1] || coordinate > 2 * x.back() - x[x.size() - 2]) return {};
        // The curve is a straight line beyond the ends: a cubic may overshoot there.
        const bool outside = coordinate < x.front() || coordinate > x.back();
        return interpolate(x, profile.value, coordinate, outside ? 2 : points);
    };
    if (profiles_.empty()) return {};
    if (steady_) return in(profiles_.front());

    const double slack = 1e-9 * (times_.back() - times_.front() + std::abs(times_.back())); // round-off of a sum of time steps
    if (t < times_.front() - slack || t > times_.back() + slack) return {};
    const auto above = std::size_t(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
    const auto count = std::min(points, times_.size());
    const auto first = std::min(above > count / 2 ? above - count / 2 : 0, times_.size() - count);
    const std::vector<double> nearTimes(times_.begin() + long(first), times_.begin() + long(first + count));
    std::vector<double> values;
    for (auto k = first; k < first + count; ++k)
    {
        const auto value = in(profiles_[k]);
        if (!value) return {};
        values.push_back(*value);
    }
    return interpolate(nearTimes, values, t, points);
}

std::optional<double> CsvReference::operator()(const Vector<3>& x, double t) const
{
    const double coordinate = dot(x - origin_, axis_);
    return at(mirror_ ? std::abs(coordinate) : coordinate, t);
}

std::vector<Vector<3>> CsvReference::rows() const
{
    std::set<double> places;
    for (const auto& profile : profiles_) places.insert(profile.coordinate.begin(), profile.coordinate.end());
    std::vector<Vector<3>> points;
    for (const double c : places) points.push_back(origin_ + c * axis_);
    return points;
}

}
