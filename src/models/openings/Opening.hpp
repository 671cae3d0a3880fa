/// Planes through which fluid comes into a scene or leaves it.
#pragma once
#include "case/Case.hpp"
#include "dictionary/EntryList.hpp"
#include "geometry/Geometry.hpp"
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

struct Opening
{
    std::string name;
    bool inlet = true;
    Vector<3> point, normal;        ///< of the plane [m]; unit, into the scene
    Box extent;                     ///< the plane is open within it alone
    double margin = 0;              ///< beside the extent, where what passes the plane leaves all the same [m]
    std::optional<double> radius;   ///< and this near to `point` [m]
    std::vector<Opening> without;   ///< other openings in the same plane, which have their parts of it
    std::optional<double> velocity; ///< mean over the section, along the normal [m/s]
    std::optional<double> flowRate; ///< [m^3/s], per metre of depth [m^2/s] in 2-D
    std::optional<double> pressure; ///< at the plane [Pa], without the background pressure; of an inlet, the most there is
    bool developed = false;         ///< the velocity has the profile of developed flow; else it is the same everywhere
    Stream stream;                  ///< what comes in, through an outlet with `backflow` where the flow is inwards
    std::vector<Layer> layers;
    bool backflow = false;
    std::optional<double> markFrom; ///< what comes in from this time [s] on tells when it did
    Location where;

    /// Distance from the plane [m], > 0 in the scene.
    double distance(const Vector<3>& x) const { return dot(x - point, normal); }
    /// Whether the plane is open at a point of it, or at a point so far beside its extent [m].
    bool opensAt(const Vector<3>& x, int dimension, double beside = 0) const;
    /// Whether another opening is cut out of the plane.
    bool leavesOut(const Opening& part) const;
    bool brings(std::size_t phase) const;
    const Stream& streamAt(const Vector<3>& x, int dimension) const;
};

/// The time at which a marked particle came in; < 0 for all others.
struct EntryTime
{
    static constexpr FieldInfo info{"enteredAt", "s"};
    static constexpr double notMarked = -1;
    template<int dim> struct At
    {
        double enteredAt;
    };
};

/// Reads constant/openings, one dictionary an opening; none where there is no such file:
///
///     gate { type inlet; point (0 0 0); normal (1 0 0); flowRate 1e-9; profile developed; }
///     vent { type outlet; point (1 0 0); normal (-1 0 0); pressure 0; }
///     drip { type drip; points ((0.2 1 0) (0.6 1 0)); radius 0.05; normal (0 -1 0); flowRate 1e-9; phase water; }
///
/// Each point of a drip is an opening, drip1, drip2 ... Mistakes go to the case's Diagnostics. `absent`: what would come in with a model that the scene
/// does not have, and what to say to it.
std::vector<Opening> readOpenings(const Case&, const Geometry&, const Coefficients&, const State&,
                                  const std::map<std::string, std::string>& absent = {});
/// Reads the planes alone: what models make of the other entries is left unread.
std::vector<Opening> readOpeningPlanes(const Case&, const Geometry&, const Coefficients&);
EntryList openingEntries();

}
