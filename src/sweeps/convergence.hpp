/// Conclusions from a table of errors and costs: order of convergence, the best at each cost, the expected cost of a finer run.
#pragma once
#include "sweeps/ResultTable.hpp"
#include <optional>
#include <span>

namespace sph
{

/// Sets `order` of each row to p of e = c h^p through it and the next coarser row of its variant that ended well, and to unknown
/// where there is none. The rows are those of one field, norm and time.
void setObservedOrders(std::span<ResultRow>);

/// y = factor x^exponent
struct PowerLaw
{
    double factor = 0, exponent = 0;
};

/// Least squares in log y over log x; nothing with fewer than two different x. All numbers must be positive.
std::optional<PowerLaw> fitPowerLaw(std::span<const double> x, std::span<const double> y);

/// Whether each row belongs to the Pareto front: it ended well, and no other row has less error at no more processor time,
/// or as little error at less.
std::vector<bool> paretoFront(std::span<const ResultRow>);

/// Wall time of a run [s], guessed from those that ended well: by the power law of the last two resolutions of its variant; by one
/// of them and the power of another variant, or 3; by the same resolution of another variant. Nothing where there is nothing to go by.
std::optional<double> expectedWallSeconds(std::span<const ResultRow>, const std::string& variant, double resolution);

}
