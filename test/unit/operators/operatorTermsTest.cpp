/// Free surfaces and corrected gradients against plain loops.
#include "PlainSums.hpp"
#include <array>

namespace sph::test
{
namespace
{

/// The least eigenvalue as the largest number that leaves B positive definite (Sylvester), by bisection.
template<int dim> double leastOf(const SymmTensor<dim>& B)
{
    double low = -1, high = 2;
    for (int k = 0; k < 60; ++k)
    {
        const double middle = 0.5 * (low + high);
        const auto A = B - middle * identity(Vector<dim>{});
        bool positive = A.xx > 0 && A.xx * A.yy - A.xy * A.xy > 0;
        if constexpr (dim == 3) positive = positive && determinant(A) > 0;
        (positive ? low : high) = middle;
    }
    return low;
}

/// Detection of a surface, the normal, and what both leave of the shifting, each from the fields of the one before.
template<int dim> void freeSurface()
{
    std::array<int, 3> kinds{}; // inside, at the surface, isolated
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            g.periodic = {false, false, false}; // surfaces on all sides that have no wall
            Scene<dim> s(std::move(g), coefficients<dim>(3), with(summed, {"concentrationGradient", "surfaceShifting"}));
            const Plain<dim> plain(s);
            expectEqual(
                s, LeastEigenvalue{},
                [&](std::size_t i)
                {
                    SymmTensor<dim> B{};
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double, double, auto gradW) { B += -0.5 * plain.V[j] * twiceSymm(x, gradW); });
                    return leastOf(B);
                },
                1e-7); // the root of a cubic, where two eigenvalues are near one another
            s.refresh(LeastEigenvalue{});
            expectEqual(s, SurfaceNormal{},
                        [&](std::size_t i)
                        {
                            Vector<dim> n;
                            overPairs(s, i,
                                      [&](std::size_t j, auto, double, double, auto gradW)
                                      { n += plain.V[j] * (s.at(LeastEigenvalue{}, i) - s.at(LeastEigenvalue{}, j)) * gradW; });
                            return n;
                        });
            expectEqual(s, ShiftDirection{},
                        [&](std::size_t i)
                        {
                            Vector<dim> shift;
                            overPairs(s, i, [&](std::size_t, auto, double, double, auto gradW) { shift += -2 * plain.V[i] * gradW; });
                            const double lambda = s.at(LeastEigenvalue{}, i);
                            const auto n = 1 / mag(s.at(SurfaceNormal{}, i)) * s.at(SurfaceNormal{}, i);
                            ++kinds[lambda > 0.93 ? 0 : lambda > 0.4 ? 1 : 2];
                            if (lambda > 0.93) return shift;
                            return lambda > 0.4 ? shift - std::max(0.0, dot(shift, n)) * n : Vector<dim>{};
                        });
        });
    for (const int n : kinds) EXPECT_GT(n, 0);
}
TEST(OperatorTerms, FreeSurfaceIn2D) { freeSurface<2>(); }
TEST(OperatorTerms, FreeSurfaceIn3D) { freeSurface<3>(); }

/// The gradient of a linear pressure, on jittered particles up to their free ends: exact with the correction, and not without.
TEST(GradientCorrection, MakesALinearPressureExact)
{
    auto c = coefficients<2>(1);
    c.stateEquation = {StateEquation::tait(c.restDensity[0], c.soundSpeed[0], 1)};
    const double slope = -0.03 * c.restDensity[0];
    const auto off = [&](const char* term)
    {
        Scene<2> s(domain(2, {1, 1, 0}, {false, false, false}), c, {"integratedVolume", "tait", term}, true);
        for (std::size_t i = 0; i < s.n; ++i) s.store.component("rho", 0)[i] = c.restDensity[0] + slope * positionOf(s.store, i).y;
        s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
        Largest most;
        for (std::size_t i = 0; i < s.n; ++i)
            most(mag(s.at(Density{}, i) * s.at(Acceleration{}, i) + sqr(c.soundSpeed[0]) * Vector<2>{0, slope}));
        return most.value() / std::abs(sqr(c.soundSpeed[0]) * slope);
    };
    EXPECT_LT(off("correctedDifferencePressure"), 1e-11);
    EXPECT_GT(off("differencePressure"), 0.1);
}

}
}
