#include "sampling/VolFieldValue.hpp"
#include "geometry/contains.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/readBox.hpp"
#include "sampling/sharedEntries.hpp"
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace entry
{
const Choice operation{"operation", {{"volAverage", "sum V f/sum V"}, "min", "max"}, required, "what is taken of the particles in the box"};
}

namespace column
{
const Column valueInBox{"<field>", "of the field",
                        "its mean, least or largest value in the box, by `operation`; of a vector or tensor one column a component, U_x"};
}

VolFieldValue::VolFieldValue(const Dictionary& d, const FunctionContext& context)
    : context_(context),
      box_(readBox(d, context.geometry)),
      fields_(entry::fields(d)),
      fieldsWhere_(entry::fields.where(d)),
      operation_(entry::operation(d))
{}

EntryList VolFieldValue::entries() { return {entry::fields, entry::operation, entry::min, entry::max}; }

TableInfo VolFieldValue::table()
{
    return {"volFieldValue", "volFieldValue.dat", "means, least or largest values in a box", {column::valueInBox}};
}

double VolFieldValue::value(const ParticleView& view, const double* field) const
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto inBox = [&](std::size_t i) { return view.inScene(i) && contains(box_, position(view, i), view.dimension); };
    const auto mean = sum(view.n, [&](std::size_t i) { return inBox(i) ? VolumeMean<>::of(view.volume[i], field[i]) : VolumeMean<>{}; });
    if (mean.particles == 0 || operation_ == "volAverage") return mean.value();
    return operation_ == "min" ? least(view.n, [&](std::size_t i) { return inBox(i) ? field[i] : infinity; })
                               : most(view.n, [&](std::size_t i) { return inBox(i) ? field[i] : -infinity; });
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
            columns_.push_back(column::valueInBox.of(names[std::size_t(c)]));
            values_.push_back(value(view, field.array(c)));
        }
    }
    if (!table_) table_.emplace(context_.file("volFieldValue.dat"), std::vector<std::string>{operation_}, columns_);
    table_->row(view.time, values_);
}

std::string VolFieldValue::report() const
{
    auto line = fmt::format("{}: {}", context_.name, operation_);
    for (std::size_t k = 0; k < columns_.size(); ++k) line += fmt::format("{} {} {:.6g}", k ? "," : "", columns_[k].name, values_[k]);
    return line;
}

}
