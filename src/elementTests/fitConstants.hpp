/// Constants of any law from several measured tests at once, by least squares within bounds.
///
///   minimise  sum_i r_i^2,   r_i = (computed - measured)_i / largest magnitude of its curve
///
/// by Levenberg and Marquardt's method (Marquardt 1963, J. SIAM 11:431) with slopes by central differences; constants on a bound that the fit pulls
/// beyond it rest there. The confidence of a constant is that of the linear model at the end, with s^2 = sum r^2/(n - m) of n points and m constants:
///
///   covariance = s^2 (J^T J)^-1,   half-width of 95 % = t_0.975(n - m) sqrt(covariance_kk)
///
/// A constant that no test depends on, some that cannot be told apart (a singular value of J with columns of length 1 below 1e-4), and one whose half-width
/// is wider than its bounds are refused, with the test that the law names for it. Verified by test/unit/elementTests: computed tests, with scatter, give
/// the constants back that they were computed with, within their confidence.
#pragma once
#include "elementTests/ElementTest.hpp"
#include <functional>

namespace sph
{

struct FittedConstant
{
    std::string entry; ///< in the coefficients of the law, `intergranularStrain.R` below a sub-dictionary
    double least, largest;
    Location where;
};

/// What was measured at the ends of the legs of a test, and what of a row it is.
struct MeasuredCurve
{
    std::string name;
    std::vector<double> values;
    std::function<double(const ElementRow&)> of;
};

struct MeasuredTest
{
    ElementTest test; ///< a leg for each point
    std::vector<MeasuredCurve> curves;
};

struct FitPlan
{
    std::vector<FittedConstant> constants;
    std::vector<MeasuredTest> tests;
    Location where;
};

/// The soil with those constants, and the tests as they begin with it; throws CaseError where there are none.
using FitTrial = std::function<std::pair<Soil, std::vector<MeasuredTest>>(const std::vector<double>&)>;

struct Fit
{
    struct Constant
    {
        double value, standardError, halfWidth; ///< of 95 %
        bool onBound = false;
    };
    std::vector<Constant> constants;
    std::vector<std::vector<double>> misfits; ///< root mean square of each test's curves, over the largest magnitude
    std::size_t points = 0;
};

/// Throws CaseError where a constant cannot be found.
Fit fitConstants(const FitPlan&, const std::vector<double>& start, const FitTrial&);

}
