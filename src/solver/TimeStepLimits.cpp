#include "solver/TimeStepLimits.hpp"
#include "solver/models.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

std::vector<StepLimit> stepLimits(const Settings& settings, const Measured& measured, std::vector<StepLimit> ofParts)
{
    auto limits = std::move(ofParts);
    if (settings.integration.moves)
        for (const auto* model : models())
            for (const auto limit : model->limits)
                if (const auto step = limit(settings, measured)) limits.push_back(*step);
    std::erase_if(limits, [](const StepLimit& limit) { return limit.deltaT == std::numeric_limits<double>::infinity(); });
    return limits;
}

int partsOf(double deltaT, const Settings& settings, const std::vector<StepLimit>& limits)
{
    double parts = 1;
    for (const auto& limit : limits)
        if (limit.ofSubstep) parts = std::max(parts, deltaT / limit.deltaT * settings.integration.maxSubSteps);
    const double roundOff = 1e-9; // a step of the limit itself takes no part more
    return std::min(settings.integration.maxSubSteps,
                    2 * int(std::ceil((std::min<double>(parts, settings.integration.maxSubSteps) - 1) / 2 - roundOff)) + 1);
}

StepLimit leastOf(const std::vector<StepLimit>& limits)
{
    const auto least = std::min_element(limits.begin(), limits.end(), [](const auto& a, const auto& b) { return a.deltaT < b.deltaT; });
    return least == limits.end() ? StepLimit{std::numeric_limits<double>::infinity(), "none"} : *least;
}

}
