/// Exact solution: Taylor and Green's decaying vortices.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Decaying array of vortices, periodic over L in x and y: Taylor & Green (1937), in two dimensions exact
///
///   u = -U cos(k x) sin(k y) exp(-2 nu k^2 t),   v = U sin(k x) cos(k y) exp(-2 nu k^2 t),
///   p = -rho U^2/4 (cos(2 k x) + cos(2 k y)) exp(-4 nu k^2 t),   k = 2 pi/L
///
/// U [m/s] greatest speed at t = 0, L [m] period, nu [m^2/s] kinematic viscosity, rho [kg/m^3], x from `origin`.
class TaylorGreen
{
    double U_, L_, nu_, rho_;
    Vector<3> origin_;

public:
    TaylorGreen(double speed, double period, double nu, double rho);
    static EntryList entries();
    explicit TaylorGreen(const Dictionary&);

    Vector<3> velocity(const Vector<3>& x, double t) const;
    double pressure(const Vector<3>& x, double t) const;
};

}
