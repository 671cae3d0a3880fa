/// The plan of a scene from its settings: groups of terms, and the fields that no term provides.
#pragma once
#include "fields/fieldTags.hpp"
#include "scene/Settings.hpp"

namespace sph
{

inline std::vector<Group> groupsOf(const Settings& settings)
{
    std::vector<Group> groups{{ofEvaluation, settings.terms}};
    if (!settings.slowTerms.empty())
        groups.push_back({onceAStep, settings.slowTerms, {}, {{Acceleration::info.name, SlowAcceleration::info.name}}});
    groups.insert(groups.end(), settings.groups.begin(), settings.groups.end());
    for (auto& group : groups) group.bearsSingle = group.bearsSingle || settings.mixedPrecision;
    return groups;
}

/// Fields that no term provides: the state, those of images themselves, and those that the caller of a group writes (the change that a solver tries).
inline std::set<std::string> givenOf(const Settings& settings)
{
    std::set<std::string> given{GhostWall::info.name};
    for (const auto& evolving : settings.state) given.insert(evolving.value.name);
    for (const auto& group : settings.groups) given.insert(group.inputs.begin(), group.inputs.end());
    return given;
}

template<int dim> std::map<std::string, std::vector<FieldUse<dim>>> rulesOf(const Settings& settings)
{
    std::map<std::string, std::vector<FieldUse<dim>>> rules;
    for (const auto& [field, fields] : settings.ruleReads)
        for (const auto& f : fields) rules[field].push_back({f.info, f.name, f.type(dim)});
    return rules;
}

}
