/// Function object `conservation`: mass, momentum and energy of a run.
#pragma once
#include "sampling/FunctionContext.hpp"
#include <optional>

namespace sph
{

/// Conserved quantities of the motion, summed over the particles of the scene (not over those that openings hold beyond their planes)
///
///   m_k = sum m_i of each phase,  P = sum m_i u_i,  E_kin = 1/2 sum m_i u_i^2,  E_pot = -sum (m_i g + V_i f).x_i,
///   L = sum m_i (x_i - x_0) x u_i
///
///     type conservation;  angularMomentum no;  origin (0 0 0);
///
/// g [m/s^2] is the gravity of the moment, with `shaking` of constant/g, and f [N/m^3] the body force. In a periodic direction height has no
/// meaning: E_pot leaves g's component there out. The log gets three balances since the first sample, each 0 where all is accounted for:
///
///   dm/m,   (dP - I)/max(sum m|u|, |I|),   (dE_kin + dE_stored - W)/max(E_kin, |W|, |dE_stored|)
///
/// I [kg m/s] the impulse of gravity and body force, W [J] their work and that of walls in motion and of openings, with the energy of what passes these (solver/BoundaryWork), E_stored [J] the energy of interfaces
/// and of compression (Supply), max the largest until now. Walls and openings take momentum and bring mass: without them the second is what forces between
/// particles do not conserve. The third is below 0 by what is dissipated, -1 where that is all that forces and interfaces have given, and above 0 by what
/// the scheme creates. Where what walls and openings give is not measured (contact angles; openings with surface tension or a background pressure; beside either pressure within the step,
/// substeps, soil) the log says so beside the number.
/// Stored times know neither I nor W: there the log gets dP and dE_kin + dE_pot themselves.
class Conservation : public FunctionObject
{
    FunctionContext context_;
    std::vector<std::string> phases_;
    bool angular_;
    Vector<3> origin_;
    Location where_;
    bool isClosed_;   ///< no walls: what momentum changes beyond the forces' impulse is an error
    bool anyWork_;    ///< some wall moves, or openings hold particles: they do work
    bool anyWetting_; ///< some wall has a contact angle: its interfaces with the phases have an energy
    std::optional<OutputTable> table_;

public:
    /// Momentum and energy of all phases together.
    struct Motion
    {
        Vector<3> momentum, angularMomentum;
        double kineticEnergy = 0, potentialEnergy = 0;
        double momentumScale = 0; ///< sum m|u| [kg m/s]
        Motion& operator+=(const Motion&);
    };
    struct Sums : Motion
    {
        std::vector<double> mass; ///< of each phase
    };
    static Sums sums(const ParticleView&, const Vector<3>& origin, const Location& where);

    static EntryList entries();
    static TableInfo table();
    Conservation(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override;
    Histories histories() const override;
    void restore(const Histories&) override;

private:
    std::optional<Sums> first_;
    Sums last_;
    std::optional<Supply> firstSupply_, supply_; ///< of the first and the last sample; none of stored times
    double mostMomentum_ = 0, mostEnergy_ = 0;   ///< scales of the balances [kg m/s], [J]

    Supply given() const;
};

}
