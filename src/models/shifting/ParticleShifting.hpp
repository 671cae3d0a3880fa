/// Gradient of the particle concentration, down which particle shifting moves: Lind et al. (2012), with the factor 2 V_i.
///
///   shift_i = -2 V_i sum_j gradW_ij,      then  dx_i = C |v| dt Delta_x shift_i
///
/// with H^2/50 for C |v| dt Delta_x where an implicit step makes that larger (Shifter.hpp).
/// V [m^3]; shift [1/m]; C 2 to 8; Delta_x the particle spacing; |v| the particle's own speed or, with `shiftingSpeed largest;`, that of the
/// fastest: lattices are torn where streamlines part, at points of no speed (tutorials/verification/taylorGreen: 2.8 to 3.8 % of error with
/// the own speed and C = 4, 1.2 to 2 % with the largest). Conserves nothing: it moves particles through the flow field.
#pragma once
#include "fields/freeSurfaceTags.hpp"
#include "plan/Coefficients.hpp"
#include <cmath>

namespace sph
{

struct ConcentrationSum
{
    using ReadsOwn = Fields<Volume>;
    auto operator()(const auto& ij, const auto& i, const auto&) const { return -2 * i.V * ij.gradW; }
};
struct ConcentrationGradient : ConcentrationSum
{
    static constexpr auto name = "particleShifting";
    using Provides = ShiftDirection;
};

/// The gradient of the concentration in a field of its own, of which a free surface leaves a part.
struct SeparateConcentrationGradient : ConcentrationSum
{
    static constexpr auto name = "concentrationGradient";
    using Provides = ConcentrationSlope;
};

/// A gradient of concentration, and where the particles of other phases are: sums of one loop.
template<int dim> struct ConcentrationAndOthers
{
    Vector<dim> gradC, others;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.gradC, q.others); }
};

/// Shifting between any number of phases: inside each, less and less towards its interfaces, and never into another phase.
///
///   shift_i = max(0, 1 - H |n_i|) (s_i - max(0, s_i.e_i) e_i),     n_i = sum_(j of other phases) V_j gradW_ij,    e_i = n_i/|n_i|
///
/// s_i as above, H [m] the support, n [1/m] the kernel's slope over the other phases: as gradW_ij points from i to j, so does n_i to them. At a plane
/// interface and a support of three spacings H |n| is 1.2 in the first row of particles, 0.27 in the second and 0 from the third on.
///
/// s_i knows no phases and moves particles of one into the gaps of another. Lind et al. (2012), and for liquid and gas Mokos et al. (2017), forbid that along
/// the normal of the liquid's surface and shift the gas freely. At 1000:1 this does not do: a row of water that is shifted along the interface, or away from
/// it into the water, compresses the water, which is a hundred times as stiff as the air, and its pressure throws the air about. Hence the factor.
/// src/models/shifting/README.md has the numbers. Verified by test/unit/shifting (plain loop; nothing of it towards other phases; a drop of torn phases).
struct WithinPhase
{
    using Reads = Fields<Volume, Phase>;
    double H;

    explicit WithinPhase(const Coefficients& c) : H(c.support) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return ConcentrationAndOthers<dimensions(decltype(ij.x){})>{ij.gradW, (j.phase == i.phase ? 0.0 : 1.0) * j.V * ij.gradW};
    }
    auto finish(const auto& i, const auto& sum) const
    {
        const auto s = -2 * i.V * sum.gradC;
        const auto& n = sum.others;
        return std::fmax(0.0, 1 - H * mag(n)) * (s - std::fmax(0.0, dot(s, n)) / (dot(n, n) + 1e-300) * n);
    }
};
struct InterfaceShifting : WithinPhase
{
    static constexpr auto name = "interfaceShifting";
    using Provides = ShiftDirection;
    using WithinPhase::WithinPhase;
};

/// The gradient within the phase, in the field of which a free surface leaves a part.
struct ConcentrationWithinPhase : WithinPhase
{
    static constexpr auto name = "concentrationWithinPhase";
    using Provides = ConcentrationSlope;
    using WithinPhase::WithinPhase;
};

/// Shifting where there is a free surface: along it and never across, Sun et al. (2017), eq. (22), after Lind et al. (2012).
///
///   shift_i = s_i                  lambda_i > 0.93       inside
///           = s_i - (s_i.n) n      0.4 < lambda_i        within two rows of the surface; only where s_i points outwards: s_i.n > 0
///           = 0                    lambda_i < 0.4        spray, and the tips of thin films
///
/// s_i as above, lambda and n of FreeSurface.hpp. The fluid ends at a surface, and what is missing there is not a low concentration:
/// shifted towards it, the first row evaporates.
struct SurfaceShifting
{
    static constexpr auto name = "surfaceShifting";
    using Provides = ShiftDirection;
    using ReadsOwn = Fields<ConcentrationSlope, LeastEigenvalue, SurfaceNormal>;
    static constexpr double inside = 0.93, isolated = 0.4;

    auto operator()(const auto& i) const
    {
        const double outwards = std::fmax(0.0, dot(i.gradN, i.n)) / (dot(i.n, i.n) + 1e-300);
        const double across = i.lambda > inside ? 0.0 : outwards;
        const double moves = i.lambda > isolated ? 1.0 : 0.0;
        return moves * (i.gradN - across * i.n);
    }
};

/// Shifting inside a liquid alone, whose gas is left out (models/gas): less and less towards its free surface.
///
///   shift_i = -2 V_i g_i e_i,     g = sum_j gradW_ij
///
/// e [-] is the share of the interior (InteriorShare). g [1/m^(d + 1)] and the share t [-] of the surface, which e is of, are those of the completed density (models/gas/CompletedDensity.hpp): no sum is made for it. Liquid that is sheared on and on, as in drops that run along a wall, without any pressure to speak of otherwise comes to
/// lie in lines with gaps between them, and each gap is taken for a surface.
struct InteriorShifting
{
    static constexpr auto name = "interiorShifting";
    using Provides = ShiftDirection;
    using ReadsOwn = Fields<Volume, SlopeSum, SurfaceShare>;

    auto operator()(const auto& i) const { return -2 * i.V * InteriorShare::of(i.t) * i.g; }
};

}
