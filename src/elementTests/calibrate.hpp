/// Constants of Wu & Bauer's law from one drained triaxial compression.
///
/// Four figures give four constants. With axial compression at the rate 1 and lateral extension a = (1 - slope)/2, slope = d(volume strain)/d(axial
/// strain), compression positive, eq. (17) says
///
///   at the start, isotropic:  E_0 = -3 c1 p (1 + a)                                     axial stress
///                             c2 (2 a - 1) + c3 |D| = -9 c1 a                           lateral stress is held
///   at the peak, R = 1 + q/p: c1 a + c2 (r:D) r_1 + (c3 r_1^2 + c4 r*_1^2) |D| = 0       lateral stress is held
///                            -c1 + c2 (r:D) r_3 + (c3 r_3^2 + c4 r*_3^2) |D| = 0         axial stress does not change
///
/// with r_1 = 1/(2 + R), r_3 = R/(2 + R), r* = r - 1/3, D = diag(a, a, -1): linear in c1 ... c4 (Wu & Bauer 1994, section on identification). Verified by
/// test/unit/elementTests, which calibrates to a computed test and finds its constants.
#pragma once
#include "base/CaseError.hpp"
#include "soilLaws/WuBauer.hpp"
#include <vector>

namespace sph
{

/// Compression positive, as measured.
struct TriaxialPoint
{
    double axialStrain, q, volumeStrain; ///< [-], [Pa], [-]
};

struct TriaxialFigures
{
    double pressure = 0;           ///< lateral [Pa]
    double initialStiffness = 0;   ///< dq/d(axial strain) at the start [Pa]
    double initialVolumeSlope = 0, ///< d(volume strain)/d(axial strain) at the start: 1 - 2 nu
        peakVolumeSlope = 0;       ///< and at the peak, negative where the soil dilates
    double peak = 0;               ///< q [Pa]
};

/// Either the figures alone, or points of which they are taken.
struct Measurement
{
    TriaxialFigures figures;
    std::vector<TriaxialPoint> points; ///< up to the peak; those behind it are left out
    Location where;
};

struct Calibration
{
    WuBauer law;
    /// Root mean square of what the points are off, of q over its peak and of the volume strain over its largest; none without points.
    std::optional<double> misfitStress, misfitVolume;
};

/// Throws CaseError with what is impossible where no constants, or none that a soil can have, give what was measured.
Calibration calibrate(const Measurement&);

/// Figures of a curve of at least four points: secants of the first ones extrapolated to the start, the last one as the peak.
TriaxialFigures figuresOf(double pressure, const std::vector<TriaxialPoint>&);

}
