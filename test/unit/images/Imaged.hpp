/// Particles between walls made by hand, with their images.
#pragma once
#include "scenes.hpp"
#include <algorithm>
#include <utility>

namespace sph::test
{

template<int dim> struct Imaged
{
    Geometry geometry;
    FieldStore<dim> store;
    Images<dim> images;

    Imaged(Geometry g, double reach, const std::vector<Vector<dim>>& points, double spacing = 0.1)
        : geometry((repeatPeriodically(g, reach), std::move(g))), images(geometry, reach, spacing)
    {
        images.rules().set(Velocity{}, std::make_unique<Reversed<dim>>());
        store.allocate(ImageWeight{});
        setPositions(store, points);
        images.build(store, points.size());
    }
    std::vector<Vector<dim>> places()
    {
        std::vector<Vector<dim>> p;
        for (std::size_t k = 0; k < images.count(); ++k) p.push_back(positionOf(store, images.owned() + k));
        return p;
    }
    int countAt(Vector<dim> x, double tolerance = 1e-12)
    {
        const auto all = places();
        return int(std::count_if(all.begin(), all.end(), [&](const auto& p) { return mag(p - x) < tolerance; }));
    }
};

inline Geometry cornerOfBox(int dimension)
{
    Geometry g = domain(dimension, {1, 1, 1});
    addWall(g, Plane({0, 0, 0}, {1, 0, 0}));
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    if (dimension == 3) addWall(g, Plane({0, 0, 0}, {0, 0, 1}));
    return g;
}

}
