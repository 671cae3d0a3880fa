/// Openings: planes through which fluid comes into a scene or leaves it, with what drives it and what comes in.
#pragma once
#include "case/Case.hpp"
#include "geometry/OpenPlane.hpp"
#include "plan/Coefficients.hpp"
#include "scene/State.hpp"
#include <map>
#include <optional>

namespace sph
{

/// Incoming fluid: its phase, and the values that its particles get.
struct Stream
{
    std::size_t phase = 0;
    std::map<std::string, double> values = {}; ///< values by field
};
/// A part of an inlet through which another phase comes in.
struct Layer
{
    Box extent;
    Stream stream;
};

struct Opening : OpenPlane
{
    std::optional<double> velocity = {}; ///< mean over the section, along the normal [m/s]
    std::optional<double> flowRate = {}; ///< [m^3/s], per metre of depth [m^2/s] in 2-D
    std::optional<double> pressure = {}; ///< at the plane [Pa], beside the background's; of an inlet the most; none where it lets fall
    bool developed = false;              ///< the velocity has the profile of developed flow; else it is the same everywhere
    Stream stream = {};                  ///< what comes in, through an outlet with `backflow` where the flow is inwards
    std::vector<Layer> layers = {};
    bool backflow = false;
    std::optional<double> markFrom = {}; ///< what comes in from this time [s] on tells when it did

    bool brings(std::size_t phase) const;
    /// An outlet of a liquid alone that gives no pressure: what has left falls freely.
    bool letsFall() const { return !inlet && !pressure; }
    const Stream& streamAt(const Vector<3>& x, int dimension) const;
};

/// The time at which a marked particle came in; < 0 for all others.
struct EntryTime
{
    static constexpr FieldInfo info{"enteredAt", "s"};
    static constexpr double notMarked = -1;
    template<int dim, class Real = double> struct At
    {
        Real enteredAt;
    };
};

/// Reads constant/openings, one dictionary an opening; none where there is no such file:
///
///     gate { type inlet; point (0 0 0); normal (1 0 0); flowRate 1e-9; profile developed; }
///     vent { type outlet; point (1 0 0); normal (-1 0 0); pressure 0; }
///     drip { type drip; points ((0.2 1 0) (0.6 1 0)); radius 0.05; normal (0 -1 0); flowRate 1e-9; phase water; }
///
/// Each point of a drip is an opening, drip1, drip2 ... Mistakes go to the case's Diagnostics. `absent`: what would come in with a model that the scene
/// does not have, and what to say to it. `alone`: the gas is left out.
std::vector<Opening> readOpenings(const Case&, const Geometry&, const Coefficients&, const State&,
                                  const std::map<std::string, std::string>& absent = {}, bool alone = false);
EntryList openingEntries();

}
