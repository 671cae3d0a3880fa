/// The yardstick of the rates: pressure, viscosity and continuity of a single phase fused by hand in one vectorised loop over plain
/// neighbour lists without padding, eight arrays gathered, double precision, one thread. What one core of a machine can reach.
#pragma once
#include <vector>

namespace sph
{

struct PairLimit
{
    std::vector<double> x, y, z, u, v, w, rho, p;
    std::vector<int> begin{0}, list; ///< neighbours within the support, self left out
    double h;                        ///< half the support of the Wendland C2 kernel
    std::vector<double> ax, ay, az, rate;

    void evaluate();
};

}
