/// Closing and ordering: which terms take part in an evaluation, and in which pass.
#include "base/CaseError.hpp"
#include "base/words.hpp"
#include "plan/Plan.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdexcept>

namespace sph
{

template<int dim>
Plan<dim>::Plan(const Catalogue<dim>& catalogue, const std::vector<Group>& groups, std::set<std::string> state,
                std::map<std::string, std::vector<FieldUse<dim>>> ruleReads)
    : catalogue_(catalogue), state_(std::move(state)), ruleReads_(std::move(ruleReads))
{
    auto given = state_;
    std::set<std::string> fresh; // whose images are those of the owned values
    for (const auto& group : groups)
    {
        auto& passes = groups_.emplace_back();
        passes.group = group;
        if (group.kernel) passes.kernel.emplace(group.kernel->name, group.kernel->support);
        select(passes);
        const auto outdated = outdatedBy(group.changed);
        auto available = given;
        for (const auto& field : outdated)
        {
            fresh.erase(field);
            if (!state_.contains(field)) available.erase(field);
        }
        close(passes, available);
        order(passes, available, fresh);
        std::set<std::string> advanced;
        for (const auto* e : passes.chosen)
            for (const auto& f : e->results)
            {
                given.insert(passes.resultName(f));
                if (e->advances) advanced.insert(passes.resultName(f));
            }
        for (const auto& field : outdatedBy(advanced)) // for the groups behind
        {
            fresh.erase(field);
            if (!state_.contains(field)) given.erase(field);
        }
    }
    keepPairs();
    for (auto& g : groups_)
        for (auto& pass : g.passes)
            pass.leavesOut =
                !pass.keepsWithin && !pass.keepsSlopes && std::ranges::all_of(pass.entries, [](const Entry* e) { return e->mayBeNothing; });
}

/// Neighbours are kept where a pass behind reads them; (dW/dr)/r, which takes eight bytes a pair, or four where a group bears it, where at least two passes do, or one that repeats. Raw and
/// normalised gradients differ: those are kept that more passes read.
template<int dim> void Plan<dim>::keepPairs()
{
    std::vector<Pass*> passes;               // of the scene's kernel, over all particles
    std::map<bool, std::vector<Pass*>> kind; // raw and normalised, from one of the evaluation on, which runs before all others
    std::map<bool, int> readers;
    for (std::size_t g = 0; g < groups_.size(); ++g)
        for (auto& pass : groups_[g].passes)
        {
            if (!pass.pair() || groups_[g].kernel || !groups_[g].group.sharesBy.empty()) continue;
            passes.push_back(&pass);
            auto& alike = kind[pass.normalised];
            if (alike.empty() && g > 0) continue;
            if (!alike.empty()) readers[pass.normalised] += groups_[g].group.repeats ? 2 : 1;
            alike.push_back(&pass);
        }
    for (auto* pass : passes) (pass == passes[0] ? pass->keepsWithin : pass->within) = passes.size() > 1;
    for (auto& g : groups_)
        for (auto& pass : g.passes)
        {
            pass.single = g.group.bearsSingle && g.group.sharesBy.empty() &&
                          std::ranges::all_of(pass.entries, [](const Entry* e) { return e->bearsSingle; });
            keepsSingleSlopes_ = keepsSingleSlopes_ || pass.single;
        }
    const bool normalised = readers[true] >= readers[false];
    if (readers[normalised] < 2) return;
    auto& alike = kind[normalised];
    for (auto* pass : alike) (pass == alike[0] ? pass->keepsSlopes : pass->slopes) = true;
}

/// The changed fields, and all that the groups so far have made of them.
template<int dim> std::set<std::string> Plan<dim>::outdatedBy(std::set<std::string> fields) const
{
    for (std::size_t before = 0; before != fields.size();)
    {
        before = fields.size();
        for (const auto& g : groups_)
            for (const auto* e : g.chosen)
            {
                bool reads = false;
                forEachRead(*e, [&](const FieldUse<dim>& f) { reads = reads || fields.contains(f.name); });
                if (reads && e->provides)
                    for (const auto& f : e->results) fields.insert(g.resultName(f));
            }
    }
    return fields;
}

template<int dim> void Plan<dim>::select(Passes& passes)
{
    for (const auto& name : passes.group.terms)
    {
        const auto found = std::find_if(catalogue_.begin(), catalogue_.end(), [&](const Entry& e) { return e.name == name; });
        if (found == catalogue_.end())
        {
            std::vector<std::string> known;
            for (const auto& e : catalogue_) known.push_back(e.name);
            throw CaseError(fmt::format("term \"{}\" is unknown. {}", name, suggestion(name, "terms", known)));
        }
        passes.chosen.push_back(&*found);
        passes.reason[&*found] = "selected";
    }
}

template<int dim> void Plan<dim>::forEachRead(const Entry& e, const std::function<void(const FieldUse<dim>&)>& f) const
{
    for (const auto& field : e.readsOwn) f(field);
    for (const auto& field : e.reads)
    {
        f(field);
        if (const auto rule = ruleReads_.find(field.info.ofRule ? field.info.ofRule : ""); rule != ruleReads_.end())
            for (const auto& source : rule->second) f(source);
    }
}

template<int dim> void Plan<dim>::close(Passes& passes, const std::set<std::string>& given)
{
    auto& chosen = passes.chosen;
    std::map<std::string, const Entry*> provider;
    const auto provide = [&](const Entry* e)
    {
        if (!e->provides) return;
        for (const auto& f : e->results)
            if (const auto [p, first] = provider.try_emplace(f.name, e); !first)
                throw CaseError(fmt::format("field \"{}\" is provided by both {} and {}: select one", p->first, p->second->name, e->name));
    };
    std::set<std::string> added;
    for (const auto* e : chosen)
    {
        provide(e);
        if (!e->provides)
            for (const auto& f : e->results) added.insert(passes.resultName(f));
    }
    for (std::size_t k = 0; k < chosen.size(); ++k)
    {
        const auto* const reader = chosen[k];
        forEachRead(*reader,
                    [&](const FieldUse<dim>& f)
                    {
                        if (given.contains(f.name) || provider.contains(f.name) || added.contains(f.name)) return;
                        std::vector<const Entry*> candidates;
                        std::vector<std::string> names;
                        for (const auto& e : catalogue_)
                            if (e.provides &&
                                std::any_of(e.results.begin(), e.results.end(), [&](const auto& r) { return r.name == f.name; }))
                            {
                                candidates.push_back(&e);
                                names.push_back(e.name);
                            }
                        if (candidates.empty())
                            throw CaseError(fmt::format("term \"{}\" reads \"{}\" [{}], which the scene does not give and no term provides",
                                                        reader->name, f.name, f.info.unit));
                        // A choice of a group before holds here too.
                        const auto before =
                            std::find_if(candidates.begin(), candidates.end(),
                                         [&](const Entry* e)
                                         {
                                             return std::any_of(groups_.begin(), groups_.end() - 1,
                                                                [&](const Passes& g) {
                                                                    return std::find(g.chosen.begin(), g.chosen.end(), e) != g.chosen.end();
                                                                });
                                         });
                        if (before != candidates.end()) candidates = {*before};
                        if (candidates.size() > 1)
                            throw CaseError(
                                fmt::format("term \"{}\" reads \"{}\": select one of {}", reader->name, f.name, fmt::join(names, ", ")));
                        chosen.push_back(candidates[0]);
                        passes.reason[candidates[0]] = fmt::format("{} for {}", f.name, reader->name);
                        provide(candidates[0]);
                    });
    }
}

template<int dim> void Plan<dim>::order(Passes& passes, const std::set<std::string>& given, std::set<std::string>& fresh)
{
    std::set<std::string> waiting;
    std::map<std::string, int> adders;
    for (const auto* e : passes.chosen)
        for (const auto& f : e->results)
        {
            if (e->provides) waiting.insert(f.name);
            else ++adders[passes.resultName(f)];
        }
    // A rate that terms add to, and that another term reads, is there once all of them have added.
    for (const auto& [field, _] : adders)
        if (!given.contains(field)) waiting.insert(field);
    auto left = passes.chosen;
    const std::string scale = GradientScale::info.name;
    const bool normalises = !passes.kernel && (waiting.contains(scale) || given.contains(scale));
    const auto normalised = [&](const Entry* e) { return normalises && e->over == Over::pairs && !e->ofRawGradient; };
    enum class Turn
    {
        wallsThatProvide,
        particles,
        pairs,
        wallsThatAdd
    };
    const auto turnOf = [](const Entry* e)
    {
        return e->over == Over::particles ? Turn::particles
               : e->over == Over::pairs   ? Turn::pairs
               : e->provides              ? Turn::wallsThatProvide
                                          : Turn::wallsThatAdd;
    };
    while (!left.empty())
    {
        const auto ready = [&](const Entry* e)
        {
            bool all = !(normalised(e) && waiting.contains(scale));
            forEachRead(*e, [&](const FieldUse<dim>& f) { all = all && !waiting.contains(f.name); });
            return all;
        };
        Pass pass;
        for (const auto turn : {Turn::wallsThatProvide, Turn::particles, Turn::pairs, Turn::wallsThatAdd})
            if (pass.entries.empty())
                std::copy_if(left.begin(), left.end(), std::back_inserter(pass.entries),
                             [&](auto* e) { return turnOf(e) == turn && ready(e); });
        if (pass.entries.empty())
            throw CaseError(fmt::format("terms \"{}\" and \"{}\" wait for one another's fields", left.front()->name, left.back()->name));
        int column = 0;
        const auto refresh = [&](const FieldUse<dim>& f)
        {
            if (fresh.insert(f.name).second) pass.refresh.push_back(f);
        };
        for (const auto* e : pass.entries)
        {
            std::erase(left, e);
            pass.readsKernel = pass.readsKernel || e->readsKernel;
            pass.normalised = pass.normalised || normalised(e);
            for (const auto& f : e->results)
                if (const auto a = adders.find(passes.resultName(f)); a == adders.end() || --a->second == 0)
                    waiting.erase(passes.resultName(f));
            for (const auto& f : e->reads)
                if (pass.firstColumn.try_emplace(f.name, column).second)
                {
                    pass.columns.push_back(f);
                    column += f.type.components;
                    refresh(f);
                }
        }
        if (pass.normalised) refresh(uses<dim>(Fields<GradientScale>{})[0]);
        for (const auto* e : pass.entries)
            for (const auto& f : e->results) fresh.erase(passes.resultName(f));
        if (column + 2 > Stencil<dim>::maxColumns)
            throw CaseError(
                fmt::format("one pass reads {} components at the neighbours, more than {}", column, Stencil<dim>::maxColumns - 2));
        passes.passes.push_back(std::move(pass));
    }
}

template<int dim> bool Plan<dim>::hasGroup(const std::string& name) const
{
    return std::any_of(groups_.begin(), groups_.end(), [&](const Passes& g) { return g.group.name == name; });
}

template<int dim> std::size_t Plan<dim>::group(const std::string& name) const
{
    for (std::size_t g = 0; g < groups_.size(); ++g)
        if (groups_[g].group.name == name) return g;
    throw std::logic_error("the plan has no group \"" + name + "\"");
}

template<int dim> int Plan<dim>::pairPasses(std::size_t group) const
{
    const auto& passes = groups_[group].passes;
    return int(std::count_if(passes.begin(), passes.end(), [](const Pass& pass) { return pass.pair(); }));
}

template<int dim> bool Plan<dim>::has(const std::string& term) const
{
    return std::any_of(groups_.begin(), groups_.end(),
                       [&](const Passes& g)
                       { return std::any_of(g.chosen.begin(), g.chosen.end(), [&](const Entry* e) { return e->name == term; }); });
}

template<int dim> bool Plan<dim>::provides(const std::string& field) const
{
    for (const auto& g : groups_)
        for (const auto* e : g.chosen)
            for (const auto& f : e->results)
                if (g.resultName(f) == field) return true;
    return false;
}

template class Plan<2>;
template class Plan<3>;

}
