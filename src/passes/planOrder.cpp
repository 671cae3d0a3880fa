/// Closing and ordering: which terms take part in an evaluation, and in which pass.
#include "CaseError.hpp"
#include "Plan.hpp"
#include "words.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

template<int dim>
Plan<dim>::Plan(const Catalogue<dim>& catalogue, const std::vector<std::string>& selected, std::set<std::string> given, std::set<std::string> current)
    : catalogue_(catalogue), given_(std::move(given)), current_(std::move(current))
{
    for (const auto& name : selected)
    {
        const auto found = std::find_if(catalogue_.begin(), catalogue_.end(), [&](const Entry& e) { return e.name == name; });
        if (found == catalogue_.end())
        {
            std::vector<std::string> known;
            for (const auto& e : catalogue_) known.push_back(e.name);
            throw CaseError(fmt::format("term \"{}\" is unknown. {}", name, suggestion(name, "terms", known)));
        }
        chosen_.push_back(&*found);
        reason_[&*found] = "selected";
    }
    close();
    order();
}

template<int dim> void Plan<dim>::close()
{
    std::map<std::string, const Entry*> provider;
    const auto provide = [&](const Entry* e)
    {
        if (!e->provides) return;
        if (const auto [p, fresh] = provider.try_emplace(e->result.info.name, e); !fresh)
            throw CaseError(fmt::format("field \"{}\" is provided by both {} and {}: select one", p->first, p->second->name, e->name));
    };
    std::set<std::string> added;
    for (const auto* e : chosen_)
    {
        provide(e);
        if (!e->provides) added.insert(e->result.info.name);
    }
    for (std::size_t k = 0; k < chosen_.size(); ++k)
        for (const auto* list : {&chosen_[k]->reads, &chosen_[k]->readsOwn})
            for (const auto& f : *list)
            {
                const std::string field = f.info.name;
                if (given_.contains(field) || provider.contains(field) || added.contains(field)) continue;
                std::vector<const Entry*> candidates;
                std::vector<std::string> names;
                for (const auto& e : catalogue_)
                    if (e.provides && e.result.info.name == field)
                    {
                        candidates.push_back(&e);
                        names.push_back(e.name);
                    }
                if (candidates.empty())
                    throw CaseError(fmt::format("term \"{}\" reads \"{}\" [{}], which the scene does not give and no term provides",
                                                chosen_[k]->name, field, f.info.unit));
                if (candidates.size() > 1)
                    throw CaseError(fmt::format("term \"{}\" reads \"{}\": select one of {}", chosen_[k]->name, field, fmt::join(names, ", ")));
                chosen_.push_back(candidates[0]);
                reason_[candidates[0]] = fmt::format("{} for {}", field, chosen_[k]->name);
                provide(candidates[0]);
            }
}

template<int dim> void Plan<dim>::order()
{
    std::set<std::string> waiting, stale;
    std::set_difference(given_.begin(), given_.end(), current_.begin(), current_.end(), std::inserter(stale, stale.end()));
    std::map<std::string, int> adders;
    for (const auto* e : chosen_) (e->provides ? void(waiting.insert(e->result.info.name)) : void(++adders[e->result.info.name]));
    // A rate that terms add to, and that another term reads, is there once all of them have added.
    for (const auto& [field, _] : adders)
        if (!given_.contains(field)) waiting.insert(field);
    auto left = chosen_;
    const std::string scale = GradientScale::info.name;
    const bool normalises = waiting.contains(scale) || given_.contains(scale);
    const auto normalised = [&](const Entry* e) { return normalises && e->pair && !e->ofRawGradient; };
    while (!left.empty())
    {
        const auto ready = [&](const Entry* e, bool pair)
        {
            bool all = e->pair == pair && !(normalised(e) && waiting.contains(scale));
            for (const auto* list : {&e->reads, &e->readsOwn})
                for (const auto& f : *list) all = all && !waiting.contains(f.info.name);
            return all;
        };
        Pass pass;
        for (bool pair : {false, true})
            if (pass.entries.empty())
                std::copy_if(left.begin(), left.end(), std::back_inserter(pass.entries), [&](auto* e) { return ready(e, pair); });
        if (pass.entries.empty())
            throw CaseError(fmt::format("terms \"{}\" and \"{}\" wait for one another's fields", left.front()->name, left.back()->name));
        int column = 0;
        for (const auto* e : pass.entries)
        {
            std::erase(left, e);
            pass.readsKernel = pass.readsKernel || e->readsKernel;
            pass.normalised = pass.normalised || normalised(e);
            if (const auto a = adders.find(e->result.info.name); a == adders.end() || --a->second == 0) waiting.erase(e->result.info.name);
            for (const auto& f : e->reads)
                if (pass.firstColumn.try_emplace(f.info.name, column).second)
                {
                    pass.columns.push_back(f);
                    column += f.type.components;
                    if (stale.erase(f.info.name)) pass.refresh.push_back(f);
                }
        }
        if (pass.normalised && stale.erase(scale)) pass.refresh.push_back(uses<dim>(Fields<GradientScale>{})[0]);
        for (const auto* e : pass.entries) stale.insert(e->result.info.name);
        if (column + 2 > Stencil<dim>::maxColumns) throw CaseError(fmt::format("one pass reads {} components at the neighbours, more than {}", column, Stencil<dim>::maxColumns - 2));
        passes_.push_back(std::move(pass));
    }
}

template Plan<2>::Plan(const Catalogue<2>&, const std::vector<std::string>&, std::set<std::string>, std::set<std::string>);
template Plan<3>::Plan(const Catalogue<3>&, const std::vector<std::string>&, std::set<std::string>, std::set<std::string>);

}
