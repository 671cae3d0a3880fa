/// Fields of the free surface of a liquid whose gas is left out (models/gas/CompletedDensity.hpp).
#pragma once
#include "fields/fieldTags.hpp"
#include <cmath>

namespace sph
{

// clang-format off
struct SlopeSum            { static constexpr FieldInfo info{"slopeSum", "1/m^4", Image::mirrored};      template<int dim, class Real = double> struct At { Vector<dim, Real> g; }; };
struct SurfaceShare        { static constexpr FieldInfo info{"surfaceShare", "1"};                      template<int dim, class Real = double> struct At { Real t; }; };
struct SurfaceLack         { static constexpr FieldInfo info{"surfaceLack", "1"};                       template<int dim, class Real = double> struct At { Real lack; }; };
struct SurfaceDepth        { static constexpr FieldInfo info{"surfaceDepth", "m"};                      template<int dim, class Real = double> struct At { Real z; }; };
struct LiquidNormal        { static constexpr FieldInfo info{"liquidNormal", "1", Image::mirrored};     template<int dim, class Real = double> struct At { Vector<dim, Real> n_l; }; };
struct TensionAcceleration { static constexpr FieldInfo info{"dUdtByTension", "m/s^2", Image::mirrored}; template<int dim, class Real = double> struct At { Vector<dim, Real> a_t; }; };
/// The number of a particle, which its images have too; how many ghosts of walls a particle sees.
struct ParticleNumber      { static constexpr FieldInfo info{"number", "1"};                            template<int dim, class Real = double> struct At { Real number; }; };
struct GhostsSeen          { static constexpr FieldInfo info{"ghostsSeen", "1"};                        template<int dim, class Real = double> struct At { Real ghosts; }; };
// clang-format on

/// Share by which what acts in the interior of the liquid alone acts on a particle: 1 far from the surface, 0 from t = t_s on.
///
///   e_i = max(0, 1 - t_i/t_s),    t_s = 0.1
///
/// t_i [-] is the particle's share of the surface (SurfaceShare, models/gas/CompletedDensity.hpp). t_s by columns that hang between plates (models/gas/README.md).
struct InteriorShare
{
    static constexpr double upTo = 0.1; ///< t_s
    static double of(double t) { return std::fmax(0.0, 1 - t / upTo); }
};

}
