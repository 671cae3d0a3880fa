#include "sampling/Errors.hpp"
#include "sampling/CsvReference.hpp"
#include "sampling/ExpressionReference.hpp"
#include "sampling/Formulas.hpp"
#include "sampling/Measurement.hpp"
#include "sampling/sharedEntries.hpp"
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace entry
{
const DictionaryList comparisons{"fields", byScene("the one comparison that stands here"),
                                 "several comparisons, each with its own field, reference ..."};
const SubDictionary reference{"reference", required, "what to compare with"};
const Choice type{"type",
                  {{"formula", "an exact solution, or a measure, which needs no field; of a library, as libsphVerification.so"},
                   {"csv", "a table"},
                   {"expression", "of place and time"}},
                  required,
                  "of the reference"};
const SubDictionary numberReference{"reference", byScene("the number is not compared"), "what to compare the number with"};
const Choice typeOfNumbers{"type",
                           {{"csv", "a table of times"}, {"expression", "of $t, of constants and of the numbers up to this one"}},
                           required,
                           "of the reference"};
const Text numberExpression{"value", required, "of $t [s], of constants and of the numbers up to this one"};

/// The words are those that are known now: libraries add to them.
static Choice name()
{
    auto known = wordsOf(formulas() + measures());
    if (known.empty()) known.push_back({"<of a library>"});
    return {"name", known, required, "formula or measure, of a library that `libs` names"};
}
}

namespace column
{
const Column field{"field", "", "field, with its component, or measure that the row is of"},
    L1{"L1", "of the field", "mean of the absolute difference, weighed by volume; with `norm relative` over that of the reference [-]"},
    L2{"L2", "of the field", "root of the mean square difference, likewise"}, Linf{"Linf", "of the field", "largest difference, likewise"},
    compared{"nParticles", "-", "particles, or rows of a table, that were compared"},
    executionTime{"executionTime", "s", "processor time of the run until then"},
    value{"value", "of the field", "L2 norm of the field; of a measure its value"},
    referenceValue{"reference", "of the field", "L2 norm of the reference, or `scale`; of a measure the value that is right"};
const std::vector<Column> ofErrors{field, L1, L2, Linf, compared, executionTime, value, referenceValue};
}

namespace
{

std::optional<ErrorRow> compareMeasure(const std::string& name, const Measurement& m, bool relative)
{
    if (std::isnan(m.reference)) return {};
    const double difference = std::abs(m.value - m.reference), scale = std::abs(m.reference);
    const auto errors = m.errors.value_or(Norms{difference, difference, difference});
    return ErrorRow{name, relative ? relativeTo(Norms{scale, scale, scale}, errors) : errors, m.particles, m.value, m.reference, m.note};
}

}

Errors::Errors(const Dictionary& d, const FunctionContext& context) : context_(context)
{
    if (Numbers::given(d)) readNumbers(d);
    if (!entry::comparisons.given(d) && (entry::reference.given(d) || !numbers_)) readComparison(d);
    for (const auto& comparison : entry::comparisons(d)) readComparison(comparison);
}

EntryList Errors::entries()
{
    return FieldComparison::entries() +
           EntryList{{entry::reference,
                      {{entry::type,
                        {{"formula", {{entry::name(), formulas() + measures()}}},
                         {"csv", CsvReference::entries(CsvReference::Over::space)},
                         {"expression", expressionReferenceEntries()}}}}},
                     entry::comparisons} +
           Numbers::entries({{entry::numberReference,
                              {{entry::typeOfNumbers,
                                {{"csv", CsvReference::entries(CsvReference::Over::time)}, {"expression", {entry::numberExpression}}}}}}});
}

TableInfo Errors::table()
{
    return {"errors", "errors.dat", "errors against exact solutions, tables and measures; a row a time and comparison", column::ofErrors};
}

