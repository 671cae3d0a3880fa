/// The one way in which a view gets what does not change from time to time: for a run, and for times that are looked at afterwards.
#pragma once
#include "plan/Coefficients.hpp"
#include "sampling/ParticleView.hpp"

namespace sph
{

/// A view without particles, and without a time, but with the gravity of one. The geometry must outlive it.
ParticleView viewOfScene(const Coefficients&, const Vector<3>& gravity, const std::string& kernel, const Geometry&);

}
