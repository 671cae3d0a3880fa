#include "sampling/Contour.hpp"
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace entry
{
const ListOf<double> stations{"stations", units::m, std::vector<double>{}, "coordinates along `direction` whose arrival times are found"};
}

namespace column
{
const Column arrival{"arrival_<k>", "s", "when `front` first was past the k-th of `stations`, from 0 on"};
}

namespace
{

/// Columns of an object that has a wall or not.
std::vector<ContourFigure> shown(bool hasWall)
{
    std::vector<ContourFigure> figures;
    for (const auto& f : contourFigures())
        if (hasWall || f.column.name != "angle") figures.push_back(f);
    return figures;
}

}

Contour::Contour(const Dictionary& d, const FunctionContext& context) : context_(context), shape_(d, context), stations_(entry::stations(d))
{}

EntryList Contour::entries() { return ContourShape::entries() + EntryList{entry::stations}; }

TableInfo Contour::table()
{
    TableInfo table{"contour", "contour.dat", "shape of a level set, or of the surface of a phase, and how far it has come", {}};
    for (const auto& f : contourFigures()) table.columns.push_back(f.column);
    table.columns.push_back(column::arrival);
    return table;
}

void Contour::execute(const ParticleView& view)
{
    last_ = shape_(view);
    std::vector<Column> columns;
    std::vector<double> values;
    for (const auto& f : shown(shape_.hasWall()))
    {
        columns.push_back(f.column);
        values.push_back(f.of(last_));
    }
    if (!stations_.empty()) fronts_.add(view.time, last_.front);
    for (std::size_t k = 0; k < stations_.size(); ++k)
    {
        columns.push_back(column::arrival.of(fmt::format("{}", k)));
        values.push_back(fronts_.passage(stations_[k]));
    }
    if (!table_) table_.emplace(context_.file("contour.dat"), std::vector<std::string>{}, columns);
    table_->row(view.time, values);
}

std::string Contour::report() const
{
    if (std::isnan(last_.front))
        return fmt::format("{}: nothing is at {:.6g}; values lie between {:.6g} and {:.6g}", context_.name, shape_.level(), last_.least,
                           last_.most);
    auto line = fmt::format("{}: area {:.6g}, volume {:.6g}, front {:.6g}, radius {:.6g}", context_.name, last_.area, last_.volume,
                            last_.front, last_.radius);
    if (shape_.hasWall()) line += fmt::format(", angle {:.4g}", last_.angle);
    return line;
}

Histories Contour::histories() const
{
    if (fronts_.times.empty()) return {};
    return {{"t", fronts_.times}, {"front", fronts_.values}};
}

void Contour::restore(const Histories& stored)
{
    const auto times = stored.find("t"), values = stored.find("front");
    if (times == stored.end() || values == stored.end()) return;
    fronts_.times = times->second;
    fronts_.values = values->second;
}

}
