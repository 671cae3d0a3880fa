/// constant/transportProperties: what moves relative to the flow. Scenes without the file have nothing of it.
#pragma once
#include "Settings.hpp"

namespace sph
{

///     suspension
///     {
///         phi         0.55;                   // volume fraction of powder at the start, where the time folder has no field phi
///         phiMax      0.68;                   // of the densest packing
///         exponent    1.82;                   // c of Krieger's viscosity; mu of constant/phaseProperties is that of the binder
///         phiCritical 0.6732;                 // from where the viscosity is capped; 0.99 phiMax by default
///         Dc          0.41;                   // of Phillips' fluxes
///         Deta        0.62;
///         diameter    1e-6;                   // of the powder's particles [m]; or `radius`
///         a           radius;                 // what D_c and D_eta multiply the square of: diameter or radius, a factor 4 in time
///         noSteadyState refuse;               // or warn: D_c/D_eta >= 1, where powder migrates until it is packed
///     }
void readTransport(const Case&, Settings&);

}
