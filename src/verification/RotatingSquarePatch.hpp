/// Exact solution: the initial pressure in a rotating square of fluid.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Pressure in a square of inviscid fluid that is set in rigid rotation at t = 0, free of pressure on its sides: Colagrossi (2005)
///
///   laplacian p = 2 rho omega^2,   p = 0 on the sides
///   p = rho omega^2 [X^2 - L^2/4 + sum_(n odd) 8 L^2/(n pi)^3 (-1)^((n-1)/2) cos(n pi X/L) cosh(n pi Y/L)/cosh(n pi/2)]
///
/// L [m] side, omega [1/s], X, Y [m] from the centre along the sides. At the centre p = -0.147343 rho omega^2 L^2. It is the pressure
/// at t = 0; as it is even in time, it holds to the order of (omega t)^2. 0 outside of the square.
class RotatingSquarePatch
{
    double side_, omega_, rho_;
    Vector<3> centre_;

public:
    RotatingSquarePatch(double side, double omega, double rho);
    static EntryList entries();
    explicit RotatingSquarePatch(const Dictionary&);

    double pressure(const Vector<3>& x, double) const;
};

}
