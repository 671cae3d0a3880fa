#include "verification/DragFactor.hpp"
#include "base/words.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/sharedEntries.hpp"
#include "verification/Drop.hpp"
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar radius{"radius", units::m, required, positive, "of the spheres, in 2-D of the cylinders"},
    period{"period", units::m, notGiven, positive, "edge of the lattice's cell, in place of solidFraction"},
    solidFraction{"solidFraction", units::none, byScene("that of lattice and period"), positive, "share of the solids in the cell"},
    reference{"reference", units::none, byScene("that of the lattice at the solid fraction"), positive, "the exact factor K"};
const Word lattice{"lattice", notGiven, "sc, bcc or fcc; in 2-D square"};
}

namespace
{

using std::numbers::pi;

/// Solid fraction and K of each lattice.
const std::map<std::string, std::vector<std::pair<double, double>>>& references()
{
    static const std::map<std::string, std::vector<std::pair<double, double>>> table{
        {"sc",
         {{0.001, 1.21214},
          {0.027, 2.00775},
          {0.064, 2.81020},
          {0.125, 4.29159},
          {0.216, 7.44194},
          {0.343, 15.400},
          {0.45, 28.08},
          {0.5236, 42.08}}},
        {"bcc",
         {{0.001, 1.21682},
          {0.027, 2.04406},
          {0.064, 2.88939},
          {0.125, 4.44639},
          {0.216, 7.73881},
          {0.343, 16.335},
          {0.45, 31.69},
          {0.6802, 162.6}}},
        {"fcc", {{0.001, 1.21680}, {0.027, 2.04387}, {0.064, 2.88875}, {0.125, 4.44572}, {0.216, 7.75764}, {0.343, 16.639}, {0.45, 33.49}}},
        {"square", {{0.05, 15.56}, {0.10, 24.83}, {0.20, 51.53}, {0.40, 217.89}, {0.60, 1763}}},
    };
    return table;
}

/// K rises by up to 4 % for 1 % of solid fraction near 0.45.
constexpr double sameSolidFraction = 1e-3;

/// Spheres per cell of edge `period`.
int spheresPerCell(const std::string& lattice) { return lattice == "bcc" ? 2 : lattice == "fcc" ? 4 : 1; }

double referenceOf(const Dictionary& d, const std::string& lattice, double solidFraction, const std::vector<std::string>& lattices)
{
    const auto known = references().find(lattice);
    if (known == references().end())
    {
        if (!entry::lattice.given(d))
            entry::lattice.error(d, "dragFactor needs a lattice or a reference. Known lattices: " + list(lattices));
        return 1;
    }
    std::string fractions;
    for (const auto& [fraction, K] : known->second)
    {
        if (std::abs(fraction - solidFraction) <= sameSolidFraction * fraction) return K;
        fractions += fmt::format("{}{}", fractions.empty() ? "" : ", ", fraction);
    }
    entry::lattice.error(d,
                         fmt::format("K of {} is not known for a solid fraction of {:.4g}. Known solid fractions: {}; or give `reference`",
                                     lattice, solidFraction, fractions));
    return 1;
}

}

DragFactor::DragFactor(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)), radius_(entry::radius(d))
{
    const std::vector<std::string> lattices =
        geometry.dimension == 2 ? std::vector<std::string>{"square"} : std::vector<std::string>{"sc", "bcc", "fcc"};
    std::string lattice;
    if (entry::lattice.given(d)) lattice = entry::lattice.among(d, lattices);
    if (const auto period = entry::period.ifGiven(d))
    {
        const double a = radius_ / *period;
        solidFraction_ = geometry.dimension == 2 ? pi * a * a : spheresPerCell(lattice) * 4.0 / 3 * pi * a * a * a;
        if (lattice.empty()) entry::lattice.error(d, "lattice is needed where period is given. Known lattices: " + list(lattices));
    }
    else solidFraction_ = entry::solidFraction.needed(d);
    const auto reference = entry::reference.ifGiven(d);
    reference_ = reference ? *reference : referenceOf(d, lattice, solidFraction_, lattices);
}

EntryList DragFactor::entries()
{
    return {entry::phase, entry::radius, entry::lattice, entry::period, entry::solidFraction, entry::reference};
}

Measurement DragFactor::operator()(const ParticleView& view) const
{
    const SampledField U(view, "U", {});
    const double g = mag(view.g), Vcell = domainVolume(*view.geometry);
    Measurement result;
    result.reference = reference_;
    result.particles = view.n;
    const auto down = g > 0 ? view.g / g : Vector<3>{};
    const auto alongG = [&](std::size_t i) { return dot(Vector<3>{U(0, i), U(1, i), U(2, i)}, down); };
    const double superficial = sum(view.n, [&](std::size_t i) { return view.volume[i] * alongG(i); }) / Vcell;
    const double rho = view.restDensity.at(phase_), mu = view.viscosity.at(phase_);
    const double a = radius_, phi = solidFraction_;
    result.value =
        view.dimension == 2 ? rho * g * pi * a * a / (phi * mu * superficial) : 2 * a * a * rho * g / (9 * phi * mu * superficial);
    if (superficial == 0)
    {
        result.value = std::numeric_limits<double>::quiet_NaN();
        result.note = "there is no flow along g";
    }
    return result;
}

}
