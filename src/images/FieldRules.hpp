/// The rules of a scene by which images beyond walls get the values of fields, by field; and the fields that particles of wall layers interpolate.
#pragma once
#include "fields/fieldTags.hpp"
#include "images/GhostRule.hpp"
#include <map>
#include <memory>
#include <set>
#include <string>

namespace sph
{

template<int dim> class FieldRules
{
    std::map<std::string, std::unique_ptr<AnyGhostRule>, std::less<>> rules_;
    std::set<std::string, std::less<>> interpolated_;

public:
    template<class F> void set(F, std::unique_ptr<GhostRule<FieldValue<F, dim>, dim>> rule) { rules_[F::info.name] = std::move(rule); }
    /// The rule of a field; null where images have their sources' values.
    const AnyGhostRule* any(const char* field) const
    {
        const auto found = field ? rules_.find(field) : rules_.end();
        return found == rules_.end() ? nullptr : found->second.get();
    }
    template<class Value> const GhostRule<Value, dim>* of(const char* field) const
    {
        return dynamic_cast<const GhostRule<Value, dim>*>(any(field));
    }

    /// Gives particles of layers one value of this field each from now on, a fit to the fluid's, and not the one that the rule makes of each pair.
    template<class F> void interpolateInLayers(F) { interpolated_.insert(F::info.name); }
    bool interpolates(const FieldInfo& info) const { return info.inLayers == InLayers::extrapolated || interpolated_.contains(info.name); }

    /// Binds the rules to the arrays, after each change of them.
    void bind()
    {
        for (const auto& [_, rule] : rules_) rule->bind();
    }
    /// Ends a step for the rules that keep a state.
    void filter() const
    {
        for (const auto& [_, rule] : rules_) rule->filter();
    }
};

}
