/// Materials of a case, from constant/phaseProperties and constant/g.
#pragma once
#include "dictionary/EntryList.hpp"
#include "scene/Settings.hpp"

namespace sph
{

///     phases (water air);
///     water { rho [1 -3 0 0 0 0 0] 1000; mu [1 -1 -1 0 0 0 0] 1e-3; soundSpeed [0 1 -1 0 0 0 0] 10; exponent 7; }
///     air   { ... }
///
/// `soundSpeed automatic;` takes 10 times the largest of the velocities that `expected { velocity; depth; pressure; radius; }` implies, and
/// says why; with `gas none;` 3 to 10 times, as its free surface bears. A given one that this surface does not bear is warned of.
void readPhases(const Case&, const Dictionary& phaseProperties, Settings&);
/// Names of the phases, gravity and body force: what models may declare facts by.
void readScene(const Case&, const Dictionary& phaseProperties, Settings&);
/// Warns of a phase whose sound speed is too low for the pressures of an interface; to be called once all models have read.
void warnOfSoftPhases(const Case&, const Settings&);
EntryList phaseEntries();
EntryList gravityEntries();

}
