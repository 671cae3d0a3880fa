/// Exact solution: dam break on a dry bed.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Dam break on a dry bed without friction, in shallow water: Ritter (1892)
///
///   h = (2 c - x/t)^2/(9 g),   u = 2/3 (c + x/t),   c = sqrt(g h_0),   where -c t < x < 2 c t
///
/// h_0 [m] depth of the reservoir in x < 0 before, g [m/s^2], t [s] since the dam is gone, x [m] from `origin` along `direction`. The front
/// runs at 2 c and the depth at the dam stays at 4/9 h_0. Pressure is hydrostatic, p = rho g max(0, h - y), y [m] height above `origin`
/// along `up`. Valid where the water is shallow beside its length: t sqrt(g/h_0) well above 1. No real front is faster.
class Ritter
{
    double depth_, g_, rho_;
    Vector<3> direction_, up_, origin_;

public:
    Ritter(double depth, double g, double rho);
    static EntryList entries();
    explicit Ritter(const Dictionary&);

    /// [m] at x [m] along the direction
    double depth(double x, double t) const;
    /// [m/s]; 0 where there is no water.
    double speed(double x, double t) const;

    Vector<3> velocity(const Vector<3>& x, double t) const { return speed(dot(x - origin_, direction_), t) * direction_; }
    double pressure(const Vector<3>& x, double t) const;
};

}
