#pragma once
#include "FunctionContext.hpp"
#include <optional>

namespace sph
{

/// What the motion should conserve, summed over all particles
///
///   m_k = sum m_i of each phase,  P = sum m_i u_i,  E_kin = 1/2 sum m_i u_i^2,  E_pot = -sum (m_i g + V_i f).x_i,
///   L = sum m_i (x_i - x_0) x u_i
///
///     type conservation;  angularMomentum no;  origin (0 0 0);
///
/// g [m/s^2] is the gravity of the moment, with `shaking` of constant/g, and f [N/m^3] the body force. In a periodic direction height has
/// no meaning: E_pot leaves their components there out. The log gets the changes since the first sample, relative to the total mass, to sum
/// m|u|, and to the largest kinetic energy so far.
class Conservation : public FunctionObject
{
    FunctionContext context_;
    std::vector<std::string> phases_;
    bool angular_;
    Vector<3> origin_;
    Location where_;
    std::optional<OutputTable> table_;

public:
    /// Of all phases together.
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
    Conservation(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override;
    Histories histories() const override;
    void restore(const Histories&) override;

private:
    std::optional<Sums> first_;
    Sums last_;
    double largestKinetic_ = 0;
};

}
