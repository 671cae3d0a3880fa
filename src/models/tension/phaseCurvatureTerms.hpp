/// The terms of PhaseCurvature.hpp, one set for each phase.
#pragma once
#include "scene/Settings.hpp"

namespace sph
{

/// gamma_k of each phase: gamma_kl = gamma_k + gamma_l, exactly for three, else in least squares.
std::vector<double> tensionShares(const Coefficients&);
/// Largest error of gamma_k + gamma_l against the tension of a pair, over the largest tension.
double missedByShares(const Coefficients&);
/// cos(theta_kl) through k, [wall x phases x phases], from the walls' tensions.
std::vector<double> wallCosines(const Coefficients&);

struct PhaseCurvatureForms
{
    bool even = true;      ///< the force beside the pressure of Hu & Adams
    bool adhering = false; ///< normals turn to the contact angle at walls
};
/// Defines the terms, and returns the names of those to select.
std::vector<std::string> definePhaseCurvature(Settings&, PhaseCurvatureForms);

}
