/// Total amount of each scalar, and the step by its diffusion: dt <= f h^2/D, h = H/2 [m], D [m^2/s] the largest k_kl/min(rho_k, rho_l) of all
/// pairs of phases. f = 0.125; noise grows from 0.3 on
/// with wendlandC2, from 0.18 on with wendlandC6 and a support of 4 spacings (test/stability/README.md).
#pragma once
#include "models/scalarTransport/TransportedScalar.hpp"
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class ScalarBalance final : public RunningModel<dim>
{
public:
    ScalarBalance(Particles<dim>&, const Numbers& restored, const std::vector<TransportedScalar>&);

    /// Keeps what there is at the first start.
    std::vector<Stage<dim>> stages(JoinPoint) override;
    std::vector<StepLimit> limits() const override { return limits_; }
    Numbers columns(const Particles<dim>&) const override;
    std::string report(const Particles<dim>&) const override;
    void save(Numbers&) const override;

private:
    struct Held
    {
        double least = 0, most = 0, amount = 0, size = 0; ///< amount sum m c, size sum m |c| [kg]
    };
    std::vector<std::string> names_;
    std::vector<StepLimit> limits_;
    Numbers start_; ///< amounts at the first start [kg], by name

    Held held(const Particles<dim>&, const std::string& name) const;
    double change(const std::string& name, const Held&) const;
};

}
