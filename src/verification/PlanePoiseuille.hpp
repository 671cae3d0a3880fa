/// Exact solution: plane Poiseuille flow started from rest.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Flow between two plates at rest, started from rest by a body force at t = 0: Morris, Fox & Zhu (1997), eq. (21)
///
///   v(y, t) = F/(2 nu) y (L - y) - sum_n 4 F L^2/(nu pi^3 (2n + 1)^3) sin(pi y (2n + 1)/L) exp(-(2n + 1)^2 pi^2 nu t/L^2)
///
/// F [m/s^2] acceleration, nu [m^2/s] kinematic viscosity, L [m] width, y [m] distance from the plate through `origin`.
/// With `steady yes;` the first part alone. For nu t/L^2 < 0.05 the same solution as a sum of images,
/// v = F t (1 - 4 sum_k (-1)^k [i2erfc((k L + y)/s) + i2erfc((k L + L - y)/s)]), s = 2 sqrt(nu t), of which a few terms do.
class PlanePoiseuille
{
    double nu_, F_, L_;
    Vector<3> direction_, normal_, origin_;
    bool steady_;

public:
    PlanePoiseuille(double nu, double acceleration, double width);
    static EntryList entries();
    explicit PlanePoiseuille(const Dictionary&);

    /// [m/s]
    double speed(double y, double t) const;
    Vector<3> velocity(const Vector<3>& x, double t) const { return speed(dot(x - origin_, normal_), t) * direction_; }
};

}
