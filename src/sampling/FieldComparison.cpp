#include "sampling/FieldComparison.hpp"
#include "base/words.hpp"
#include "geometry/components.hpp"
#include "geometry/contains.hpp"
#include "sampling/Interpolator.hpp"
#include "sampling/Measurement.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/sharedEntries.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Choice component{"component",
                       {"x", "y", "z", "xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"},
                       byScene("the magnitude of the difference"),
                       "component to compare"},
    norm{"norm", {"relative", "absolute"}, "relative", "errors divided by the reference, or as they are"},
    cellMeans{"cellMeans",
              {"x", "y", "z"},
              notGiven,
              "direction along which the reference is averaged over a spacing: all that particles have of a cusp"},
    points{"points",
           {"particles", {"rows", "the rows of a csv reference, all of the same weight, where the field is interpolated"}},
           "particles",
           "where to compare"};
const Scalar meanFrom{"meanFrom", units::s, notGiven, anyNumber,
                      "with `points rows`: compare the mean over all times from this one on, of what flutters about a steady state"};
const Scalar scale{"scale", Unit{units::none, "of the field"}, byScene("the same norm of the reference"), positive,
                   "what relative errors are divided by"};
const Switch removeMean{"removeMean", false, "compare up to a constant, as for a pressure without a level"};
const Word phaseAlone{"phase", byScene("all"), "compare its particles alone"};
const SubDictionary comparedRegion{"region", byScene("everywhere"), "compare points within this box alone"};
const VectorParameter comparedMin{"min", units::m, required, "lowest corner"}, comparedMax{"max", units::m, required, "highest corner"};
}

bool readsRelative(const Dictionary& d) { return entry::norm(d) == "relative"; }

std::string readComponent(const Dictionary& d) { return entry::component.ifGiven(d).value_or(""); }

EntryList FieldComparison::entries()
{
    return {entry::field,     entry::component, entry::norm,       entry::scale,
            entry::points,    entry::meanFrom,  entry::phaseAlone, {entry::comparedRegion, {entry::comparedMin, entry::comparedMax}},
            entry::cellMeans, entry::removeMean};
}

FieldComparison::FieldComparison(const Dictionary& d, const FunctionContext& context, ReferenceField reference,
                                 const std::vector<Vector<3>>& rows)
    : field_(entry::field(d)),
      component_(readComponent(d)),
      relative_(readsRelative(d)),
      removeMean_(entry::removeMean(d)),
      scale_(entry::scale.ifGiven(d)),
      where_(component_.empty() ? entry::field.where(d) : entry::component.where(d)),
      reference_(std::move(reference))
{
    if (const auto axis = entry::cellMeans.ifGiven(d))
        cell_ = {*axis == "x" ? 1.0 : 0.0, *axis == "y" ? 1.0 : 0.0, *axis == "z" ? 1.0 : 0.0};
    if (entry::phaseAlone.given(d)) phase_ = readPhase(d, entry::phaseAlone, context.phases);
    if (entry::comparedRegion.given(d))
    {
        const auto region = entry::comparedRegion(d);
        region_ = Box{entry::comparedMin(region), entry::comparedMax(region)};
    }
    meanFrom_ = entry::meanFrom.ifGiven(d);
    if (entry::points(d) == "particles")
    {
        if (meanFrom_) entry::meanFrom.error(d, "goes with `points rows;` alone: particles do not stay at a place");
        return;
    }
    rows_ = rows;
    if (rows.empty()) entry::points.error(d, "only a reference of type csv has rows");
    if (mag(cell_) > 0) entry::cellMeans.error(d, "cellMeans goes with `points particles;` alone: a row has no cell");
    if (phase_) entry::phaseAlone.error(d, "phase goes with `points particles;` alone: a row belongs to no phase");
}

/// The component that is compared; -1 for the whole vector or scalar.
int FieldComparison::component(const SampledField& field) const
{
    if (component_.empty())
    {
        if (field.components() > 3) throw CaseError(where_, fmt::format("field {} is a tensor: compare a component of it", field_));
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

bool FieldComparison::within(const Vector<3>& x, int dimension) const { return !region_ || contains(*region_, x, dimension); }

/// The reference at a particle, or its mean over the particle's cell by the mid-point rule.
std::optional<Vector<3>> FieldComparison::referenceAt(const Vector<3>& x, const ParticleView& view) const
{
    if (mag(cell_) == 0) return reference_(x, view.time);
    constexpr int parts = 200; // a cusp in the middle of a cell, as steep as the root of the distance, costs 1e-4 of its height
    Vector<3> sum;
    for (int k = 0; k < parts; ++k)
    {
        const auto value = reference_(x + ((k + 0.5) / parts - 0.5) * view.spacing * cell_, view.time);
        if (!value) return {};
        sum += *value;
    }
    return sum / parts;
}

std::vector<FieldComparison::Sample> FieldComparison::atParticles(const ParticleView& view, const SampledField& field, int only) const
{
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < view.n; ++i)
    {
        const auto x = position(view, i);
        if (!view.inScene(i) || (phase_ && phaseOf(view, i) != *phase_) || !within(x, view.dimension)) continue;
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

/// Replaces the values by their means over time, present values included.
void FieldComparison::takeMean(std::vector<Sample>& samples) const
{
    auto& sums = *sums_;
    sums.resize(1 + 3 * samples.size()); // rows are always the same
    const double times = ++sums[0];
    for (std::size_t k = 0; k < samples.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
        {
            double& value = samples[k].value.*coordinates[c];
            value = (sums[1 + 3 * k + c] += value) / times;
        }
}

std::optional<ErrorRow> FieldComparison::operator()(const ParticleView& view) const
{
    if (meanFrom_ && view.time < *meanFrom_) return {};
    const SampledField field(view, field_, where_);
    const int only = component(field);
    auto samples = rows_.empty() ? atParticles(view, field, only) : atRows(view, field, only);
    if (samples.empty()) return {};
    if (meanFrom_) takeMean(samples);

    const auto meanOf = [&](Vector<3> Sample::*of)
    { return sum(samples.size(), [&](std::size_t i) { return VolumeMean<Vector<3>>::of(samples[i].volume, samples[i].*of); }).value(); };
    if (removeMean_)
    {
        const auto value = meanOf(&Sample::value), exact = meanOf(&Sample::exact);
        for (auto& s : samples)
        {
            s.value -= value;
            s.exact -= exact;
        }
    }
    const auto normsOf = [&](const auto& part)
    { return sum(samples.size(), [&](std::size_t i) { return NormSum(samples[i].volume, mag(part(samples[i]))); }).norms(); };
    const auto errors = normsOf([](const Sample&s) { return s.value - s.exact; }), values = normsOf([](const Sample&s) { return s.value; });
    const auto scale = scale_ ? Norms{*scale_, *scale_, *scale_} : normsOf([](const Sample& s) { return s.exact; });
    return ErrorRow{component_.empty() ? field_ : field_ + "." + component_,
                    relative_ ? relativeTo(scale, errors) : errors,
                    rows_.empty() ? samples.size() : view.n,
                    values.L2,
                    scale.L2,
                    {}};
}

}
