/// What the particles of a case's first time folder say before any is loaded: how much of the space they fill, and whether they are of one phase.
/// Without openings particles neither come nor go: a restart sees the same.
#pragma once
#include "case/Case.hpp"
#include "geometry/Geometry.hpp"
#include <optional>

namespace sph
{

/// Share of the space between the walls that the particles fill, each with spacing^dimension, to a per cent or so. Nothing where there are no particles yet.
std::optional<double> shareFilled(const Case&, const Geometry&, double spacing);

/// The phase of all particles, of a case that lists several (numbers begin at 0); nothing where there are two phases or no particles yet, or where their file cannot be read.
std::optional<int> lonePhase(const Case&);

}
