/// Report of a bed to the user, and its files.
#pragma once
#include "solids/Bed.hpp"

namespace sph
{

struct BedMeasures
{
    double height = 0;                              ///< 90 % of the solids end below; of randomClose that of the container [m]
    std::vector<double> layerMiddle, layerPorosity; ///< over the whole cross-section, from the bottom up
    double porosity = 1;                ///< of the middle half of the height, over the whole cross-section, exact but for overlaps
    std::optional<double> corePorosity; ///< the same a mean size away from the sides, where there is such a place
    double coreError = 0;               ///< standard error of that
    double coordination = 0;            ///< mean number of solids that one touches
};

BedMeasures measure(const SolidsPlan&, const Bed&);

std::string report(const SolidsPlan&, const Bed&, const BedMeasures&);

/// constant/solids; constant/solidSpheres where there are spheres, constant/triSurface/solids.obj where there are meshes (and none of an earlier bed
/// else); postProcessing/solids/{porosity,contacts,bed}.csv. Returns the names.
std::vector<std::string> writeBed(const Case&, const SolidsPlan&, const Bed&, const BedMeasures&);

}
