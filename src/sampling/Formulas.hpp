/// Exact solutions that `errors` can compare a field with. They come from libraries that a case names by `libs`: those of the suite from libsphVerification.so.
#pragma once
#include "dictionary/EntryList.hpp"
#include <functional>
#include <string>

namespace sph
{

/// The exact field at x [m] and t [s]; a scalar is in the first component.
using ExactField = std::function<Vector<3>(const Vector<3>& x, double t)>;

/// A solution of one field by the word for `name`, how it is read, and which entries it has.
struct Formula
{
    std::string name, field;
    ExactField (*read)(const Dictionary&);
    EntryList (*entries)();
    std::vector<std::string> idle = {}; ///< keywords that another field of the formula alone needs
};

/// The formula of a class that is made of a Dictionary, and has `velocity(x, t)` and the static function `entries`.
template<class Solution> Formula velocityFormula(const std::string& name, const std::vector<std::string>& idle = {})
{
    return {name, "U",
            [](const Dictionary& dictionary) -> ExactField
            { return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return solution.velocity(x, t); }; },
            Solution::entries, idle};
}

/// The same of a scalar field, which the class gives by the function `value`: scalarFormula<Hydrostatic, &Hydrostatic::pressure>("hydrostatic", "p").
template<class Solution, auto value>
Formula scalarFormula(const std::string& name, const std::string& field, const std::vector<std::string>& idle = {})
{
    return {name, field,
            [](const Dictionary& dictionary) -> ExactField {
                return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return Vector<3>{(solution.*value)(x, t), 0, 0}; };
            },
            Solution::entries, idle};
}

/// Adds a formula while it is constructed. Those of one name stand one after another.
struct AddedFormula
{
    explicit AddedFormula(const Formula&);
};

/// All that there are now, in the order in which they were added.
const std::vector<Formula>& allFormulas();

/// The formulas with their entries.
Cases formulas();

/// Reads the parameters of formula `name`, one of these, from the dictionary in which `name planePoiseuille;` stands.
/// `field` must be one that the formula gives, and parameters that its other fields alone need must not be there. Mistakes are recorded, and then the result may be empty.
ExactField readFormula(const std::string& name, const Dictionary&, const std::string& field);

}
