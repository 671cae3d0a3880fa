/// Name in, bound term out. A new model is one new file and one word in the list that `catalogue` is called with.
#pragma once
#include "terms.hpp"
#include <functional>
#include <string>
#include <vector>

namespace sph
{

template<int dim> struct CatalogueEntry
{
    std::string name;
    bool pair, provides, readsKernel, ofRawGradient;
    FieldUse<dim> result;
    std::vector<FieldUse<dim>> reads, readsOwn;
    std::function<std::unique_ptr<Operation<dim>>(const Binding<dim>&)> bind;
};

template<int dim> using Catalogue = std::vector<CatalogueEntry<dim>>;

template<int dim, class... T> requires ((PairTerm<T, dim> != LocalLaw<T, dim>) && ...) Catalogue<dim> catalogue()
{
    return {{T::name, PairTerm<T, dim>, provides<T>, readsKernel<T>, ofRawGradient<T>, uses<dim>(Fields<ResultOf<T>>{})[0], uses<dim>(ReadsOf<T>{}),
             uses<dim>(ReadsOwnOf<T>{}),
             [](const Binding<dim>& b) -> std::unique_ptr<Operation<dim>> { return std::make_unique<Bound<T, dim>>(b); }}...};
}

}
