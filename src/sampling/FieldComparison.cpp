#include "FieldComparison.hpp"
#include "contains.hpp"
#include "Interpolator.hpp"
#include "Measurement.hpp"
#include "SampledField.hpp"
#include "words.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

bool readsRelative(const Dictionary& d)
{
    const std::vector<std::string> norms{"relative", "absolute"};
    return d.choose("norm", norms, "relative") == "relative";
}

FieldComparison::FieldComparison(const Dictionary& d, const FunctionContext& context, ReferenceField reference,
                                 const std::vector<Vector<3>>& rows)
    : field_(d.get<std::string>("field")),
      relative_(readsRelative(d)),
      removeMean_(d.get("removeMean", false)),
      where_(d.where("field")),
      reference_(std::move(reference))
{
    static const std::vector<std::string> components{"x", "y", "z", "xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    if (d.found("component"))
    {
        component_ = d.choose("component", components);
        where_ = d.where("component");
    }
    if (d.found("scale")) scale_ = d.getPositive("scale", DimensionSet{});
    if (d.found("cellMeans"))
    {
        static const std::vector<std::string> axes{"x", "y", "z"};
        const auto axis = d.choose("cellMeans", axes);
        cell_ = {axis == "x" ? 1.0 : 0.0, axis == "y" ? 1.0 : 0.0, axis == "z" ? 1.0 : 0.0};
    }
    if (d.found("phase")) phase_ = readPhase(d, "phase", context.phases);
    if (d.found("region"))
    {
        const auto region = d.subDict("region");
        region_ = Box{region.get<Vector<3>>("min"), region.get<Vector<3>>("max")};
    }
    static const std::vector<std::string> points{"particles", "rows"};
    if (d.choose("points", points, "particles") == "particles") return;
    rows_ = rows;
    if (rows.empty()) d.error("points", "only a reference of type csv has rows");
    if (mag(cell_) > 0) d.error("cellMeans", "cellMeans goes with `points particles;` alone: a row has no cell");
    if (phase_) d.error("phase", "phase goes with `points particles;` alone: a row belongs to no phase");
}

/// The component that is compared; -1 for the whole vector or scalar.
int FieldComparison::component(const SampledField& field) const
{
    if (component_.empty())
    {
        if (field.components() > 3)
            throw CaseError(where_, fmt::format("field {} is a tensor: compare a component of it", field_));
        return -1;
    }
    const auto own = componentNames(field.type());
    const std::vector<std::string> names(own.begin(), own.end());
    const auto found = std::find(names.begin(), names.end(), component_);
    if (found == names.end())
        throw CaseError(where_, fmt::format("field {} has no component \"{}\". {}", field_, component_,
                                            field.components() == 1 ? "It is a scalar" : "Known components: " + list(names)));
    return int(found - names.begin());
}

bool FieldComparison::within(const Vector<3>& x, int dimension) const
{
    return !region_ || contains(*region_, x, dimension);
}

/// The reference at a particle, or its mean over the particle's cell by the mid-point rule.
std::optional<Vector<3>> FieldComparison::referenceAt(const Vector<3>& x, const ParticleView& view) const
{
    if (mag(cell_) == 0) return reference_(x, view.time);
    constexpr int parts = 200; // a cusp in the middle of a cell, as steep as the root of the distance, costs 1e-4 of its height
    Vector<3> sum;
    for (int k = 0; k < parts; ++k)
    {
        const auto value = reference_(x + ((k + 0.5)/parts - 0.5)*view.spacing*cell_, view.time);
        if (!value) return {};
        sum += *value;
    }
    return sum/parts;
}

std::vector<FieldComparison::Sample> FieldComparison::atParticles(const ParticleView& view, const SampledField& field, int only) const
{
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < view.n; ++i)
    {
        const auto x = position(view, i);
        if ((phase_ && phaseOf(view, i) != *phase_) || !within(x, view.dimension)) continue;
        const auto exact = referenceAt(x, view);
        if (!exact) continue;
        const auto value = only >= 0 ? Vector<3>{field(only, i), 0, 0} : Vector<3>{field(0, i), field(1, i), field(2, i)};
        samples.push_back({view.volume[i], value, *exact});
    }
    return samples;
}

std::vector<FieldComparison::Sample> FieldComparison::atRows(const ParticleView& view, const SampledField& field, int only) const
{
    const Interpolator interpolator(view);
    std::vector<Sample> samples;
    for (const auto& x : rows_)
    {
        if (!within(x, view.dimension)) continue;
        const auto exact = reference_(x, view.time);
        if (!exact) continue;
        const auto weights = interpolator.weights(x);
        const auto value = only >= 0 ? Vector<3>{weights(field.array(only)), 0, 0}
                                     : Vector<3>{weights(field.array(0)), weights(field.array(1)), weights(field.array(2))};
        samples.push_back({1, value, *exact});
    }
    return samples;
}

std::optional<ErrorRow> FieldComparison::operator()(const ParticleView& view) const
{
    const SampledField field(view, field_, where_);
    const int only = component(field);
    auto samples = rows_.empty() ? atParticles(view, field, only) : atRows(view, field, only);
    if (samples.empty()) return {};

    double volume = 0;
    Vector<3> meanValue, meanExact;
    for (const auto& s : samples)
    {
        volume += s.volume;
        meanValue += s.volume * s.value;
        meanExact += s.volume * s.exact;
    }
    NormSum errors, values, exacts;
    for (auto& s : samples)
    {
        if (removeMean_)
        {
            s.value -= meanValue / volume;
            s.exact -= meanExact / volume;
        }
        errors.add(s.volume, mag(s.value - s.exact));
        values.add(s.volume, mag(s.value));
        exacts.add(s.volume, mag(s.exact));
    }
    const auto scale = scale_ ? Norms{*scale_, *scale_, *scale_} : exacts.norms();
    return ErrorRow{component_.empty() ? field_ : field_ + "." + component_,
                    relative_ ? relativeTo(scale, errors.norms()) : errors.norms(),
                    rows_.empty() ? samples.size() : view.n,
                    values.norms().L2,
                    scale.L2,
                    {}};
}

}
