#include "surfaces/entries/surfaceTable.hpp"

namespace sph
{

TableInfo surfaceTable(int dimension)
{
    const bool flat = dimension == 2;
    const std::string area = flat ? "m" : "m^2", volume = flat ? "m^2" : "m^3";
    return {"reconstructSurface",
            "surfaces.dat",
            "the surface of each phase, whose name is part of the column's where there are several; in 2-D length [m] and area [m^2]",
            {{"<phase>.area", area, "area of the surface"},
             {"<phase>.volume", volume, "volume that the surface encloses"},
             {"<phase>.particleVolume", volume, "volume of the particles"},
             {"<phase>.difference%", "%", "of the two, over that of the particles"},
             {"<phase>.pieces", "-", "connected pieces of the surface"}}};
}

}
