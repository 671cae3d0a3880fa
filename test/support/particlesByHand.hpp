/// Particles made by hand.
#pragma once
#include "fields/FieldStore.hpp"
#include <random>
#include <vector>

namespace sph::test
{

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
