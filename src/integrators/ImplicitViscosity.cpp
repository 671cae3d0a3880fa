#include "ImplicitViscosity.hpp"
#include "DivergedError.hpp"
#include "reduce.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
struct Sums
{
    double rz = 0, rr = 0, vv = 0;   ///< r.z, r.r and v_1.v_1, weighed by mass
    Sums& operator+=(const Sums& b) { rz += b.rz; rr += b.rr; vv += b.vv; return *this; }
};

/// Of the speed along walls; the relaxed packings of pipes reach 0.12 at 9 particles across and 0.04 at 19
/// (tutorials/powderMoulding/circularPipe), a lattice jittered by a tenth of a spacing 0.8.
constexpr double mostThroughWalls = 0.5;

/// Largest speed through the walls over the largest along them, of particles within a spacing of one. In a steady flow no fluid goes through walls;
/// where particles stay where they are, no pressure builds up that would see to it.
template<int dim> double shareThroughWalls(const Particles<dim>& particles)
{
    const auto x = particles.store().pointers(Position{}), v = particles.store().pointers(Velocity{});
    const auto& c = particles.coefficients();
    struct Speeds
    {
        double through = 0, along = 0;
    };
    const Larger larger;
    const auto largest = reduce(particles.size(), Speeds{0, 1e-9*c.soundSpeed[0]}, [&](std::size_t i) // round-off of a fluid at rest
    {
        Vector<dim> x_i, v_i;
        fetch(x_i, [&](int k) { return x[k][i]; });
        fetch(v_i, [&](int k) { return v[k][i]; });
        Speeds speeds;
        particles.images().forEachWallNear(x_i, [&](const Foot& foot, const Patch& patch)
        {
            if (foot.distance > c.spacing) return;
            const auto relative = in3D(v_i) - particles.geometry().wallVelocity(patch.wall, in3D(x_i) - foot.distance*foot.normal);
            const double normal = dot(relative, foot.normal);
            larger(speeds.through, std::fabs(normal));
            larger(speeds.along, mag(relative - normal*foot.normal));
        });
        return speeds;
    }, [&](Speeds& total, const Speeds& speeds)
    {
        larger(total.through, speeds.through);
        larger(total.along, speeds.along);
    });
    return largest.through/largest.along;
}
}

template<int dim> std::vector<Stage<dim>> ImplicitViscosity<dim>::stages(Place place)
{
    if (place != Place::solve) return {};
    return {{"solve", "(1 - theta dt L) dv = dt a, conjugate gradients", [this](Particles<dim>& p, const Substep& s)
             {
                 if (p.settings().integration.moves) solve(p, s.deltaT);
                 else solveSteady(p);
             }, {ofSolver}}};
}

template<int dim> std::string ImplicitViscosity<dim>::note() const { return iterations_ > 0 ? fmt::format("  viscosity {} iterations", iterations_) : ""; }

template<int dim> void ImplicitViscosity<dim>::solve(Particles<dim>& particles, double deltaT)
{
    conjugateGradients(particles, 1, deltaT);
    const auto a = particles.store().pointers(Acceleration{});
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (int c = 0; c < dim; ++c) a[c][i] = (change_[c][i] + residual_[c][i])/deltaT;
}

template<int dim> void ImplicitViscosity<dim>::solveSteady(Particles<dim>& particles)
{
    conjugateGradients(particles, 0, 1/particles.settings().integration.theta);
    const auto v = particles.store().pointers(Velocity{});
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (int c = 0; c < dim; ++c) v[c][i] += change_[c][i];
    if (const double share = shareThroughWalls(particles); share > mostThroughWalls)
        throw CaseError({"system/sphSchemes", 0},
                        fmt::format("scheme quasiSteady leaves particles where they are, and the flow beside the walls goes into them, "
                                    "with {:.2g} of its speed along them: it is driven by particles that lie unevenly, or by a force that "
                                    "only pressure could balance. Start from an even lattice, with a force along the walls, or take "
                                    "semiImplicit", share));
}

/// (inertia - theta dt L) dv = dt a
template<int dim> void ImplicitViscosity<dim>::conjugateGradients(Particles<dim>& particles, double inertia, double deltaT)
{
    auto& store = particles.store();
    const auto& settings = particles.settings().integration;
    const std::size_t n = particles.size();
    const double *m = store.component("m", 0), *lambda = store.component(ViscousRate::info.name, 0);
    const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{}), p = store.pointers(VelocityChange{}),
               Lp = store.pointers(ViscousResponse{});
    const double implicit = settings.theta*deltaT;
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
    Sums now = sum(n, [&](std::size_t i)
    {
        for (int c = 0; c < dim; ++c)
        {
            dv[c][i] = 0;
            r[c][i] = deltaT*a[c][i];
            p[c][i] = r[c][i]/(inertia + implicit*lambda[i]);
        }
        return sums(i);
    });
    for (iterations_ = 0; now.rr > sqr(settings.tolerance)*now.vv; ++iterations_)
    {
        if (iterations_ == settings.maxIter)
            throw DivergedError(fmt::format("the implicit viscosity has not converged in {} iterations: the residual is {:.3g} of the velocity, the "
                                            "tolerance {:.3g}. Choose a smaller step, or a larger `maxIter` or `tolerance` in `integration`",
                                            iterations_, std::sqrt(now.rr/now.vv), settings.tolerance));
        particles.evaluate(ofSolver);
        // What is held has a residual of 0 and keeps it: the others' equations remain, with a symmetric matrix.
        for (double* component : Lp)
            for (const int i : particles.held()) component[i] = 0;
        const double pAp = sum(n, [&](std::size_t i)
        {
            double sum = 0;
            for (int c = 0; c < dim; ++c) sum += p[c][i]*(inertia*p[c][i] - implicit*Lp[c][i]);
            return Sums{m[i]*sum};
        }).rz;
        const double alpha = now.rz/pAp;
        const Sums next = sum(n, [&](std::size_t i)
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
    std::size_t n = 0;
    for (const auto* arrays : {&change_, &residual_})
        for (const auto& array : *arrays) n += array.capacity()*sizeof(double);
    return n;
}

template class ImplicitViscosity<2>;
template class ImplicitViscosity<3>;

}
