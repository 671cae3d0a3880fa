#pragma once
#include "FunctionContext.hpp"
#include <optional>

namespace sph
{
class SampledField;

/// How liquid sits and moves in a packed bed
///
///   porosity = V_pore/V_bed,  saturation = V_liquid/V_pore,  hold-up = V_liquid/V_bed
///   superficial velocity of phase k = sum_k V_i u_i/V_bed,  interstitial = sum_k V_i u_i/sum_k V_i
///   wetted fraction = wall area with liquid next to it/wall area
///   Bo = rho g L^2/gamma (gravity over capillarity),  Ca = mu |u|/gamma,  Re = rho |u| L/mu,  u: superficial, of the liquid
///
///     type bedHydrodynamics;  liquid water;  length 2e-3;  porosity 0.388;  region { min (..); max (..); }  samples 64;
///     sections (0.01 0.02);  direction (0 0 -1);  drain out;
///
/// `sections`: superficial velocities along `direction` through planes at these coordinates, sum_k V_i u_i.n w_i/A, w a hat of 2 spacings to either side,
/// A the bed's section. `drain`: an outlet of constant/openings; of marked liquid (`markFrom` there) the mass that has left through it, and the mean
/// and the standard deviation of the time that it took.
///
/// `liquid`: by default the first phase. `length` L [m]: the shortest period of the domain, or its extent in x. `porosity`: by
/// default the fraction of `samples` points per direction that lie outside the walls. `region`: the bed, by default the domain.
/// Wall area: each particle nearer than one spacing to a wall counts with its volume divided by the local growth of area with
/// distance, (1 - k_1 d)(1 - k_2 d); with one phase (gas left out) the area of all walls comes from the samples.
class BedHydrodynamics : public FunctionObject
{
    FunctionContext context_;
    std::vector<std::string> phases_;
    std::size_t liquid_;
    double length_;
    std::optional<double> porosity_, wallArea_;
    Vector<3> low_, high_;
    int samples_;
    Vector<3> direction_;
    std::vector<double> sections_;
    std::string drain_;
    Location where_;
    std::optional<OutputTable> table_;
    std::string report_;

    void sampleBed(double layer);
    bool inBed(const Vector<3>&) const;
    /// Of each phase along `direction` through the bed's section at a coordinate [m/s].
    std::vector<double> superficialAt(double, const ParticleView&, const SampledField& U, std::size_t phases) const;
    double numberOf(const char* what, const ParticleView&) const;

public:
    static EntryList entries();
    BedHydrodynamics(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override { return report_; }
};

}
