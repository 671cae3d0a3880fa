#include "Errors.hpp"
#include "CsvReference.hpp"
#include "ExpressionReference.hpp"
#include "Formulas.hpp"
#include "Measurement.hpp"
#include "knownWord.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

std::optional<ErrorRow> compareMeasure(const std::string& name, const Measurement& m, bool relative)
{
    if (std::isnan(m.reference)) return {};
    const double difference = std::abs(m.value - m.reference),
                 error = relative ? relativeTo(std::abs(m.reference), difference) : difference;
    return ErrorRow{name, {error, error, error}, m.particles, m.value, m.reference, m.note};
}

}

Errors::Errors(const Dictionary& d, const FunctionContext& context) : context_(context)
{
    if (!d.found("fields"))
        readComparison(d);
    else
        for (const auto& comparison : d.dictionaries("fields")) readComparison(comparison);
}

void Errors::readComparison(const Dictionary& d)
{
    const auto reference = d.subDict("reference");
    const auto leaveRest = [&d]
    {
        for (const auto& key : d.keys()) d.ignore(key);
    };
    const std::vector<std::string> types{"formula", "csv", "expression"};
    const auto type = knownWord(reference, "type", types);
    if (type == "csv")
    {
        auto csv = CsvReference(reference, context_.output.caseFolder(context_.name));
        comparisons_.push_back(FieldComparison(d, context_,
                                               [csv](const Vector<3>& x, double t) -> std::optional<Vector<3>>
                                               {
                                                   const auto value = csv(x, t);
                                                   return value ? std::optional(Vector<3>{*value, 0, 0}) : std::nullopt;
                                               },
                                               csv.rows()));
    }
    if (type == "expression") comparisons_.push_back(FieldComparison(d, context_, readExpressionReference(reference)));
    if (!type) leaveRest();
    if (type != "formula") return;

    const auto measures = measureNames();
    auto names = formulaNames();
    names.insert(names.end(), measures.begin(), measures.end());
    const auto chosen = knownWord(reference, "name", names);
    if (!chosen) return leaveRest();
    const auto name = *chosen;
    if (std::ranges::find(measures, name) != measures.end())
    {
        const auto measure = readMeasure(name, reference, context_.geometry, context_.phases,
                                         context_.output.caseFolder(context_.name));
        const bool relative = readsRelative(d);
        comparisons_.push_back([=](const ParticleView& view) { return compareMeasure(name, measure(view), relative); });
        return;
    }
    const auto exact = readFormula(name, reference, d.get<std::string>("field"));
    const auto component = d.get("component", "");
    comparisons_.push_back(FieldComparison(d, context_,
                                           [=](const Vector<3>& x, double t) -> std::optional<Vector<3>>
                                           {
                                               const auto v = exact(x, t);
                                               return component == "y"   ? Vector<3>{v.y, 0, 0}
                                                      : component == "z" ? Vector<3>{v.z, 0, 0}
                                                      : component == "x" ? Vector<3>{v.x, 0, 0}
                                                                         : v;
                                           }));
}

void Errors::execute(const ParticleView& view)
{
    report_.clear();
    for (const auto& comparison : comparisons_)
    {
        const auto row = comparison(view);
        if (!row) continue;
        if (!table_)
            table_.emplace(
                context_.file("errors.dat"), std::vector<std::string>{},
                std::vector<std::string>{"field", "L1", "L2", "Linf", "nParticles", "executionTime", "value", "reference"});
        table_->row(view.time, std::vector<std::string>{row->field, cell(row->error.L1), cell(row->error.L2),
                                                        cell(row->error.Linf), fmt::format("{}", row->particles),
                                                        cell(view.executionTime), cell(row->value), cell(row->reference)});
        report_ += fmt::format("{}{}: {} L2 {:.4g} Linf {:.4g}{}{}", report_.empty() ? "" : "\n", context_.name, row->field,
                               row->error.L2, row->error.Linf, row->note.empty() ? "" : "; ", row->note);
    }
}

}
