/// The models of the suite, each registered once.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

/// All models, in the order in which their terms add to a rate, and their stages join a place.
const std::vector<const Model*>& models();
/// Terms of all models, and of the operators that they share.
template<int dim> const Catalogue<dim>& allTerms();

}
