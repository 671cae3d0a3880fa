#pragma once
#include "base/Single.hpp"

namespace sph
{

/// a^2 + b^2, the same for b and a: as a fused product and sum that of singles would differ in the last digit, and forces of pairs would not cancel.
constexpr double sumOfSquares(double a, double b) { return a * a + b * b; }
constexpr Single sumOfSquares(Single a, Single b) { return sqr(a + b) - 2 * (a * b); }

}
