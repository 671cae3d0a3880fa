/// Points and walls made by hand.
#pragma once
#include "Cylinder.hpp"
#include "FieldStore.hpp"
#include "Geometry.hpp"
#include "Images.hpp"
#include "Plane.hpp"
#include "SolidBox.hpp"
#include "Sphere.hpp"
#include <random>
#include <vector>

namespace sph::test
{

inline Geometry domain(int dimension, Vector<3> high, std::array<bool, 3> periodic = {})
{
    Geometry g;
    g.dimension = dimension;
    g.high = high;
    g.periodic = periodic;
    return g;
}

/// Each shape a wall of its own. repeatPeriodically is the caller's last word.
inline void addWall(Geometry& g, const Shape& shape)
{
    g.originals.push_back({std::shared_ptr<const Shape>(shape.shifted({})), int(g.walls.size())});
    WallProperties wall;
    wall.name = "wall" + std::to_string(g.walls.size());
    g.walls.push_back(wall);
}

/// v_g = -v, so that a test needs no wall model.
template<int dim> class Reversed : public GhostVelocity<dim>
{
public:
    Vector<dim> operator()(Vector<dim> v, std::size_t, const Reflection<dim>&, bool) const override { return -1.0 * v; }
    Vector<dim> change(Vector<dim> dv, const Reflection<dim>&) const override { return -1.0 * dv; }
};

template<int dim> void setPositions(FieldStore<dim>& store, const std::vector<Vector<dim>>& points)
{
    store.allocateState(Position{});
    store.resize(points.size() + 1);
    const auto x = store.pointers(Position{});
    for (std::size_t i = 0; i < points.size(); ++i) sph::store(points[i], [&](int c, double q) { x[c][i] = q; });
}

template<int dim> Vector<dim> positionOf(FieldStore<dim>& store, std::size_t i)
{
    const auto x = store.pointers(Position{});
    Vector<dim> p;
    fetch(p, [&](int c) { return x[c][i]; });
    return p;
}

template<int dim> std::array<const double*, dim> positions(FieldStore<dim>& store)
{
    std::array<const double*, dim> p;
    int c = 0;
    for (const double* q : store.pointers(Position{})) p[c++] = q;
    return p;
}

template<int dim> std::vector<Vector<dim>> randomPoints(std::size_t n, Vector<dim> high, unsigned seed = 1)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vector<dim>> points(n);
    for (auto& p : points)
    {
        Vector<dim> q;
        fetch(q, [&](int) { return unit(random); });
        if constexpr (dim == 2) p = {q.x * high.x, q.y * high.y};
        else p = {q.x * high.x, q.y * high.y, q.z * high.z};
    }
    return points;
}

}
