/// A plan of terms that a test declares, on points of a lattice, all fields scalars of the test's own.
#pragma once
#include "plan/Catalogue.hpp"
#include "plan/Plan.hpp"
#include "scenes.hpp"
#include <gtest/gtest.h>
#include <sstream>

namespace sph::test
{

/// "a" evolves; b and c follow from it, d from c and z; e from z alone.
struct A
{
    static constexpr FieldInfo info{"a", "1"};
    template<int dim, class Real = double> struct At
    {
        Real a;
    };
};
struct B
{
    static constexpr FieldInfo info{"b", "1"};
    template<int dim, class Real = double> struct At
    {
        Real b;
    };
};
struct C
{
    static constexpr FieldInfo info{"c", "1"};
    template<int dim, class Real = double> struct At
    {
        Real c;
    };
};
struct D
{
    static constexpr FieldInfo info{"d", "1"};
    template<int dim, class Real = double> struct At
    {
        Real d;
    };
};
struct E
{
    static constexpr FieldInfo info{"e", "1"};
    template<int dim, class Real = double> struct At
    {
        Real e;
    };
};
struct Z
{
    static constexpr FieldInfo info{"z", "1"};
    template<int dim, class Real = double> struct At
    {
        Real z;
    };
};

/// b = 2 a
struct Twice
{
    static constexpr auto name = "twice";
    using Provides = B;
    using ReadsOwn = Fields<A>;
    double operator()(const auto& i) const { return 2 * i.a; }
};
/// c_i = sum_j b_j W_ij, itself included
struct Sum
{
    static constexpr auto name = "sum";
    using Provides = C;
    using Reads = Fields<B>;
    static constexpr bool readsKernel = true;
    double operator()(const auto& ij, const auto&, const auto& j) const { return j.b * ij.W; }
};
/// d = c + z
struct Total
{
    static constexpr auto name = "total";
    using Provides = D;
    using ReadsOwn = Fields<C, Z>;
    double operator()(const auto& i) const { return i.c + i.z; }
};
/// e_i = sum_j z_j W_ij
struct OtherSum
{
    static constexpr auto name = "otherSum";
    using Provides = E;
    using Reads = Fields<Z>;
    static constexpr bool readsKernel = true;
    double operator()(const auto& ij, const auto&, const auto& j) const { return j.z * ij.W; }
};

struct Toy
{
    static constexpr int dim = 2;
    Geometry geometry;
    Catalogue<dim> catalogue;
    Kernel<dim> kernel{"wendlandC2", 0.25};
    FieldStore<dim> store;
    Images<dim> images;
    NeighbourLists<dim> lists;
    Plan<dim> plan;
    Plan<dim>::Counts counts;
    std::size_t n = 0;

    /// `state`: tags of what evolves, filled with numbers of which no two are alike.
    template<class... State>
    Toy(Geometry g, const Catalogue<dim>& terms, const std::vector<Group>& groups, Fields<State...>, const Coefficients& coefficients = {},
        std::map<std::string, std::vector<FieldUse<dim>>> rules = {})
        : geometry((repeatPeriodically(g, 0.3), std::move(g))),
          catalogue(terms),
          images(geometry, 0.28, 0.1),
          plan(catalogue, groups, {State::info.name...}, std::move(rules))
    {
        plan.allocate(store);
        (store.allocateState(State{}), ...);
        std::vector<Vector<dim>> points;
        for (double x = geometry.low.x + 0.05; x < geometry.high.x; x += 0.1)
            for (double y = geometry.low.y + 0.05; y < geometry.high.y; y += 0.1) points.push_back({x, y});
        n = points.size();
        setPositions(store, points);
        double value = 1;
        for (const char* name : {State::info.name...})
            for (std::size_t i = 0; i < n; ++i) store.component(name, 0)[i] = value += 0.5;
        images.build(store, n);
        lists.build(positions(store), n, images.nullParticle(), 0.28);
        plan.bind(store, coefficients);
        plan.countInto(&counts);
    }
    void evaluate(const std::string& group, double deltaT = 0) { plan.evaluate(store, images, lists, kernel, plan.group(group), deltaT); }
    double* of(const std::string& field) { return store.component(field, 0); }
    /// sum_j f(j) W_ij over the neighbours of i and itself, images by their sources.
    double sum(std::size_t i, const auto& f) { return sum(i, f, kernel); }
    double sum(std::size_t i, const auto& f, const Kernel<dim>& W)
    {
        return over(i, W, [&](std::size_t j, double r) { return f(j) * W.W(r); });
    }
    /// sum_j f(j, r_ij) over those within the kernel's support.
    double over(std::size_t i, const Kernel<dim>& W, const auto& f)
    {
        double total = 0;
        for (std::size_t j = 0; j < n; ++j)
        {
            auto x = positionOf(store, i) - positionOf(store, j);
            for (auto [k, length] : {std::pair(&x.x, geometry.length(0)), {&x.y, geometry.length(1)}})
                *k -= std::round(*k / length) * length;
            if (mag(x) < W.support()) total += f(j, mag(x));
        }
        return total;
    }
    long ran(const std::string& operation) const
    {
        const auto found = counts.find(operation);
        return found == counts.end() ? 0 : found->second;
    }
};

}
