/// Catalogue of terms: name in, bound term out. A new term is one new file and one word in the list that its model's `catalogue` is called with.
#pragma once
#include "plan/terms.hpp"
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace sph
{

/// The loop that a term runs in: over particles, pairs of neighbours, or nearest places of walls.
enum class Over
{
    particles,
    pairs,
    walls
};

template<int dim> struct CatalogueEntry
{
    std::string name;
    Over over;
    bool provides, advances, readsKernel, ofRawGradient, bearsSingle, mayBeNothing;
    std::vector<FieldUse<dim>> results, reads, readsOwn;
    std::function<std::unique_ptr<Operation<dim>>(const Coefficients&, const Binding<dim>&)> bind;
    Names names; ///< of fields that are not called as their tags
};

template<int dim> using Catalogue = std::vector<CatalogueEntry<dim>>;

/// A term as an entry; `make` gives it its numbers.
template<int dim, class T, class Make> CatalogueEntry<dim> termEntry(std::string name, const Make& make, const Names& names = {})
{
    static_assert(PairTerm<T, dim> + LocalLaw<T, dim> + WallLaw<T, dim> == 1);
    constexpr Over over = PairTerm<T, dim> ? Over::pairs : LocalLaw<T, dim> ? Over::particles : Over::walls;
    return {std::move(name),
            over,
            provides<T>,
            advances<T>,
            readsKernel<T>,
            ofRawGradient<T>,
            bearsSingle<T>,
            mayBeNothing<T, dim>,
            uses<dim>(ResultsOf<T>{}, names),
            uses<dim>(ReadsOf<T>{}, names),
            uses<dim>(ReadsOwnOf<T>{}, names),
            [make](const Coefficients& c, const Binding<dim>& b) -> std::unique_ptr<Operation<dim>>
            { return std::make_unique<Bound<T, dim>>(make(c), b); },
            names};
}

/// An entry of a catalogue under the name `as`, whose results go to fields of other names.
template<int dim>
CatalogueEntry<dim> redirected(const Catalogue<dim>& catalogue, const std::string& term, std::string as, const Names& results)
{
    auto entry = *std::find_if(catalogue.begin(), catalogue.end(), [&](const auto& e) { return e.name == term; });
    entry.name = std::move(as);
    for (auto& f : entry.results) f.name = nameIn(results, f.name.c_str());
    entry.names.insert(results.begin(), results.end());
    return entry;
}

template<int dim, class... T> Catalogue<dim> catalogue()
{
    const auto make = []<class Term>(std::type_identity<Term>)
    {
        return [](const Coefficients& c)
        {
            if constexpr (std::constructible_from<Term, const Coefficients&>) return Term(c);
            else return Term{};
        };
    };
    return {termEntry<dim, T>(T::name, make(std::type_identity<T>{}))...};
}

}
