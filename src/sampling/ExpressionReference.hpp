/// A reference field from its formula in the dictionary.
#pragma once
#include "sampling/Formulas.hpp"

namespace sph
{

/// Dictionary:
///
///     type expression;
///     value "exp(-4*$t)*sin(2*pi()*$x)";       // of $x $y $z [m] and $t [s]; vector(.., .., ..) for vectors as a whole
///
/// Without a value that can be computed the result is empty, and the mistake is recorded.
ExactField readExpressionReference(const Dictionary&);
EntryList expressionReferenceEntries();

}
