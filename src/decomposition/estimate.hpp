/// Estimate of the ranks' work and messages: counted on the particles of a case, cut into boxes as a run of so many ranks cuts them.
#pragma once
#include "geometry/Geometry.hpp"
#include <span>
#include <string>
#include <vector>

namespace sph
{

/// Load of each rank.
struct RankLoad
{
    std::vector<double> particles;
    std::vector<double> copies;     ///< of other ranks' particles within reach of the rank's box, through periodic faces too
    std::vector<double> neighbours; ///< ranks that it sends copies to or has copies from: messages of a refresh
};

/// `reach` [m] of the halo, `spacing` [m] of particles. Walls are left out: mirror images of particles of others near a wall add copies
/// along the edges between wall and box.
RankLoad loadOf(const Geometry&, std::span<const Vector<3>> places, std::size_t parts, double reach, double spacing);

/// A machine and a scheme. Latency and bandwidth are of the order that networks of clusters have, assumed and not measured; the rest is a
/// liquid in 3-D by predictorCorrector (two evaluations a step, each with positions and then p, V, U and gradientScale of copies), whose
/// steps took 2.2e-6 s a particle with 97 neighbours, lists included, on one core of a busy machine.
struct Costs
{
    double latency = 2e-6;            ///< of a message [s]
    double bandwidth = 1e10;          ///< of a rank [bytes/s]
    double secondsPerParticle = 2e-6; ///< of one particle in a step [s]
    int refreshes = 4;                ///< of copies in a step
    int values = 18;                  ///< numbers of a copy that are sent in a step, in all
};

/// Time that a rank spends in communication over all its time in a step; the latter is n secondsPerParticle + refreshes neighbours
/// latency + 8 values copies/bandwidth.
double shareOfCommunication(const Costs&, double particles, double copies, double neighbours);

/// The same ranks with `total` particles in the same shape: copies are what lies within reach R of a cube of side L = n^(1/d) spacings
/// (Steiner: 4 L R + pi R^2; 6 L^2 R + 3 pi L R^2 + 4/3 pi R^3), in proportion to those that were counted; neighbours are those that were
/// counted, but no more than the 3^d - 1 that a box longer than the reach has.
struct Scaled
{
    double particles, copies, neighbours; ///< of a rank, means
};
Scaled scaledTo(const RankLoad&, double total, int dimension, double reach, double spacing);

}
