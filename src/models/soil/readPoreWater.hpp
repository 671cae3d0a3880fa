/// `poreWater` of constant/soilProperties:
///
///     poreWater
///     {
///         permeability    1e-4;                           // [m/s]; 0: undrained
///         porosity        0.4;
///         bulkModulus     2.2e9;                          // [Pa] of the water
///         density         1000;                           // [kg/m^3]
///         freeSurface     drained;                        // or closed
///         walls           { base { porePressure 0; } left { flux 1e-6; } }    // nothing passes all others
///         initial         { type uniform; pressure 0; }   // or { type hydrostatic; waterTable 1; }
///     }
#pragma once
#include "dictionary/EntryList.hpp"
#include "models/soil/PoreWater.hpp"
#include "scene/Model.hpp"
#include <functional>

namespace sph
{

/// Pore pressure [Pa] at a place, where no field gives it.
using InitialPorePressure = std::function<double(Vector<3>)>;

/// Reads the water, declares its state, and gives what it begins with; null where soilProperties has no such entry, and the scene no water.
InitialPorePressure readPoreWater(const Reading&, const Dictionary& ofSoil);
/// Selects terms and groups of a scene with water; `force`: the terms that are the divergence of -p I, of the form that the soil's stress has; `showsVelocity`: what seeps is written.
void selectPoreWater(const Reading&, const std::vector<std::string>& force, bool showsVelocity);

/// The sub-dictionary with its entries.
ListedEntry poreWaterEntries();

}
