/// Share of the space between the walls that particles fill at the first time.
#pragma once
#include "case/Case.hpp"
#include "geometry/Geometry.hpp"
#include <optional>

namespace sph
{

/// Share of the space between the walls that the particles of the case's first time folder fill, each with spacing^dimension, to a per cent or so. Nothing
/// where there are no particles yet. Particles neither come nor go without openings: a restart sees the same.
std::optional<double> shareFilled(const Case&, const Geometry&, double spacing);

}
