#include "sampling/ParticleExpression.hpp"
#include "base/words.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{

using Kind = ExpressionProgram::Kind;
using Values = ExpressionProgram::Values;

struct Source
{
    Kind kind = Kind::number;
    Values values;
};
Source ofAll(double value) { return {Kind::number, {{}, {value, 0, 0}}}; }
Source each(const double* values) { return {Kind::number, {{values}, {}}}; }

/// What the names of a text are in a view. It keeps what the view has no row of.
class Names
{
    const ParticleView& view_;
    const NamedNumbers& numbers_;
    const std::vector<std::string>& later_;
    std::deque<std::vector<double>> rows_;

    Source ofPhase(const std::vector<double>& values)
    {
        if (values.size() == 1 || !view_.phase) return ofAll(values.at(0));
        auto& row = rows_.emplace_back(view_.n);
        for (std::size_t i = 0; i < view_.n; ++i) row[i] = values.at(phaseOf(view_, i));
        return each(row.data());
    }
    /// A component of a field that a view in 2-D leaves out is 0.
    static Source component(const SampledField& field, int c)
    {
        const double* const row = field.array(c);
        return row ? each(row) : ofAll(0);
    }
    std::optional<Source> ofField(const std::string& name)
    {
        for (const auto& f : view_.fields)
        {
            const SampledField field(view_, f.name, {});
            if (name == f.name && field.components() == 1) return component(field, 0);
            if (name == f.name && field.type() == FieldClass::vector)
                return Source{Kind::vector, {{field.array(0), field.array(1), field.array(2)}, {}}};
            const auto columns = columnNames(field);
            if (name == f.name) throw ExpressionError(fmt::format("${} is a tensor: take a component, {}", name, list(columns)));
            if (const auto found = std::ranges::find(columns, name); found != columns.end())
                return component(field, int(found - columns.begin()));
        }
        return {};
    }
    std::optional<Source> find(const std::string& name)
    {
        if (const auto number = std::ranges::find(numbers_, name, &NamedNumber::name); number != numbers_.end())
            return ofAll(number->value);
        if (name == "x") return each(view_.x);
        if (name == "y") return each(view_.y);
        if (name == "z") return view_.z ? each(view_.z) : ofAll(0);
        if (name == "t") return ofAll(view_.time);
        if (auto field = ofField(name)) return field;
        if (name == "mass") return each(view_.mass);
        if (name == "volume") return each(view_.volume);
        if (name == "restDensity") return ofPhase(view_.restDensity);
        if (name == "soundSpeed") return ofPhase(view_.soundSpeed);
        if (name == "viscosity") return ofPhase(view_.viscosity);
        if (name == "spacing") return ofAll(view_.spacing);
        if (name == "support") return ofAll(view_.support);
        if (name == "deltaT") return ofAll(view_.deltaT);
        if (name == "g") return Source{Kind::vector, {{}, view_.g}};
        if (const double gamma = surfaceTensionOf(view_); name == "surfaceTension" && gamma > 0) return ofAll(gamma);
        if (const auto number = view_.numbers.find(name); number != view_.numbers.end()) return ofAll(number->second);
        if (view_.numbers.empty() && name.ends_with(')'))
            return ofAll(std::numeric_limits<double>::quiet_NaN()); // of stored times, which have no numbers of models
        return {};
    }

    std::vector<std::string> known() const
    {
        std::vector<std::string> all;
        for (const auto& number : numbers_) all.push_back(number.name);
        for (const auto& f : view_.fields)
        {
            if (f.type == FieldClass::vector) all.push_back(f.name);
            for (const auto& column : columnNames(SampledField(view_, f.name, {}))) all.push_back(column);
        }
        for (const char* name :
             {"x", "y", "z", "t", "mass", "volume", "restDensity", "soundSpeed", "viscosity", "spacing", "support", "deltaT", "g"})
            all.emplace_back(name);
        if (surfaceTensionOf(view_) > 0) all.emplace_back("surfaceTension");
        for (const auto& [name, value] : view_.numbers) all.push_back("{" + name + "}");
        return all;
    }

public:
    Names(const ParticleView& view, const NamedNumbers& numbers, const std::vector<std::string>& later)
        : view_(view), numbers_(numbers), later_(later)
    {}

    Source operator()(const std::string& name)
    {
        if (auto found = find(name)) return *found;
        if (std::ranges::find(later_, name) != later_.end())
            throw ExpressionError(fmt::format("${} stands behind it: numbers are found in the order in which they are given", name));
        throw ExpressionError(fmt::format("\"${}\" is unknown. {}", name, suggestion(name, "names", known())));
    }
};

struct Bound
{
    Names names;
    std::vector<Source> sources;
    ExpressionProgram program;
    std::vector<Values> values;

    Bound(const std::string& text, const ParticleView& view, const NamedNumbers& numbers, const std::vector<std::string>& later)
        : names(view, numbers, later),
          program(text,
                  [this](const std::string& name)
                  {
                      sources.push_back(names(name));
                      return sources.back().kind;
                  })
    {
        if (program.kind() == Kind::vector) throw ExpressionError("it gives a vector: take a component, or mag() of it");
        for (const auto& s : sources) values.push_back(s.values);
    }
};

}

ParticleExpression::ParticleExpression(const Text& entry, const Dictionary& d, const std::string& text,
                                       const std::vector<std::string>& numbers, const std::vector<std::string>& later)
    : text_(text), where_(entry.where(d)), later_(later)
{
    const auto kindOf = [&](const std::string& name)
    { return std::ranges::find(numbers, name) != numbers.end() ? Kind::number : Kind::unknown; };
    try
    {
        if (ExpressionProgram(text, kindOf).kind() == Kind::vector)
            throw ExpressionError("it gives a vector: take a component, or mag() of it");
    }
    catch (const ExpressionError& e)
    {
        if (entry.given(d)) entry.error(d, fmt::format("{} \"{}\": {}", entry.keyword(), text, e.what()));
    }
}

std::vector<double> ParticleExpression::atParticles(const ParticleView& view, const NamedNumbers& numbers) const
{
    try
    {
        const Bound bound(text_, view, numbers, later_);
        std::vector<double> result(view.n);
        constexpr std::size_t block = 4096;
#pragma omp parallel for schedule(static)
        for (std::size_t begin = 0; begin < view.n; begin += block)
            bound.program(begin, std::min(view.n, begin + block), bound.values, {result.data() + begin});
        return result;
    }
    catch (const ExpressionError& e)
    {
        throw CaseError(where_, fmt::format("\"{}\": {}", text_, e.what()));
    }
}

double ParticleExpression::ofScene(const ParticleView& view, const NamedNumbers& numbers) const
{
    try
    {
        const Bound bound(text_, view, numbers, later_);
        for (std::size_t k = 0; k < bound.sources.size(); ++k)
            if (const auto& row = bound.values[k].each; row[0] || row[1] || row[2])
                throw ExpressionError(fmt::format(
                    "${} has a value for each particle: an operation (sum, mean, min, max, percentile) makes one number of them",
                    bound.program.names()[k]));
        double result = 0;
        bound.program(0, 1, bound.values, {&result});
        return result;
    }
    catch (const ExpressionError& e)
    {
        throw CaseError(where_, fmt::format("\"{}\": {}", text_, e.what()));
    }
}

}
