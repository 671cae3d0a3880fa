/// The catalogue of exact solutions that `errors` can compare a field with. A new one is one file and one word in Formulas.cpp.
#pragma once
#include "dictionary/EntryList.hpp"
#include <functional>
#include <string>

namespace sph
{

/// The exact field at x [m] and t [s]; a scalar is in the first component.
using ExactField = std::function<Vector<3>(const Vector<3>& x, double t)>;

/// The formulas with their entries.
Cases formulas();

/// Reads the parameters of formula `name`, one of these, from the dictionary in which `name planePoiseuille;` stands.
/// `field` must be one that the formula gives, and parameters that its other fields alone need must not be there. Mistakes are recorded, and then the result may be empty.
ExactField readFormula(const std::string& name, const Dictionary&, const std::string& field);

}
