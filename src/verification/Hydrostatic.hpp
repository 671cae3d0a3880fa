/// Exact solution: hydrostatic pressure of layers.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Pressure at rest under any number of layers, each of constant density
///
///   p(y) = p_top + |g| sum_k rho_k (part of layer k above y)
///
/// y [m] height above `origin` against g [m/s^2]; heights [m] and densities [kg/m^3] of the layers from the bottom up.
/// Above the top p = p_top [Pa], below the bottom the lowest layer goes on.
class Hydrostatic
{
    std::vector<double> heights_, densities_;
    Vector<3> g_, origin_;
    double pTop_;

public:
    Hydrostatic(std::vector<double> heights, std::vector<double> densities, const Vector<3>& g);
    static EntryList entries();
    explicit Hydrostatic(const Dictionary&);

    double pressure(const Vector<3>& x, double) const;
};

}
