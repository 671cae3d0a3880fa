/// Exact solution: steady flow of a suspension in a channel or pipe.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Steady flow of a suspension between two plates, or in a circular pipe, driven by a pressure gradient G, after its powder has migrated by
/// Phillips' fluxes with Krieger's viscosity: phi gammaDot mu^r is uniform, r = D_eta/D_c, and mu gammaDot = G |y|, whence
///
///   s = (phi_0/phi) ((phi_m - phi)/(phi_m - phi_0))^n,    s = |y|/h,  n = c (r - 1),    mean of phi over s = phi at the start
///   U = G h^2/mu_0 int_s^1 s' (1 - phi(s')/phi_m)^c ds'
///
/// n = 1, D_c/D_eta = 1/(1 + 1/c), gives eq. (4.1) of Kauzlaric et al. (2011), phi = phi_m phi_0/(phi_0 + s (phi_m - phi_0)). y [m] from
/// the middle, h [m] half the width, phi_0 at the walls, phi_m and c of Krieger's law, mu_0 [Pa s] of the binder. Neither the powder's size
/// nor D_c enters. Where D_c/D_eta >= 1 there is no steady state. In a pipe of radius h the same profile holds over s = r/h, with the mean
/// over the section, 2 int_0^1 phi s ds, and half the speed, since mu gammaDot = G r/2.
class SuspensionChannel
{
    double width_, phiMax_, exponent_, n_, wall_, speedScale_;
    Vector<3> direction_, normal_, origin_;
    bool pipe_;
    std::vector<double> integral_; ///< of U, at equal steps of s from 0 to 1

public:
    static EntryList entries();
    explicit SuspensionChannel(const Dictionary&);

    /// Volume fraction of powder at s = |y|/h from 0 (middle) to 1 (wall).
    double phi(double s) const;
    double wallPhi() const { return wall_; }
    /// [m/s]
    double speed(double s) const;

    double value(const Vector<3>& x, double) const { return phi(fromMiddle(x)); }
    Vector<3> velocity(const Vector<3>& x, double) const { return speed(fromMiddle(x)) * direction_; }

private:
    double fromMiddle(const Vector<3>& x) const;
    double place(double phi) const;
    double meanPhi() const;
};

}
