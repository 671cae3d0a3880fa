/// The yardstick of the rates: pressure, viscosity and continuity of a single phase fused by hand in one vectorised loop over plain
/// neighbour lists without padding, eight arrays gathered, one thread. What one core of a machine can reach, in double precision and in single.
#pragma once
#include <vector>

namespace sph
{

template<class Real> struct PairLimitOf
{
    std::vector<Real> x, y, z, u, v, w, rho, p;
    std::vector<int> begin{0}, list; ///< neighbours within the support, self left out
    Real h;                          ///< half the support of the Wendland C2 kernel
    std::vector<Real> ax, ay, az, rate;

    void evaluate();
};
using PairLimit = PairLimitOf<double>;

/// The same block in single precision.
PairLimitOf<float> inSinglePrecision(const PairLimit&);

}
