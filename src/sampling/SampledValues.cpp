#include "sampling/SampledValues.hpp"
#include "dictionary/EntryList.hpp"
#include "sampling/SampledField.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const ListOf<std::string> fieldsToSample{"fields", byScene("none, where there are `expressions`"), "fields to sample"};
const SubDictionary expressions{"expressions", byScene("none"), "expressions to sample, by names of the case's own"};
const FreeName ownExpression{"<name>", "text in quotes", "an expression of fields, position, time and constants, of a number or a vector"};
}

SampledValues::SampledValues(const Dictionary& d)
    : fields_(entry::expressions.given(d) ? entry::fieldsToSample(d, {}) : entry::fieldsToSample.needed(d)),
      where_(entry::fieldsToSample.where(d))
{
    const auto expressions = entry::expressions(d);
    for (const auto& name : expressions.keys())
    {
        const Text text(name, required, "");
        if (std::ranges::find(fields_, name) != fields_.end())
            text.error(expressions,
                       fmt::format("{} is the name of a field that is sampled as well: give the expression another one", name));
        expressions_.emplace_back(name, ParticleExpression(text, expressions, text.needed(expressions), {}, {},
                                                           ParticleExpression::Gives::numberOrVector));
    }
}

EntryList SampledValues::entries() { return {entry::fieldsToSample, {entry::expressions, {entry::ownExpression}}}; }

std::vector<std::string> SampledValues::names() const
{
    auto names = fields_;
    for (const auto& [name, expression] : expressions_) names.push_back(name);
    return names;
}

std::vector<SampledValues::Value> SampledValues::operator()(const ParticleView& view) const
{
    std::vector<Value> values;
    for (const auto& name : fields_)
    {
        const SampledField field(view, name, where_);
        auto& value = values.emplace_back(Value{name, columnNames(field), {}, {}});
        for (int c = 0; c < field.components(); ++c) value.ofField.push_back(field.array(c));
    }
    for (const auto& [name, expression] : expressions_)
    {
        auto& value = values.emplace_back(Value{name, {}, expression.componentsAtParticles(view), {}});
        for (const auto c : componentNames(value.rows.size() == 1 ? FieldClass::scalar : FieldClass::vector))
            value.columns.push_back(c.empty() ? name : fmt::format("{}_{}", name, c));
    }
    return values;
}

}
