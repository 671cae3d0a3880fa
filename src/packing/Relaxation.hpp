/// Relaxation that moves particles until their number density is even, walls and periodic faces included.
///
/// Each step shifts every particle down the gradient of
///
///   P_i = b + sigma_i/<sigma> - 1
///
/// by dx_i = -C dx^2 f_i (Repulsion.hpp), where b, the bias, is a pressure that all particles share: alone it spreads them evenly
/// in distance, without it they stop as soon as the kernel sums are even, in whatever arrangement. It is b1 for the first half of
/// the steps and falls geometrically to b2 in the second. A prototype went from 8 % to 0.1 % scatter at walls.
#pragma once
#include "geometry/Geometry.hpp"
#include "kernels/Kernel.hpp"
#include "packing/Points.hpp"
#include <array>
#include <optional>

namespace sph
{

struct RelaxationSettings
{
    int steps = 200;
    std::array<double, 2> bias{1, 0.01}; ///< b1, b2
    double tolerance = 1e-3;             ///< scatter of sigma/<sigma> within a support of the walls at which to stop
    std::optional<Vector<3>> alongLines; ///< unit vector: points start on straight lines along it, and each line moves as a whole across it
    double coefficient = 0.3;            ///< C; 0.05 is slow (scatter 0.28 %), 0.2..0.8 reach 0.08..0.11 % on the bed of the unit test
    bool correctsPockets = false;        ///< at the end, for another relaxation to even out
};

/// sum_j V_j W_ij - 1 with V_j = w_j V0: what is missing to a partition of unity.
struct KernelResidual
{
    struct Moments
    {
        std::size_t particles = 0;
        double mean = 0, rms = 0, max = 0; ///< of the residual, of its square, of its magnitude
        double scatter = 0;                ///< standard deviation: what is left once the mean is normalised away
    };
    Moments overall, nearWalls; ///< all particles; those within a support of a wall
};

/// Kernel residual from which on particles count as crowded: fluid that is denser than at rest by a tenth.
inline constexpr double crowdedFrom = 0.1;
struct CrowdedParticle
{
    std::size_t particle;
    double residual;
};

/// Sealed pockets: particles that no others see through fluid, as below a rod in a fillet or between coarse grains. No relaxation changes how many there are, and a pocket that the lattice has given five has room for
/// four, say. Their number is corrected where their mean sum of W differs by more than `pocketsDiffer` from that of the rest.
struct SealedPockets
{
    std::size_t pockets = 0;             ///< whether corrected or not
    std::size_t added = 0, takenOut = 0; ///< particles
};
inline constexpr double pocketsDiffer = 0.002;

struct RelaxationResult
{
    KernelResidual before, after;
    int steps = 0;
    double largestShift = 0;                ///< of the last step, in spacings
    double centreOfMassDrift = 0;           ///< in spacings
    std::size_t heldBack = 0;               ///< particles that the last step would have put into a wall
    double closestPair = 0;                 ///< [m]
    std::array<std::size_t, 2> closest{};   ///< the particles of that pair; the same twice where an image of itself is nearest
    std::vector<CrowdedParticle> crowded{}; ///< at the end
    SealedPockets sealed{};
};

/// `V0` [m^dim] volume of a particle, `spacing` its dim-th root. Points come back sorted by cells, so that neighbours in space are
/// neighbours in memory, and inside the periodic faces, unless `correctsPockets` has put in or taken out some: results are of before that. Those `around` stay where they are: they are seen and not counted. With 0 steps nothing moves and only the residual is measured. The result does not depend on the number of
/// threads.
template<int dim>
RelaxationResult relax(const Geometry&, const Kernel<dim>&, double V0, double spacing, const RelaxationSettings&, const Points& around,
                       Points&);

}
