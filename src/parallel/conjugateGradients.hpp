/// Conjugate gradients for A x = b, with A symmetric and positive in the inner product sum_i w_i a_i.b_i, preconditioned by a diagonal. Nothing of A is
/// stored: who solves says what it makes of a direction.
#pragma once
#include "base/StepTooLong.hpp"
#include "parallel/reduce.hpp"
#include <array>
#include <fmt/format.h>

namespace sph
{

/// Arrays of n vectors, one array a component.
template<int components> struct LinearSystem
{
    const char* name; ///< who it is solved for, in errors: "the implicit pressure"
    std::size_t n;
    const double* weight; ///< w
    /// r holds b before and what is left of it, b - A x, afterwards; p is the direction that A is applied to.
    std::array<double*, components> x, r, p;
};

/// r.z of the residual, z = r/diagonal, and whatever else of each iterate is asked for.
template<class Further> struct ResidualSums
{
    double rz = 0;
    Further further{};
    ResidualSums& operator+=(const ResidualSums& b)
    {
        rz += b.rz;
        further += b.further;
        return *this;
    }
};

/// Iterates from x = 0 until `done(sums, iterations)`, which throws where it gives up. `diagonal(i)` is that of A; `apply()` readies `applied(c, i)`, (A p)_i;
/// `further(i)` is summed over i for `done`. Returns the number of iterations.
///
/// Throws StepTooLong where A is not positive along a direction: a step along it leads away from the solution. To go on along the preconditioned residual, in
/// its place, was tried on indefinite matrices: the residual grew without bound.
template<int components>
int conjugateGradients(const LinearSystem<components>& s, const auto& diagonal, const auto& apply, const auto& applied, const auto& further,
                       const auto& done)
{
    using Sums = ResidualSums<decltype(further(s.n))>;
    const auto sums = [&](std::size_t i)
    {
        double r2 = 0;
        for (int c = 0; c < components; ++c) r2 += s.r[c][i] * s.r[c][i];
        return Sums{s.weight[i] * r2 / diagonal(i), further(i)};
    };
    Sums now = sum(s.n,
                   [&](std::size_t i)
                   {
                       for (int c = 0; c < components; ++c)
                       {
                           s.x[c][i] = 0;
                           s.p[c][i] = s.r[c][i] / diagonal(i);
                       }
                       return sums(i);
                   });
    int iterations = 0;
    for (; !done(now, iterations); ++iterations)
    {
        apply();
        const double pAp = sum(s.n,
                               [&](std::size_t i)
                               {
                                   double product = 0;
                                   for (int c = 0; c < components; ++c) product += s.p[c][i] * applied(c, i);
                                   return s.weight[i] * product;
                               });
        if (!(pAp > 0))
            throw StepTooLong(fmt::format("{} cannot be solved for: after {} iterations its matrix has the product p.Ap = {:.3g} with a "
                                          "direction p, and should be positive along all. Choose a smaller step",
                                          s.name, iterations, pAp));
        const double alpha = now.rz / pAp;
        const Sums next = sum(s.n,
                              [&](std::size_t i)
                              {
                                  for (int c = 0; c < components; ++c)
                                  {
                                      s.x[c][i] += alpha * s.p[c][i];
                                      s.r[c][i] -= alpha * applied(c, i);
                                  }
                                  return sums(i);
                              });
        const double beta = next.rz / now.rz;
        now = next;
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < s.n; ++i)
            for (int c = 0; c < components; ++c) s.p[c][i] = s.r[c][i] / diagonal(i) + beta * s.p[c][i];
    }
    return iterations;
}

}
