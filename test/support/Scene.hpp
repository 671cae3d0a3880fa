/// Particles between walls with everything that an evaluation needs, and the plain sums that it is compared with.
#pragma once
#include "models/density/DensityDiffusion.hpp"
#include "models/shifting/TransportVelocity.hpp"
#include "models/tension/Tensions.hpp"
#include "models/tension/WallTension.hpp"
#include "models/viscosity/ArtificialViscosity.hpp"
#include "plan/Plan.hpp"
#include "scenes.hpp"
#include "solver/models.hpp"
#include <gtest/gtest.h>
#include <optional>

namespace sph::test
{

/// S += -p I, for what a stress divergence makes of a pressure.
struct PressureAsStress
{
    static constexpr auto name = "pressureAsStress";
    using Adds = Stress;
    using ReadsOwn = Fields<Pressure, Position>;
    auto operator()(const auto& i) const { return -i.p * identity(i.x); }
};

template<int dim> const Catalogue<dim>& wholeCatalogue()
{
    static const Catalogue<dim> all = []
    {
        Catalogue<dim> c = allTerms<dim>();
        for (const auto& term : catalogue<dim, PressureAsStress>()) c.push_back(term);
        return c;
    }();
    return all;
}

/// Numbers of three unlike phases; nothing is 1 that a factor could hide behind.
inline Coefficients threePhases(int dimension, double spacing, double support)
{
    Coefficients c;
    c.dimension = dimension;
    c.spacing = spacing;
    c.support = support * spacing;
    c.phases = {"oil", "water", "gas"};
    c.restDensity = {800, 1000, 1.2};
    c.viscosity = {0.3, 0.07, 0.002};
    c.soundSpeed = {12, 15, 40};
    const double n[]{7, 7, 1.4};
    for (std::size_t k = 0; k < 3; ++k) c.stateEquation.push_back(StateEquation::tait(c.restDensity[k], c.soundSpeed[k], n[k]));
    c.backgroundPressure = 37;
    c.set(Tensions{{0, 0.03, 0.02, 0.03, 0, 0.07, 0.02, 0.07, 0}, {0.01, -0.02, 0.015, -0.03, 0.005, 0.025}}); // two walls
    c.g = {0.3, -9.81, 0.7};
    c.bodyForce = {20, 5, -3};
    c.densityScale = 1.013;
    c.set(DiffusionNumber{0.1});
    c.set(ArtificialNumber{0.3 * 0.5 * c.support * 40 * c.restDensity[0]}); // 40 m/s: the largest sound speed
    c.set(TransportNumber{0.7});
    c.set(KernelMarginal::of("wendlandC2", dimension, c.support));
    return c;
}

inline Coefficients firstPhases(Coefficients c, int n)
{
    Coefficients few = c;
    for (auto* list : {&few.restDensity, &few.viscosity, &few.soundSpeed}) list->resize(std::size_t(n));
    few.stateEquation.resize(std::size_t(n));
    few.phases.resize(std::size_t(n));
    const auto& all = tensionsOf(c);
    Tensions tensions;
    for (int k = 0; k < n; ++k)
        for (int l = 0; l < n; ++l) tensions.between.push_back(all.between[std::size_t(3 * k + l)]);
    for (int wall = 0; wall < 2; ++wall)
        for (int k = 0; k < n; ++k) tensions.ofWalls.push_back(all.ofWalls[std::size_t(3 * wall + k)]);
    few.set(tensions);
    return few;
}

template<int dim> struct Scene
{
    Geometry geometry;
    Coefficients coefficients;
    Kernel<dim> kernel;
    FieldStore<dim> store;
    Images<dim> images;
    NeighbourLists<dim> lists;
    Catalogue<dim> catalogue = wholeCatalogue<dim>();
    std::optional<Plan<dim>> plan;
    std::size_t n = 0;
    std::vector<double> N; ///< of every particle and image, where the plain sums are to divide gradW by (N_i + N_j)/2

    /// A jittered lattice where the walls leave room. Phases in layers along y, with a wavy boundary.
    Scene(Geometry g, Coefficients numbers, const std::vector<std::string>& terms, bool integratedDensity = false, unsigned seed = 1,
          const Catalogue<dim>& more = {})
        : geometry((repeatPeriodically(g, 1.3 * numbers.support), std::move(g))),
          coefficients(std::move(numbers)),
          kernel("wendlandC2", coefficients.support),
          images(geometry, coefficients.support + 0.3 * coefficients.spacing, coefficients.spacing)
    {
        std::set<std::string> given{"positions", "U", "m", "phase", "mu", "ghostWall", "dU", "dUTransport", "phi", "dphi"};
        if (integratedDensity) given.insert("rho");
        catalogue.insert(catalogue.end(), more.begin(), more.end());
        plan.emplace(catalogue, terms, given);
        plan->allocate(store);
        store.allocateState(Position{});
        store.allocateState(Velocity{});
        store.allocateState(Mass{});
        store.allocateState(Phase{});
        store.allocateState(DynamicViscosity{});
        if (integratedDensity) store.allocateState(Density{});
        if (!geometry.patches.empty()) store.allocate(ImageWeight{});

        const auto points = lattice(seed);
        n = points.size();
        setPositions(store, points);
        std::mt19937_64 random(seed + 1);
        std::uniform_real_distribution<double> any(-1, 1);
        const int phases = int(coefficients.phases.size());
        for (std::size_t i = 0; i < n; ++i)
        {
            const double height = (points[i].y - geometry.low.y) / geometry.length(1) + 0.1 * std::sin(6 * points[i].x);
            const int k = std::clamp(int(height * phases), 0, phases - 1);
            for (int d = 0; d < dim; ++d) store.component("U", d)[i] = any(random);
            store.component("phase", 0)[i] = k;
            store.component("mu", 0)[i] = coefficients.viscosity[std::size_t(k)];
            const double rho = coefficients.restDensity[std::size_t(k)] * (1 + 0.05 * any(random));
            store.component("m", 0)[i] = rho * std::pow(coefficients.spacing, dim);
            if (integratedDensity) store.component("rho", 0)[i] = coefficients.restDensity[std::size_t(k)] * (1 + 0.03 * any(random));
        }
        if (store.has(VelocityChange{}))
            for (int d = 0; d < dim; ++d) std::copy_n(store.component("U", d), n, store.component("dU", d));
        if (store.has(TransportVelocity{}))
            for (int d = 0; d < dim; ++d) std::generate_n(store.component("dUTransport", d), n, [&] { return 0.1 * any(random); });
        images.rules().set(Velocity{}, std::make_unique<Reversed<dim>>());
        if (!geometry.layers.empty())
            images.setLayers({geometry, kernel, coefficients.support + 0.3 * coefficients.spacing, coefficients.spacing});
        images.build(store, n);
        lists.build(positions(store), n, images.nullParticle(), coefficients.support + 0.3 * coefficients.spacing);
        images.listLayers(lists);
        plan->bind(store, coefficients);
        plan->evaluate(store, images, lists, kernel);
    }

    template<class F> auto at(F, std::size_t i) { return at(F{}, F::info.name, i); }
    template<class F> auto at(F, const std::string& name, std::size_t i)
    {
        decltype(unwrap(At<F, dim>{})) q;
        auto& arrays = store.fields().find(name)->second.component;
        fetch(q, [&](int c) { return arrays[std::size_t(c)][i]; });
        return q;
    }
    template<class F> void refresh(F) { Images<dim>::template refresh<F>(images, store); }

private:
    std::vector<Vector<dim>> lattice(unsigned seed) const
    {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> any(-0.15, 0.15);
        std::vector<Vector<dim>> points;
        const double s = coefficients.spacing;
        const auto jittered = [&](double low, int k) { return low + (k + 0.5 + any(random)) * s; };
        const auto layers = [&](int c) { return int(std::lround(geometry.length(c) / s)); };
        for (int a = 0; a < layers(0); ++a)
            for (int b = 0; b < layers(1); ++b)
                for (int c = 0; c < (dim == 3 ? layers(2) : 1); ++c)
                {
                    const Vector<3> p{jittered(geometry.low.x, a), jittered(geometry.low.y, b), jittered(geometry.low.z, c)};
                    if (geometry.distance(dim == 3 ? p : Vector<3>{p.x, p.y, 0}) > 0.3 * s) points.push_back(in<dim>(p));
                }
        return points;
    }
};

/// Doubly periodic square and cube; channel between planes; box around a ball.
inline Geometry periodicBox(int dimension, double length = 1)
{
    return domain(dimension, {length, length, dimension == 3 ? length : 0}, {true, true, dimension == 3});
}
inline Geometry channel(int dimension, double length = 1)
{
    Geometry g = domain(dimension, {length, length, dimension == 3 ? length : 0}, {true, false, dimension == 3});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    addWall(g, Plane({0, length, 0}, {0, -1, 0}));
    return g;
}
inline Geometry aroundABall(int dimension, double radius)
{
    Geometry g = periodicBox(dimension);
    if (dimension == 3) addWall(g, Sphere({0.5, 0.5, 0.5}, radius, FluidSide::outside));
    else addWall(g, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, radius, FluidSide::outside));
    return g;
}

}
