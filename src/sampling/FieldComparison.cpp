#include "FieldComparison.hpp"
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

FieldComparison::FieldComparison(const Dictionary& d, const FunctionContext& context, ReferenceField reference)
    : field_(d.get<std::string>("field")),
      relative_(readsRelative(d)),
      removeMean_(d.get("removeMean", false)),
      where_(d.where("field")),
      reference_(std::move(reference))
{
    static const std::vector<std::string> components{"x", "y", "z", "xx", "xy", "xz", "yy", "yz", "zz"};
    if (d.found("component"))
    {
        component_ = d.choose("component", components);
        where_ = d.where("component");
    }
    if (d.found("scale")) scale_ = d.getPositive("scale", DimensionSet{});
    if (d.found("phase")) phase_ = readPhase(d, "phase", context.phases);
    if (d.found("region"))
    {
        const auto region = d.subDict("region");
        region_ = Box{region.get<Vector<3>>("min"), region.get<Vector<3>>("max")};
    }
}

std::optional<ErrorRow> FieldComparison::operator()(const ParticleView& view) const
{
    const SampledField field(view, field_, where_);
    int only = -1;
    if (!component_.empty())
    {
        const auto& names = componentNames(field.type());
        const auto found = std::find(names.begin(), names.end(), component_);
        if (found == names.end())
            throw CaseError(where_, fmt::format("field {} has no component \"{}\". {}", field_, component_,
                                                field.components() == 1 ? "It is a scalar" : "Known components: " + list(names)));
        only = int(found - names.begin());
    }
    else if (field.components() > 3)
        throw CaseError(where_, fmt::format("field {} is a tensor: compare a component of it", field_));

    const auto selected = [&](std::size_t i)
    {
        if (phase_ && phaseOf(view, i) != *phase_) return false;
        if (!region_) return true;
        const auto x = position(view, i);
        const auto within = [](double low, double value, double high) { return value >= low && value <= high; };
        return within(region_->low.x, x.x, region_->high.x) && within(region_->low.y, x.y, region_->high.y) &&
               (view.dimension == 2 || within(region_->low.z, x.z, region_->high.z));
    };
    struct Sample
    {
        double volume;
        Vector<3> value, exact;
    };
    std::vector<Sample> samples;
    double volume = 0;
    Vector<3> meanValue, meanExact;
    for (std::size_t i = 0; i < view.n; ++i)
    {
        if (!selected(i)) continue;
        const auto exact = reference_(position(view, i), view.time);
        if (!exact) continue;
        Sample s{view.volume[i], {}, *exact};
        if (only >= 0)
            s.value.x = field(only, i);
        else if (field.components() == 1)
            s.value.x = field(0, i);
        else
            s.value = {field(0, i), field(1, i), field(2, i)};
        volume += s.volume;
        meanValue += s.volume * s.value;
        meanExact += s.volume * s.exact;
        samples.push_back(s);
    }
    if (samples.empty()) return {};

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
                    samples.size(),
                    values.norms().L2,
                    scale.L2,
                    {}};
}

}
