/// Planes across ducts through which fluid comes into a scene or leaves it.
#pragma once
#include "Case.hpp"
#include "Coefficients.hpp"
#include "EntryList.hpp"
#include "Geometry.hpp"
#include "State.hpp"
#include <map>
#include <optional>

namespace sph
{

struct Opening
{
    std::string name;
    bool inlet = true;
    Vector<3> point, normal;              ///< of the plane [m]; unit, into the scene
    Box extent;                           ///< the plane is open within it alone
    std::optional<double> velocity;       ///< mean over the section, along the normal [m/s]
    std::optional<double> flowRate;       ///< [m^3/s], per metre of depth [m^2/s] in 2-D
    std::optional<double> pressure;       ///< at the plane [Pa], without the background pressure; of an inlet, the most there is
    bool developed = false;               ///< the velocity has the profile of developed flow; else it is the same everywhere
    std::map<std::string, double> values; ///< of what comes in, by field
    Location where;

    /// Distance from the plane [m], > 0 in the scene.
    double distance(const Vector<3>& x) const { return dot(x - point, normal); }
};

/// Reads constant/openings, one dictionary an opening; none where there is no such file:
///
///     gate { type inlet; point (0 0 0); normal (1 0 0); flowRate 1e-9; profile developed; }
///     vent { type outlet; point (1 0 0); normal (-1 0 0); pressure 0; }
///
/// Mistakes go to the case's Diagnostics. `absent`: what would come in with a model that the scene does not have, and what to say to it.
std::vector<Opening> readOpenings(const Case&, const Geometry&, const Coefficients&, const State&,
                                  const std::map<std::string, std::string>& absent = {});
EntryList openingEntries();

}
