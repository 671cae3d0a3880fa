#include "sampling/Reduction.hpp"
#include <fmt/format.h>

namespace sph
{

namespace column
{
const Column number{"<number>", "of its expression", "a number by the name that the case gives it"};
}

Reduction::Reduction(const Dictionary& d, const FunctionContext& context) : context_(context), numbers_(d, context) {}

EntryList Reduction::entries() { return Numbers::entries(); }

TableInfo Reduction::table()
{
    return {"reduction", "reduction.dat", "numbers of the case's own, reductions of expressions over particles", {column::number}};
}

void Reduction::execute(const ParticleView& view)
{
    last_ = numbers_(view);
    std::vector<Column> columns;
    std::vector<double> values;
    for (const auto& number : last_)
    {
        columns.push_back(column::number.of(number.name));
        values.push_back(number.value);
    }
    if (!table_) table_.emplace(context_.file("reduction.dat"), std::vector<std::string>{}, columns);
    table_->row(view.time, values);
}

std::string Reduction::report() const
{
    auto line = context_.name + ":";
    for (const auto& number : last_) line += fmt::format("{} {} {:.6g}", line.ends_with(':') ? "" : ",", number.name, number.value);
    return line;
}

}
