/// Powder that migrates while a step of the flow passes: steps of its own at the velocities and positions of the flow.
///
///   mu(phi), gammaDot(v, mu), dphi/dt by terms of `transport` and `materials`;    phi += dt dphi/dt
///   dt <= f h^2/max_i D_i,    D = gammaDot phi (D_c a^2 + D_eta a^2 phi 1/mu dmu/dphi)        f = 0.25; unstable from 0.4 in three dimensions
///
/// h = H/2 [m], D [m^2/s]. The time that the flow takes by itself is often a thousand times shorter, and one solve for the velocities
/// serves four of these steps (`migrationSteps`) within 0.1 % of phi.
#pragma once
#include "FieldStore.hpp"
#include "Plan.hpp"
#include "Settings.hpp"

namespace sph
{

template<int dim> class Migration
{
public:
    Migration(const Settings&, const Catalogue<dim>&, FieldStore<dim>&);

    /// After each change of the arrays or the coefficients.
    void bind(FieldStore<dim>&, const Coefficients&);
    std::set<std::string> readAtNeighbours() const;

    /// Viscosity, shear rate and dphi/dt at the present phi and velocities, for positions and pairs as of the last evaluation of the flow.
    void evaluate(FieldStore<dim>&, const Images<dim>&, NeighbourLists<dim>&, const Kernel<dim>&);
    /// phi after `deltaT` [s]. The `held` particles keep theirs; returns the powder that has gone into them nonetheless [m^3].
    double advance(FieldStore<dim>&, const Images<dim>&, NeighbourLists<dim>&, const Kernel<dim>&, double deltaT, std::span<const int> held = {});

    /// Of one step, at the last evaluation [s].
    double limit() const { return limit_; }
    /// Of the last `advance`.
    int steps() const { return steps_; }
    std::size_t bytes() const { return correction_.bytes() + rates_.bytes(); }
    void printPasses(std::ostream& out) const
    {
        correction_.printPasses(out);
        rates_.printPasses(out);
    }

private:
    const Settings& settings_;
    Plan<dim> correction_, rates_;      ///< correction: of the gradient, once a step of the flow
    double limit_;
    int steps_ = 0;

    void evaluateRates(FieldStore<dim>&, const Images<dim>&, NeighbourLists<dim>&, const Kernel<dim>&);
};

}
