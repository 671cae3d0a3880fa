#include "ImplicitViscosity.hpp"
#include "DivergedError.hpp"
#include "overBlocks.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// What the response reads besides the change itself: the evaluation has left it there, images and all.
std::set<std::string> evaluated(const Settings& settings, bool normalised)
{
    std::set<std::string> fields{Position::info.name, Mass::info.name, Volume::info.name};
    if (settings.variableViscosity()) fields.insert(DynamicViscosity::info.name);
    if (normalised) fields.insert(GradientScale::info.name);
    return fields;
}
std::set<std::string> with(std::set<std::string> fields, const FieldInfo& another)
{
    fields.insert(another.name);
    return fields;
}

struct Sums
{
    double rz = 0, rr = 0, vv = 0;   ///< r.z, r.r and v_1.v_1, weighed by mass
    Sums& operator+=(const Sums& b) { rz += b.rz; rr += b.rr; vv += b.vv; return *this; }
};

/// f(i) over all particles.
template<class F> Sums sumOver(std::size_t n, const F& f)
{
    Sums total;
    for (const auto& part : overBlocks(n, [&](std::size_t begin, std::size_t end)
                                       {
                                           Sums sums;
                                           for (std::size_t i = begin; i < end; ++i) sums += f(i);
                                           return sums;
                                       }))
        total += part;
    return total;
}
}

template<int dim>
ImplicitViscosity<dim>::ImplicitViscosity(const Settings& settings, const Catalogue<dim>& catalogue, FieldStore<dim>& store)
    : settings_(settings.implicitSolve),
      plan_(catalogue, {settings.implicitSolve.response}, with(evaluated(settings, store.has(GradientScale{})), VelocityChange::info),
            evaluated(settings, store.has(GradientScale{})))
{
    plan_.allocate(store);
}

template<int dim>
void ImplicitViscosity<dim>::solve(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists, const Kernel<dim>& kernel,
                                   double deltaT, std::span<const int> held)
{
    conjugateGradients(store, images, lists, kernel, 1, deltaT, held);
    const auto a = store.pointers(Acceleration{});
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < store.owned(); ++i)
        for (int c = 0; c < dim; ++c) a[c][i] = (change_[c][i] + residual_[c][i])/deltaT;
}

template<int dim>
void ImplicitViscosity<dim>::solveSteady(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists, const Kernel<dim>& kernel)
{
    conjugateGradients(store, images, lists, kernel, 0, 1/settings_.theta);
    const auto v = store.pointers(Velocity{});
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < store.owned(); ++i)
        for (int c = 0; c < dim; ++c) v[c][i] += change_[c][i];
}

/// (inertia - theta dt L) dv = dt a
template<int dim>
void ImplicitViscosity<dim>::conjugateGradients(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists,
                                                const Kernel<dim>& kernel, double inertia, double deltaT, std::span<const int> held)
{
    const std::size_t n = store.owned();
    const double *m = store.component("m", 0), *lambda = store.component(ViscousRate::info.name, 0);
    const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{}), p = store.pointers(VelocityChange{}),
               Lp = store.pointers(ViscousResponse{});
    const double implicit = settings_.theta*deltaT;
    std::array<double*, dim> dv, r;
    for (int c = 0; c < dim; ++c)
    {
        change_[c].resize(n);
        residual_[c].resize(n);
        dv[c] = change_[c].data();
        r[c] = residual_[c].data();
    }
    const auto sums = [&](std::size_t i)
    {
        double r2 = 0, v2 = 0;
        for (int c = 0; c < dim; ++c)
        {
            r2 += sqr(r[c][i]);
            v2 += sqr(v[c][i] + dv[c][i]);
        }
        const double diagonal = inertia + implicit*lambda[i];
        return Sums{m[i]*r2/diagonal, m[i]*r2/(inertia > 0 ? 1 : sqr(diagonal)), m[i]*v2};
    };
    Sums now = sumOver(n, [&](std::size_t i)
    {
        for (int c = 0; c < dim; ++c)
        {
            dv[c][i] = 0;
            r[c][i] = deltaT*a[c][i];
            p[c][i] = r[c][i]/(inertia + implicit*lambda[i]);
        }
        return sums(i);
    });
    for (iterations_ = 0; now.rr > sqr(settings_.tolerance)*now.vv; ++iterations_)
    {
        if (iterations_ == settings_.maxIter)
            throw DivergedError(fmt::format("the implicit viscosity has not converged in {} iterations: the residual is {:.3g} of the velocity, the "
                                            "tolerance {:.3g}. Choose a smaller step, or a larger `maxIter` or `tolerance` in `integration`",
                                            iterations_, std::sqrt(now.rr/now.vv), settings_.tolerance));
        plan_.evaluate(store, images, lists, kernel, Plan<dim>::Candidates::kept);
        // What is held has a residual of 0 and keeps it: the others' equations remain, with a symmetric matrix.
        for (double* component : Lp)
            for (const int i : held) component[i] = 0;
        const double pAp = sumOver(n, [&](std::size_t i)
        {
            double sum = 0;
            for (int c = 0; c < dim; ++c) sum += p[c][i]*(inertia*p[c][i] - implicit*Lp[c][i]);
            return Sums{m[i]*sum};
        }).rz;
        const double alpha = now.rz/pAp;
        const Sums next = sumOver(n, [&](std::size_t i)
        {
            for (int c = 0; c < dim; ++c)
            {
                dv[c][i] += alpha*p[c][i];
                r[c][i] -= alpha*(inertia*p[c][i] - implicit*Lp[c][i]);
            }
            return sums(i);
        });
        const double beta = next.rz/now.rz;
        now = next;
        #pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < n; ++i)
            for (int c = 0; c < dim; ++c) p[c][i] = r[c][i]/(inertia + implicit*lambda[i]) + beta*p[c][i];
    }
}

template<int dim> std::size_t ImplicitViscosity<dim>::bytes() const
{
    std::size_t n = plan_.bytes();
    for (const auto* arrays : {&change_, &residual_})
        for (const auto& array : *arrays) n += array.capacity()*sizeof(double);
    return n;
}

template class ImplicitViscosity<2>;
template class ImplicitViscosity<3>;

}
