#include "solids/entries/bedTables.hpp"

namespace sph
{

TableInfo bedTable()
{
    return {
        "solids/bed",
        "bed.csv",
        "a bed of solids in one row; cells of what it has not are empty",
        {{"solids", "-", "number of them"},
         {"meanSize", "m", "mean of their diameters, of meshes those of the sphere of equal volume"},
         {"height", "m", "below which 90 % of the solids end; of randomClose that of the container"},
         {"porosity", "-", "of the middle half of the height over the whole cross-section, exact but for overlaps"},
         {"corePorosity", "-", "the same a mean size away from the sides, by random points"},
         {"contacts", "-", "pairs of solids nearer than 0.5 % of the mean size, of randomClose 0.1 %"},
         {"coordination", "-", "mean number of contacts of a solid"},
         {"largestOverlap", "-",
          "largest depth by which two solids, or one and the container, reach into one another over the mean size, before they were shrunk"},
         {"shrunk", "-", "share by which solids were then made smaller, the mean of all"},
         {"kineticEnergy", "-", "mean of a solid at the end over m g d"},
         {"corePorosityError", "-", "standard error of corePorosity"},
         {"coreCoordination", "-",
          "mean number of contacts of the solids in the middle half of the height and 1.5 mean sizes away from the sides"},
         {"orientation", "-",
          "of meshes, mean of (3 cos^2 a - 1)/2, a the angle of the longest axis from upright: 1 upright, 0 at random, -1/2 lying"},
         {"orientationError", "-", "standard error of orientation where axes are at random"},
         {"taps", "-", "of the container, until the bed was as dense as it was to be"}}};
}

TableInfo heightTable()
{
    return {"solids/porosity",
            "porosity.csv",
            "porosity of layers, an eighth of a mean size high, over the whole cross-section, exact but for overlaps",
            {{"height", "m", "of the middle of the layer above the bottom"}, {"porosity", "-", "of the layer"}}};
}

TableInfo radialTable()
{
    return {"solids/radialPorosity",
            "radialPorosity.csv",
            "porosity of shells about the axis of a cylinder, over the middle half of the height; of a bed in a cylinder",
            {{"radius", "m", "of the middle of the shell"},
             {"distance", "-", "from there to the wall over the mean size"},
             {"porosity", "-", "of the shell: of spheres an integral, with meshes the share of random points"},
             {"error", "-", "standard error of porosity; 0 of spheres"}}};
}

TableInfo sizesTable()
{
    return {"solids/sizes",
            "sizes.csv",
            "grading curve of a bed of several sizes; sizes as they were drawn, before they were scaled or made smaller",
            {{"size", "m", "diameter, of a mesh that of the sphere of equal volume"},
             {"passing", "-", "share of the bed's mass that is no larger"},
             {"asked", "-", "the same of the distribution"}}};
}

TableInfo grainsTable()
{
    return {"solids/grains",
            "grains.csv",
            "a row a solid",
            {{"x", "m", "centre"},
             {"y", "m", "centre"},
             {"z", "m", "centre"},
             {"shape", "-", "number in the list shapes, from 0"},
             {"size", "m", "diameter, of a mesh that of the sphere of equal volume"},
             {"contacts", "-", "solids that it touches"},
             {"gap", "m",
              "of a sphere to the nearest other one, negative where they overlap; empty where none is within a mean size, and of meshes"},
             {"tilt", "degrees", "of the longest axis of a mesh from upright, 0 to 90; empty of spheres"}}};
}

TableInfo contactsTable()
{
    return {"solids/contacts",
            "contacts.csv",
            "a row a pair of solids that touch",
            {{"first", "-", "number of a solid, its row in grains.csv, from 0"},
             {"second", "-", "of the other"},
             {"gap", "m", "between them, negative where they overlap, before they were shrunk"}}};
}

}
