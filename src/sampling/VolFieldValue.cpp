#include "VolFieldValue.hpp"
#include "SampledField.hpp"
#include "contains.hpp"
#include "readBox.hpp"
#include "sharedEntries.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace entry
{
const Choice operation{"operation", {{"volAverage", "sum V f/sum V"}, "min", "max"}, required, "what is taken of the particles in the box"};
}

VolFieldValue::VolFieldValue(const Dictionary& d, const FunctionContext& context)
    : context_(context),
      box_(readBox(d, context.geometry)),
      fields_(entry::fields(d)),
      fieldsWhere_(entry::fields.where(d)),
      operation_(entry::operation(d))
{}

EntryList VolFieldValue::entries() { return {entry::fields, entry::operation, entry::min, entry::max}; }

double VolFieldValue::value(const ParticleView& view, const double* field) const
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double sum = 0, volume = 0, least = infinity, most = -infinity;
    for (std::size_t i = 0; i < view.n; ++i)
    {
        if (!contains(box_, position(view, i), view.dimension)) continue;
        sum += view.volume[i]*field[i];
        volume += view.volume[i];
        least = std::min(least, field[i]);
        most = std::max(most, field[i]);
    }
    if (!(volume > 0)) return std::numeric_limits<double>::quiet_NaN();
    return operation_ == "volAverage" ? sum/volume : operation_ == "min" ? least : most;
}

void VolFieldValue::execute(const ParticleView& view)
{
    columns_.clear();
    values_.clear();
    for (const auto& name : fields_)
    {
        const SampledField field(view, name, fieldsWhere_);
        const auto names = columnNames(field);
        for (int c = 0; c < field.components(); ++c)
        {
            if (!field.array(c)) continue; // z in 2-D
            columns_.push_back(names[std::size_t(c)]);
            values_.push_back(value(view, field.array(c)));
        }
    }
    if (!table_) table_.emplace(context_.file("volFieldValue.dat"), std::vector<std::string>{operation_}, columns_);
    table_->row(view.time, values_);
}

std::string VolFieldValue::report() const
{
    auto line = fmt::format("{}: {}", context_.name, operation_);
    for (std::size_t k = 0; k < columns_.size(); ++k) line += fmt::format("{} {} {:.6g}", k ? "," : "", columns_[k], values_[k]);
    return line;
}

}
