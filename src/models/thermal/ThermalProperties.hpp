/// Numbers of heat conduction and buoyancy, and the tags of the fields.
#pragma once
#include "fields/fieldTags.hpp"
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

// clang-format off
struct Temperature     { static constexpr FieldInfo info{"T", "K", Image::ruled, nullptr, "T"};                     template<int dim, class Real = double> struct At { Real T; }; };
struct TemperatureRate { static constexpr FieldInfo info{"dTdt", "K/s"};                                            template<int dim, class Real = double> struct At { Real dTdt; }; };
/// 0 in the fluid and behind walls that nothing passes, 1 + wall behind one of given temperature or heat flux (the first of those that a ghost was mirrored in),
/// and 1 + the number of walls where the ghost has no part in conduction.
struct HeatedWall      { static constexpr FieldInfo info{"heatedWall", "1", Image::ruled, nullptr, "heatedWall"};   template<int dim, class Real = double> struct At { Real heatedWall; }; };
struct WallHeat        { static constexpr FieldInfo info{"heat", "J/kg"};                                           template<int dim, class Real = double> struct At { Real heat; }; };
struct WallHeatRate    { static constexpr FieldInfo info{"dheatdt", "W/kg"};                                        template<int dim, class Real = double> struct At { Real dheatdt; }; };
// clang-format on

/// A wall of given temperature or given heat flux into the fluid; nothing passes one with neither.
struct HeatAtWall
{
    std::string name;
    std::optional<double> T, q; ///< [K], [W/m^2]

    bool passes() const { return T || q; }
    /// Temperature of the wall at the foot of a particle of temperature T_i, at the distance d [m], in a medium of conductivity kappa [W/(m K)]:
    /// T_w, T_i + q d/kappa, or T_i.
    double atFoot(double T_i, double d, double kappa) const { return T ? *T : q ? T_i + *q * d / kappa : T_i; }
    /// The field of the heat that particles have received from this wall [J/kg], and that of its rate.
    std::string heatName() const { return std::string(WallHeat::info.name) + "_" + name; }
    std::string rateName() const { return "d" + heatName() + "dt"; }
};

struct ThermalProperties
{
    std::vector<double> kappa;        ///< conductivity of each phase [W/(m K)]
    std::vector<double> Cp;           ///< specific heat capacity of each phase [J/(kg K)]
    std::vector<double> beta;         ///< thermal expansion coefficient of each phase [1/K]
    double T0 = 0;                    ///< temperature at which the density is that at rest [K]
    std::vector<std::string> initial; ///< of each phase, an expression of the position
    std::vector<HeatAtWall> walls;    ///< all walls, in the order of the geometry
};

inline bool isBuoyant(const ThermalProperties& thermal)
{
    return std::ranges::any_of(thermal.beta, [](double beta) { return beta != 0; });
}

}
