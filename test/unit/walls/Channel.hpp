/// Two plane walls nearer to each other than two supports, with points of two phases between them.
#pragma once
#include "geometry/Plane.hpp"
#include "images/Images.hpp"
#include "models/tension/Tensions.hpp"
#include "plan/Coefficients.hpp"
#include "plan/terms.hpp"
#include <algorithm>

namespace sph
{

constexpr double H = 0.37; ///< support; not 1: a missing power of H shows

/// A channel 0 < y < 0.5 whose walls are nearer to each other than two supports; two phases.
template<int dim> struct Channel
{
    Geometry geometry;
    Coefficients coefficients;
    FieldStore<dim> store;
    Images<dim> images;
    static constexpr double height = 0.5;

    /// The named field starts with what was `left` by others.
    Channel(const std::vector<Vector<dim>>& points, auto result, double left) : geometry(between()), images(geometry, 1.1 * H, 0.1)
    {
        coefficients.phases = {"water", "air"};
        coefficients.set(Tensions{{}, {0.01, -0.02, -0.03, 0.05}}); // walls x phases
        store.allocateState(Position{});
        store.allocateState(Phase{});
        store.allocate(result);
        if (!geometry.patches.empty()) store.allocate(ImageWeight{});
        store.resize(points.size() + 1);
        const auto x = store.pointers(Position{});
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            sph::store(points[i], [&](int c, double q) { x[c][i] = q; });
            store.component("phase", 0)[i] = double(i % 2);
        }
        images.build(store, points.size());
        for (double* component : store.pointers(result)) std::fill_n(component, points.size(), left);
    }
    template<class F> auto at(F, std::size_t i)
    {
        const auto component = store.pointers(F{});
        decltype(unwrap(At<F, dim>{})) q;
        fetch(q, [&](int c) { return component[c][i]; });
        return q;
    }

private:
    static Geometry between()
    {
        Geometry g;
        g.dimension = dim;
        g.high = {1, height, dim == 3 ? 1.0 : 0};
        g.periodic = {true, false, dim == 3};
        g.walls.resize(2);
        g.originals = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0},
                       {std::make_shared<Plane>(Vector<3>{0, height, 0}, Vector<3>{0, -1, 0}), 1}};
        repeatPeriodically(g, 1.1 * H);
        return g;
    }
};

/// What the plan makes of a wall law: over all particles, onto what others have added, or in its place.
template<class Law, int dim> void evaluateAtWalls(const Law& law, const Images<dim>& images, FieldStore<dim>& store, bool adds)
{
    Bound<Law, dim>(law, Binding<dim>{store, {}, {}, adds}).atWalls(images.nearWalls(), 0, images.owned());
}

/// Two points at each height, the first near a periodic face: shifted copies of a ghost are no further walls.
template<int dim> std::vector<Vector<dim>> atHeights(const std::vector<double>& heights)
{
    std::vector<Vector<dim>> points;
    for (double y : heights)
        for (double x : {0.05, 0.5})
        {
            Vector<dim> p{};
            p.x = x;
            p.y = y;
            points.push_back(p);
        }
    return points;
}

}
