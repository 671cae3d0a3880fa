#pragma once
#include "case/Case.hpp"
#include "decomposition/estimate.hpp"
#include <optional>
#include <string>

namespace sph
{

/// What a run of so many ranks would have to do, from the particles of a time folder of the case; nothing is written.
std::string estimateReport(const Case&, const std::string& time, int ranks, const Costs&, std::optional<double> scaleTo);

}
