/// Scenes made by hand, so that packing is tested apart from the reading of constant/geometry.
#pragma once
#include "geometry/Cylinder.hpp"
#include "geometry/Geometry.hpp"
#include "geometry/Plane.hpp"
#include "geometry/Sphere.hpp"

namespace sph
{

inline Geometry emptyBox(int dimension, Vector<3> high, std::array<bool, 3> periodic)
{
    Geometry g;
    g.dimension = dimension;
    g.high = high;
    g.periodic = periodic;
    g.walls.resize(1);
    return g;
}

inline void add(Geometry& g, const Shape& shape) { g.originals.push_back({std::shared_ptr<Shape>(shape.shifted({})), 0}); }

/// A ball in a periodic cube of edge 1.
inline Geometry cubicBed(double radius, double reach)
{
    Geometry g = emptyBox(3, {1, 1, 1}, {true, true, true});
    add(g, Sphere({0.5, 0.5, 0.5}, radius, FluidSide::outside));
    repeatPeriodically(g, reach);
    return g;
}

/// A channel between planes at y = 0 and y = height, periodic along x (and z).
inline Geometry channel(int dimension, double length, double height, double reach)
{
    Geometry g = emptyBox(dimension, {length, height, length}, {true, false, dimension == 3});
    add(g, Plane({0, 0, 0}, {0, 1, 0}));
    add(g, Plane({0, height, 0}, {0, -1, 0}));
    repeatPeriodically(g, reach);
    return g;
}

}
