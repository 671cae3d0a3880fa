/// Report of a bed to the user, and its files.
#pragma once
#include "solids/Bed.hpp"

namespace sph
{

/// Space between two cylinders about the axis of a cylindrical container.
struct RadialShell
{
    double radius = 0;   ///< of its middle [m]
    double porosity = 1; ///< mean
    double error = 0;    ///< standard error of that; 0 of spheres, whose porosity is computed
};

/// A grain among the others.
struct GrainMeasures
{
    int contacts = 0;
    std::optional<double>
        gap; ///< of a sphere to the nearest other sphere [m], negative where they overlap; none where none is within a mean size
    std::optional<double> tilt; ///< of the longest axis of a mesh, from upright: 0 to 90 [degrees]
};

struct BedMeasures
{
    double height = 0;                              ///< 90 % of the solids end below; of randomClose that of the container [m]
    std::vector<double> layerMiddle, layerPorosity; ///< over the whole cross-section, from the bottom up
    double porosity = 1;                    ///< of the middle half of the height, over the whole cross-section, exact but for overlaps
    std::optional<double> corePorosity;     ///< the same a mean size away from the sides, where there is such a place
    double coreError = 0;                   ///< standard error of that
    double shrunk = 0;                      ///< share of its size that a solid had more when it was poured, the mean of all
    double coordination = 0;                ///< mean number of solids that one touches
    std::optional<double> coreCoordination; ///< the same of those whose centre is in the middle half and 1.5 mean sizes away from the sides
    /// Order of the longest axes of meshes, mean of (3 cos^2 tilt - 1)/2: 1 upright, 0 at random, -1/2 lying; and its standard error at random, 1/sqrt(5 n).
    std::optional<double> orientation;
    double orientationError = 0;
    std::vector<RadialShell> shells; ///< of a cylinder, from the axis to the wall
    std::vector<GrainMeasures> grains;
};

BedMeasures measure(const SolidsPlan&, const Bed&);

/// Porosity between heights in shells a twentieth of a mean size thick (beds of meshes: an eighth), of a cylindrical container.
///
/// A sphere of radius R, its centre at the distance c from the axis, has on the cylinder of radius r the area (Mueller 2012)
///
///     A(r) = r int h dtheta,   h = 2 (R^2 - c^2 - r^2 + 2 c r cos theta)^1/2     over the angles where the root is real, h cut off at the heights,
///
/// and the porosity there is 1 - sum A/(2 pi r (high - low)); its mean over a shell is by Gauss's rule. The integrals are exact to some 2e-4 of the porosity (test
/// Bed.RadialPorosity). Of beds with meshes: the share of random points that lie in no solid.
std::vector<RadialShell> radialPorosity(const SolidContainer&, const Bed&, double low, double high);

/// Contacts, gaps and tilts of the grains, and the means of those whose centres lie between the heights.
void measureGrains(const SolidContainer&, const Bed&, double low, double high, BedMeasures&);

std::string report(const SolidsPlan&, const Bed&, const BedMeasures&);

/// constant/solids; constant/solidSpheres where there are spheres, constant/triSurface/solids.obj where there are meshes; postProcessing/solids/*.csv
/// (entries/bedTables.hpp). A file that this bed has not is removed, so that none of an earlier one is taken for it. Returns the names.
std::vector<std::string> writeBed(const Case&, const SolidsPlan&, const Bed&, const BedMeasures&);

}
