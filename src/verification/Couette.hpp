/// Exact solution: plane Couette flow started from rest.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Flow between a plate at rest and one that moves at V from t = 0 on: Morris, Fox & Zhu (1997), eq. (23)
///
///   v(y, t) = V y/L + sum_n 2 V/(n pi) (-1)^n sin(n pi y/L) exp(-n^2 pi^2 nu t/L^2)
///
/// V [m/s], nu [m^2/s] kinematic viscosity, L [m] width, y [m] distance from the plate at rest, through `origin`.
/// For nu t/L^2 < 0.05 the same solution as a sum of images: v = V sum_k [erfc((2k L + L - y)/s) - erfc((2k L + L + y)/s)],
/// s = 2 sqrt(nu t).
class Couette
{
    double nu_, L_;
    Vector<3> V_, normal_, origin_;
    bool steady_;

public:
    Couette(double nu, double speed, double width);
    static EntryList entries();
    explicit Couette(const Dictionary&);

    /// v/V
    double relativeSpeed(double y, double t) const;
    Vector<3> velocity(const Vector<3>& x, double t) const { return relativeSpeed(dot(x - origin_, normal_), t) * V_; }
};

}
