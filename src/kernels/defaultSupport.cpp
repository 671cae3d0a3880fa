#include "kernels/defaultSupport.hpp"
#include "base/words.hpp"
#include "kernels/Kernel.hpp"
#include <fmt/format.h>
#include <stdexcept>
#include <vector>

namespace sph
{

double defaultSupport(const std::string& kernel)
{
    if (kernel == WendlandC2<3>::name) return 3.05;
    if (kernel == WendlandC4<3>::name) return 3.4;
    if (kernel == WendlandC6<3>::name) return 3.6;
    if (kernel == CubicSpline<3>::name) return 2.65;
    if (kernel == QuinticSpline<3>::name) return 2.8;
    throw std::invalid_argument("no kernel is named " + kernel);
}

std::string defaultSupports()
{
    std::vector<std::string> supports;
    for (const auto& name : kernelNames()) supports.push_back(fmt::format("{:g} of {}", defaultSupport(name), name));
    return list(supports);
}

}