void Errors::readComparison(const Dictionary& d)
{
    const auto reference = entry::reference(d);
    const auto leaveRest = [&d]
    {
        for (const auto& key : d.keys()) d.ignore(key);
    };
    const auto type = entry::type.known(reference);
    if (type == "csv")
    {
        auto csv = CsvReference(reference, context_.output.caseFolder(context_.name));
        compareField(
            d,
            [csv](const Vector<3>& x, double t) -> std::optional<Vector<3>>
            {
                const auto value = csv(x, t);
                return value ? std::optional(Vector<3>{*value, 0, 0}) : std::nullopt;
            },
            csv.rows());
    }
    if (type == "expression") compareField(d, readExpressionReference(reference));
    if (!type) leaveRest();
    if (type != "formula") return;

    if (formulas().empty() && measures().empty())
    {
        const auto name = entry::name();
        name.error(
            reference,
            fmt::format("formula or measure \"{}\" comes from a library, and none has been loaded: `libs (\"libsphVerification.so\");` in "
                        "system/controlDict loads those of the suite",
                        reference.get(name.keyword(), "")));
        return leaveRest();
    }
    const auto chosen = entry::name().known(reference);
    if (!chosen) return leaveRest();
    const auto name = *chosen;
    if (const auto measure = readMeasure(name, reference, context_.geometry, context_.phases, context_.output.caseFolder(context_.name)))
    {
        const bool relative = readsRelative(d);
        measures_.push_back(measure);
        comparisons_.push_back([=](const ParticleView& view) { return compareMeasure(name, measure(view), relative); });
        return;
    }
    const auto exact = readFormula(name, reference, entry::field(d));
    const auto component = readComponent(d);
    compareField(d,
                 [=](const Vector<3>& x, double t) -> std::optional<Vector<3>>
                 {
                     const auto v = exact(x, t);
                     return component == "y"   ? Vector<3>{v.y, 0, 0}
                            : component == "z" ? Vector<3>{v.z, 0, 0}
                            : component == "x" ? Vector<3>{v.x, 0, 0}
                                               : v;
                 });
}

void Errors::readNumbers(const Dictionary& d)
{
    numbers_.emplace(d, context_);
    const bool relative = readsRelative(d);
    const auto names = numbers_->names();
    for (std::size_t k = 0; k < names.size(); ++k)
    {
        const auto number = Numbers::of(d, names[k]);
        if (!entry::numberReference.given(number)) continue;
        const auto reference = entry::numberReference(number);
        const auto type = entry::typeOfNumbers.known(reference);
        if (!type) continue;
        std::function<double(const ParticleView&)> exact;
        if (*type == "csv")
            exact = [table = CsvReference(reference, context_.output.caseFolder(context_.name), CsvReference::Over::time)](
                        const ParticleView& view) { return table.at(view.time, 0).value_or(std::numeric_limits<double>::quiet_NaN()); };
        else
            exact = [this, expression = ParticleExpression(entry::numberExpression, reference, entry::numberExpression(reference),
                                                           {names.begin(), names.begin() + long(k) + 1},
                                                           {names.begin() + long(k) + 1, names.end()})](const ParticleView& view)
            { return expression.ofScene(view, found_); };
        comparisons_.push_back(
            [this, k, relative, exact](const ParticleView& view) -> std::optional<ErrorRow>
            {
                const auto& found = found_[k];
                if (!found.isThere) return {};
                return compareMeasure(found.name, {found.value, exact(view), found.particles, ""}, relative);
            });
    }
}

void Errors::compareField(const Dictionary& d, ReferenceField reference, const std::vector<Vector<3>>& rows)
{
    fields_.emplace_back(d, context_, std::move(reference), rows);
    comparisons_.push_back(fields_.back());
}

void Errors::eachList(const std::function<void(const std::string&, std::vector<double>&)>& f) const
{
    for (std::size_t m = 0; m < measures_.size(); ++m)
    {
        const auto lists = measures_[m].lists();
        for (std::size_t k = 0; k < lists.size(); ++k) f(fmt::format("{}.{}", m, k), *lists[k]);
    }
    for (std::size_t k = 0; k < fields_.size(); ++k) f(fmt::format("mean.{}", k), fields_[k].history());
}

Histories Errors::histories() const
{
    Histories all;
    eachList(
        [&](const std::string& name, const std::vector<double>& list)
        {
            if (!list.empty()) all[name] = list;
        });
    if (numbers_) all.merge(numbers_->histories());
    return all;
}

void Errors::restore(const Histories& stored)
{
    eachList(
        [&](const std::string& name, std::vector<double>& list)
        {
            if (const auto found = stored.find(name); found != stored.end()) list = found->second;
        });
    if (numbers_) numbers_->restore(stored);
}

void Errors::execute(const ParticleView& view)
{
    report_.clear();
    if (numbers_) found_ = (*numbers_)(view);
    for (const auto& comparison : comparisons_)
    {
        const auto row = comparison(view);
        if (!row) continue;
        if (!table_) table_.emplace(context_.file("errors.dat"), std::vector<std::string>{}, column::ofErrors);
        table_->row(view.time, std::vector<std::string>{row->field, cell(row->error.L1), cell(row->error.L2), cell(row->error.Linf),
                                                        fmt::format("{}", row->particles), cell(view.executionTime), cell(row->value),
                                                        cell(row->reference)});
        report_ += fmt::format("{}{}: {} L2 {:.4g} Linf {:.4g}{}{}", report_.empty() ? "" : "\n", context_.name, row->field, row->error.L2,
                               row->error.Linf, row->note.empty() ? "" : "; ", row->note);
    }
}

}
