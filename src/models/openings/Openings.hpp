/// Open boundaries (inlets and outlets): fluid particles that enter and leave the scene, and buffer particles beyond the planes, whose state is prescribed.
///
/// Buffer particles beyond each plane fill twice the support H, more with surface tension: the depth that the kernel sees from the plane, and as much again for
/// their own sums. They take part in every sum, but do not obey it: BoundaryFit gives them velocity and pressure.
///
/// Sums reach far beyond a plane: the buffer is twice the support H deep for forces, one more with the interface stress (gradC), two more with tension by
/// curvature (colour, gradC, curvature, its mean). At a plane interface across an opening, at rest, the tension pulls at the free particles with 1e-5
/// gamma/(rho dx^2) where the buffer is 2 H deep, 4e-11 with 3 and nothing with 4.
///
///     Openings<2> openings(readOpenings(theCase, geometry, coefficients, state), geometry, coefficients, state, {});
///     owned = openings.exchange(store, owned);      // lists are about to be built anew
///     openings.locate(store, owned);
///     openings.hold(store);                         // rates are there
///     openings.drive(store, deltaT, time);          // velocities are those of the end of the step
///
/// Verified by test/unit/openings and tutorials/verification/openChannel.
#pragma once
#include "models/openings/BoundaryFit.hpp"

namespace sph
{

template<int dim> class Openings
{
public:
    /// `restored` holds the numbers that `state` gave; `supports`: depth of the buffer in supports of the kernel; `fillsInPart` as in OpenScene. Throws as
    /// placeOpenings does.
    Openings(const std::vector<Opening>&, const Geometry&, const Coefficients&, const State&, const std::map<std::string, double>& restored,
             int supports = 2, bool fillsInPart = false);
    Openings(const Openings&) = delete; // its parts refer to one another

    /// Removes and inserts particles before the sorting, and returns how many there are now (BufferZone::exchange).
    std::size_t exchange(FieldStore<dim>& store, std::size_t owned, bool predicted = false)
    {
        return buffer_.exchange(store, owned, predicted);
    }
    /// Finds the buffer particles after the sorting, and updates them at new positions between two sortings.
    void locate(FieldStore<dim>& store, std::size_t owned) { buffer_.locate(store, owned); }
    void follow(FieldStore<dim>& store, bool predicted) { buffer_.follow(store, predicted); }
    /// Indices of the buffer particles.
    std::span<const int> held() const { return buffer_.held(); }
    /// Sets the rates of the buffer particles to 0 after an evaluation, and remembers the amounts that the rates would have brought into them.
    void hold(FieldStore<dim>&);
    /// Prescribes pressures and velocities of the buffer particles, once a step, after the kick. `time` [s] is that of the end of the step.
    void drive(FieldStore<dim>&, double deltaT, double time = 0);
    /// Takes the stiffness of what outlets hold away, whose pressure stays as it is while free particles move.
    void soften(FieldStore<dim>& store) const { buffer_.soften(store); }
    /// Sets a rate that is about to act for `deltaT` [s] to 0 at the buffer particles, and counts the amount that it would have brought into them.
    void withholdRate(FieldStore<dim>& store, const std::string& field, double deltaT)
    {
        account_.withholdRate(store, field, deltaT, held());
    }

    const OpeningAccount<dim>& account() const { return account_; }
    void countEnergy() { account_.countEnergy(); }
    std::vector<Flow> flows() const { return account_.flows(); }
    Imbalance imbalance(const FieldStore<dim>& store, const std::vector<double>& letIn = {}) const
    {
        return account_.imbalance(store, letIn);
    }
    /// Power of the inflow upon the fluid, Q (p + rho u^2/2) [W]; never negative.
    double power() const;
    /// Numbers of a restart, by name.
    std::map<std::string, double> state() const;

private:
    OpenScene scene_;
    std::vector<PlacedOpening> placed_;
    OpeningAccount<dim> account_;
    BufferZone<dim> buffer_;
    BoundaryFit<dim> fit_;

    /// Calls visit(name, value) for each number of a restart that is an opening's own.
    static void eachNumber(auto& self, const auto& visit);
    bool restore(const std::map<std::string, double>& numbers);
};

}
