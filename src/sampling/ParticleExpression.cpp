#include "sampling/ParticleExpression.hpp"
#include "base/words.hpp"
#include "geometry/wallNames.hpp"
#include "sampling/Interpolator.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/nearestOfWall.hpp"
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

}

/// What the names of a text are in a view. It keeps what the view has no row of.
class ParticleExpression::Names
{
    const ParticleView& view_;
    const NamedNumbers& numbers_;
    const std::vector<std::string>& later_;
    std::deque<std::vector<double>> rows_;
    std::array<std::optional<Interpolator>, 2> interpolators_; ///< with images beyond planes of symmetry, and without

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
    /// A row that is made of a function of each particle's number.
    template<class F> const double* row(const F& f)
    {
        auto& values = rows_.emplace_back(view_.n);
#pragma omp parallel for schedule(dynamic, 256)
        for (std::size_t i = 0; i < view_.n; ++i) values[i] = f(i);
        return values.data();
    }
    std::optional<Source> ofPhaseByName(const std::string& name)
    {
        const auto phase = std::ranges::find(view_.phases, name);
        if (phase == view_.phases.end()) return {};
        const auto k = std::size_t(phase - view_.phases.begin());
        return each(row([&](std::size_t i) { return double(phaseOf(view_, i) == k); }));
    }
    /// The argument of `function(argument)`; nothing of another name.
    static std::optional<std::string> argumentOf(const std::string& function, const std::string& name)
    {
        if (!name.starts_with(function + "(") || !name.ends_with(')')) return {};
        return name.substr(function.size() + 1, name.size() - function.size() - 2);
    }
    std::size_t wall(const std::string& name) const
    {
        const auto walls = wallNames(*view_.geometry);
        const auto found = std::ranges::find(walls, name);
        if (found == walls.end()) throw ExpressionError(fmt::format("wall \"{}\" is unknown. {}", name, suggestion(name, "walls", walls)));
        return std::size_t(found - walls.begin());
    }
    /// A row of a field to which a function of a field as a whole is applied.
    const double* ofParticles(const std::string& name)
    {
        const auto source = (*this)(name);
        if (source.kind == Kind::vector) throw ExpressionError(fmt::format("${} is a vector: take a component, ${}_x", name, name));
        if (!source.values.each[0]) throw ExpressionError(fmt::format("${} is no field: it has one value for all particles", name));
        return source.values.each[0];
    }
    const Interpolator& interpolator(Mirrored mirrored)
    {
        auto& made = interpolators_[mirrored == Mirrored::no];
        if (!made) made.emplace(view_, mirrored);
        return *made;
    }
    /// Functions of a field as a whole, and of a wall.
    std::optional<Source> ofFunction(const std::string& name)
    {
        if (const auto field = argumentOf("grad", name))
        {
            const auto* const f = ofParticles(*field);
            const auto& around = interpolator(Mirrored::no);
            std::array<std::vector<double>*, 3> rows;
            for (auto*& r : rows) r = &rows_.emplace_back(view_.n);
#pragma omp parallel for schedule(dynamic, 256)
            for (std::size_t i = 0; i < view_.n; ++i)
            {
                const auto gradient = around.gradient(position(view_, i), f[i], f);
                (*rows[0])[i] = gradient.x;
                (*rows[1])[i] = gradient.y;
                (*rows[2])[i] = gradient.z;
            }
            return Source{Kind::vector, {{rows[0]->data(), rows[1]->data(), rows[2]->data()}, {}}};
        }
        if (const auto field = argumentOf("smooth", name))
        {
            const auto* const f = ofParticles(*field);
            const auto& around = interpolator(Mirrored::atSymmetryPlanes);
            return each(row(
                [&](std::size_t i)
                {
                    const auto sums = around.sums(position(view_, i), f);
                    return sums.ofValues / sums.coverage;
                }));
        }
        if (name == "coverage")
        {
            const auto& around = interpolator(Mirrored::atSymmetryPlanes);
            return each(row([&](std::size_t i) { return around.sums(position(view_, i), view_.volume).coverage; }));
        }
        if (name == "distance") return each(row([&](std::size_t i) { return nearestThatHolds(*view_.geometry, position(view_, i)); }));
        if (const auto of = argumentOf("distance", name))
            return each(
                row([&, k = wall(*of)](std::size_t i) { return nearestOfWall(*view_.geometry, k, position(view_, i)).foot.distance; }));
        if (const auto of = argumentOf("contactAngle", name))
        {
            const auto& w = view_.geometry->walls[wall(*of)];
            if (w.contactAngles.empty()) return ofAll(w.contactAngle);
            const auto angle = view_.phases.size() == 2 ? w.angleOf(view_.phases[0], view_.phases[1]) : std::nullopt;
            if (!angle) throw ExpressionError(fmt::format("wall {} has contact angles of pairs of phases, not one", w.name));
            return ofAll(*angle);
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
        if (auto phase = ofPhaseByName(name)) return phase;
        if (auto function = ofFunction(name)) return function;
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
        for (const char* name : {"x", "y", "z", "t", "mass", "volume", "coverage", "distance", "restDensity", "soundSpeed", "viscosity",
                                 "spacing", "support", "deltaT", "g"})
            all.emplace_back(name);
        all.insert(all.end(), view_.phases.begin(), view_.phases.end());
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

namespace
{
/// Where a mean or a number is made of a text.
constexpr const char* vectorRefused = "it gives a vector: take a component, or mag() of it";
}

/// A text whose names have their values in a view.
class ParticleExpression::Bound
{
    Names names_;

public:
    std::vector<Values> values; // in the order of the names, filled while the program is read
    const ExpressionProgram& program;

    Bound(const ParticleExpression& own, const ParticleView& view, const NamedNumbers& numbers)
        : names_(view, numbers, own.later_), program(read(own))
    {
        if (own.gives_ == Gives::number && program.kind() == Kind::vector) throw ExpressionError(vectorRefused);
    }

private:
    const ExpressionProgram& read(const ParticleExpression& own)
    {
        auto& compiled = own.compiled_;
        if (compiled)
        {
            bool same = true;
            for (std::size_t k = 0; k < compiled->kinds.size(); ++k)
            {
                const auto source = names_(compiled->program.names()[k]);
                values.push_back(source.values);
                same = same && source.kind == compiled->kinds[k];
            }
            if (same) return compiled->program;
            values.clear();
        }
        std::vector<Kind> kinds;
        ExpressionProgram made(own.text_,
                               [&](const std::string& name)
                               {
                                   const auto source = names_(name);
                                   values.push_back(source.values);
                                   kinds.push_back(source.kind);
                                   return source.kind;
                               });
        return compiled.emplace(Compiled{std::move(made), std::move(kinds)}).program;
    }
};

template<class Use> auto ParticleExpression::bound(const ParticleView& view, const NamedNumbers& numbers, const Use& use) const
{
    try
    {
        return use(Bound(*this, view, numbers));
    }
    catch (const ExpressionError& e)
    {
        throw CaseError(where_, fmt::format("\"{}\": {}", text_, e.what()));
    }
}

ParticleExpression::ParticleExpression(const Text& entry, const Dictionary& d, const std::string& text,
                                       const std::vector<std::string>& numbers, const std::vector<std::string>& later, Gives gives)
    : text_(text), where_(entry.where(d)), later_(later), gives_(gives)
{
    const auto kindOf = [&](const std::string& name)
    { return std::ranges::find(numbers, name) != numbers.end() ? Kind::number : Kind::unknown; };
    try
    {
        if (ExpressionProgram(text, kindOf).kind() == Kind::vector && gives == Gives::number) throw ExpressionError(vectorRefused);
    }
    catch (const ExpressionError& e)
    {
        if (entry.given(d)) entry.error(d, fmt::format("{} \"{}\": {}", entry.keyword(), text, e.what()));
    }
}

std::vector<double> ParticleExpression::atParticles(const ParticleView& view, const NamedNumbers& numbers) const
{
    return std::move(componentsAtParticles(view, numbers).front());
}

std::vector<std::vector<double>> ParticleExpression::componentsAtParticles(const ParticleView& view, const NamedNumbers& numbers) const
{
    return bound(view, numbers,
                 [&](const Bound& b)
                 {
                     std::vector<std::vector<double>> result(b.program.kind() == Kind::vector ? 3 : 1, std::vector<double>(view.n));
                     constexpr std::size_t block = 4096;
#pragma omp parallel for schedule(static)
                     for (std::size_t begin = 0; begin < view.n; begin += block)
                     {
                         std::array<double*, 3> out{};
                         for (std::size_t c = 0; c < result.size(); ++c) out[c] = result[c].data() + begin;
                         b.program(begin, std::min(view.n, begin + block), b.values, out);
                     }
                     return result;
                 });
}

double ParticleExpression::ofScene(const ParticleView& view, const NamedNumbers& numbers) const
{
    return bound(
        view, numbers,
        [&](const Bound& b)
        {
            for (std::size_t k = 0; k < b.values.size(); ++k)
                if (const auto& row = b.values[k].each; row[0] || row[1] || row[2])
                    throw ExpressionError(fmt::format(
                        "${} has a value for each particle: an operation (sum, mean, min, max, percentile) makes one number of them",
                        b.program.names()[k]));
            double result = 0;
            b.program(0, 1, b.values, {&result});
            return result;
        });
}

}
