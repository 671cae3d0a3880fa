/// Function object `bedHydrodynamics`: saturation, hold-up, flow and wetting of a packed bed.
#pragma once
#include "sampling/FunctionContext.hpp"
#include "sampling/WettedWalls.hpp"
#include <optional>

namespace sph
{
class SampledField;

/// Hydrodynamics of liquid in a packed bed
///
///   porosity = V_pore/V_bed,  saturation = V_liquid/V_pore,  hold-up = V_liquid/V_bed
///   superficial velocity of phase k = sum_k V_i u_i/V_bed,  interstitial = sum_k V_i u_i/sum_k V_i
///   (sums over the particles in the bed that no opening holds)
///   wetted fraction = wetted area of the grains/area of the grains (WettedWalls.hpp), and both of each wall
///   residence time = hold-up L_n/superficial velocity along n = V_liquid/Q: liquid that is in the bed over its flow, L_n the bed's length along n
///   Bo = rho g L^2/gamma (gravity over capillarity),  Ca = mu |u|/gamma,  Re = rho |u| L/mu,  u: superficial, of the liquid
///
///     type bedHydrodynamics;  liquid water;  length 2e-3;  porosity 0.388;  region { min (..); max (..); }  samples 64;
///     sections (0.01 0.02);  direction (0 0 -1);  grains (rocks);  drain out;
///
/// The residence time is that of what is inside as well as of what has left: of a steady flow it is the mean over all that passes, from the first
/// instant on (Danckwerts 1953, Chem. Eng. Sci. 2). It has no value while the liquid does not flow along n. `drain`: an outlet of constant/openings;
/// of marked liquid (`markFrom` there) the mass that has left through it, and the mean and the standard deviation of the time that it took. That mean
/// is below the residence time until all that was marked has left: what is quick comes first.
///
/// `sections`: superficial velocities along `direction` n through planes at these coordinates, sum_k V_i u_i.n w_i/A, w a hat of 2 spacings to either
/// side, A the bed's section. `liquid`: by default the first phase. `length` L [m]: the shortest period of the domain, or its extent in x. `porosity`:
/// by default the fraction of `samples` points per direction that lie outside the walls. `region`: the bed, by default the domain. `grains`: walls
/// whose area is the bed's, by default those with fluid around them, not the sides that hold the bed; all where there are no others.
class BedHydrodynamics : public FunctionObject
{
    FunctionContext context_;
    std::vector<std::string> phases_;
    std::size_t liquid_;
    double length_;
    std::optional<double> porosity_;
    Vector<3> low_, high_;
    int samples_;
    Vector<3> direction_;
    std::vector<double> sections_;
    std::vector<std::string> grains_; ///< walls
    std::string drain_;
    Location where_;
    std::optional<WettedWalls> wettedWalls_; ///< from the first row on
    std::optional<OutputTable> table_;
    std::string report_;

    double sampledPorosity() const;
    bool inBed(const Vector<3>&) const;
    /// Unit vector along which the liquid is to flow.
    Vector<3> flowDirection(const ParticleView&) const;
    /// Superficial velocity of each phase along `direction` through the bed's section at a coordinate [m/s].
    std::vector<double> superficialAt(double, const ParticleView&, const SampledField& U, std::size_t phases) const;
    double numberOf(const char* what, const ParticleView&) const;

public:
    static EntryList entries();
    static TableInfo table();
    BedHydrodynamics(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override { return report_; }
};

}
