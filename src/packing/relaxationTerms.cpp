#include "packing/relaxationTerms.hpp"
#include "models/density/densityTerms.hpp"
#include "packing/Repulsion.hpp"
#include "packing/WallDistance.hpp"

namespace sph
{

template<int dim> Catalogue<dim> relaxationTerms(double V0)
{
    auto terms = densityTerms<dim>();
    terms.push_back(termEntry<dim, Repulsion>(Repulsion::name, [V0](const Coefficients&) { return Repulsion{V0}; }));
    terms.push_back(termEntry<dim, WallDistance>(WallDistance::name, [](const Coefficients&) { return WallDistance{}; }));
    return terms;
}

template Catalogue<2> relaxationTerms<2>(double);
template Catalogue<3> relaxationTerms<3>(double);

}
