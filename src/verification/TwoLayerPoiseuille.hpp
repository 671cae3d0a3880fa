/// Exact solution: plane Poiseuille flow of two layers.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Steady flow of two layers of immiscible liquids between plates at rest, driven by a pressure gradient, a body force or both.
/// In each layer k, mu_k v'' = -G_k with G_k = dp + rho_k f, and velocity and shear stress are continuous at the interface:
///
///   v_1 = y/(2 mu_1) (2 tau_0 - G_1 y),        tau_0 stress on the plate at y = 0 [Pa]
///   v_2 = z/(2 mu_2) (2 tau_L - G_2 z),        z = H_1 + H_2 - y, tau_L stress on the other plate
///   tau_0 - G_1 H_1 = -(tau_L - G_2 H_2),      v_1(H_1) = v_2(H_1)
///
/// mu [Pa s], rho [kg/m^3], H [m] of layer 1 (at `origin`) and 2; dp [Pa/m] = -dp/dx; f [m/s^2] acceleration.
class TwoLayerPoiseuille
{
    double mu1_, mu2_, H1_, H2_, G1_, G2_, tau0_, tauL_;
    Vector<3> direction_, normal_, origin_;

public:
    TwoLayerPoiseuille(double mu1, double mu2, double H1, double H2, double G1, double G2);
    static EntryList entries();
    explicit TwoLayerPoiseuille(const Dictionary&);

    double speed(double y) const;
    double wallStress() const { return tau0_; }
    Vector<3> velocity(const Vector<3>& x, double) const { return speed(dot(x - origin_, normal_)) * direction_; }
};

}
