/// Velocities and pressures of buffer particles, fitted to the fluid before the planes of open boundaries.
///
///   inlet    v = U u n                  U mean velocity [m/s], u profile of the section (Section.hpp), n normal
///   outlet   v = (v_l.n) n, v_l the mean of the free particles within H of the plane that come along the same line l, never inwards
///   both     p = a + b s                s [m] distance from the plane, < 0; a, b fitted to the fluid within H of the plane, at an outlet
///                                       with a the given pressure; where density is integrated, the density that goes with it
///   drip and flux of a given velocity   p = p(rho), where density is a sum
///
/// The volume flow rate of an outlet is measured over the same particles:
///
///   Q = A sum_i w_i v_i.n / sum_i w_i                                   where the fluid fills the plane of area A
///   Q = sum_i w_i (m_i/rho_0) v_i.n / int_0^H w ds,   w = s (H - s)     where it may end at a free surface, and fill the plane in part
///
/// While a particle comes from H to the plane the second adds up to its volume, at whatever velocity it comes.
///
/// A drip or a flux is a piston of rows as far apart as at rest: what comes too near to them compresses them, and they push it away as the same liquid would that is free. With
/// a + b s they did not: gas came as near as half a spacing to the first row, of 1.13 to 1.27 of the density at rest, which then left at seven times its velocity; and a row that is free
/// and alone gave its own pressure to those behind it, which sped it up to three times theirs (a drip of 5 spacings at 1000:1; another in test OpenScene.WhatDripsInKeepsItsVelocity).
///
/// With several phases each has a fit p of its own, or that of all where it has none, and v_l is a mean by mass. An outlet with `backflow` lets that phase
/// in again, by lines: a line along which nothing else comes may move inwards, is filled up from behind, and what else is held on it becomes that phase. It
/// starts from rest outside, a = p - rho u^2/2, and beside it other phases have its pressure and the jump across their surface, which is measured.
///
/// An inlet that has a pressure p_in moves by the balance of forces on the plug of length l that it holds, and not faster than its velocity,
/// if it has one: dU/dt = (p_in - a)/(rho l), U >= 0.
///
/// Where ranks share the particles, sums over what is free before a plane or held beyond it are those of all: planes move alike on all ranks.
#pragma once
#include "models/openings/BufferZone.hpp"

namespace sph
{

template<int dim> class BoundaryFit
{
public:
    /// The scene must outlive the fit.
    explicit BoundaryFit(const OpenScene& scene) : scene_(scene) {}

    /// Sets the pressures, slopes and velocities of openings, once a step.
    void update(std::vector<PlacedOpening>&, const FieldStore<dim>&, const BufferZone<dim>&, double deltaT) const;

private:
    const OpenScene& scene_;

    /// Weighted sums over the free particles near a plane, with w = `weight`.
    struct Sums
    {
        double n = 0, v0 = 0, s1 = 0, p0 = 0, s2 = 0, count = 0, p1 = 0,
               flow = 0; ///< sums of w, w v, w s, w p, w s^2, 1, w s p, w v m
        Sums& operator+=(const Sums&);
    };
    /// Weighted sums over the free particles near the plane along one line of an outlet, and sums over the buffer particles on it.
    struct LineSums
    {
        double n = 0;      ///< sum of w; with several phases, of w m
        double others = 0; ///< number of particles of phases that do not come back
        double held = 0, heldV = 0;
        double v0 = 0; ///< sum of w v, or of w m v
        LineSums& operator+=(const LineSums&);
    };
    struct Fit
    {
        Sums of;
        double pressure, slope; ///< a and b
        bool enough;
    };
    /// Weight w = s (H - s) [m^2] of a free particle at a distance s from a plane: 0 at the plane and at H, so that particles enter the sums gradually.
    double weight(double s) const { return std::max(0.0, s * (scene_.coefficients.support - s)); }
    /// int_0^H w ds [m^3]
    double wholeWeight() const { return sqr(scene_.coefficients.support) * scene_.coefficients.support / 6; }
    Sums sumsOf(const FieldStore<dim>&, const Opening&, std::span<const int> near, const auto& counts) const;
    /// Sums near all openings, over all ranks: `sumsOfOpening()` for each, one over all particles near it and, with several phases, one for each phase.
    std::vector<Sums> sumsNear(const std::vector<PlacedOpening>&, const FieldStore<dim>&, const BufferZone<dim>&) const;
    std::size_t sumsOfOpening() const { return scene_.phases() > 1 ? 1 + scene_.phases() : 1; }
    /// Sums along the lines of all outlets, over all ranks.
    std::vector<LineSums> sumsOfLines(const std::vector<PlacedOpening>&, const FieldStore<dim>&, const BufferZone<dim>&) const;
    Fit fit(const Opening&, double a, const Sums&) const;
    void measure(PlacedOpening&, std::span<const Sums>) const;
    std::vector<double> velocities(const Opening&, std::span<const LineSums>) const;
};

}
