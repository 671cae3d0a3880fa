/// What the benchmarks share: the clock, the jittered block that the yardstick runs on, and figures by name.
#pragma once
#include "PairLimit.hpp"
#include <string>
#include <utility>
#include <vector>

namespace sph
{

/// `name value unit`, one line a figure.
struct Figure
{
    std::string name;
    double value;
    std::string unit;
};
using Figures = std::vector<Figure>;

/// Wall clock [s].
double now();
/// Duration of one call [s].
template<class F> double secondsOf(F&& f)
{
    const double start = now();
    f();
    return now() - start;
}

/// n^3 particles at unit spacing, displaced by up to a tenth of it, sorted by cells, without walls or periods: support 2.6 spacings,
/// about 75 neighbours inside the block.
PairLimit jitteredBlock(int n);

}
