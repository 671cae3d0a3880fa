#include "verification/TwoLayerPoiseuille.hpp"
#include "verification/flowEntries.hpp"

namespace sph
{

namespace entry
{
const ListOf<double> viscosities{"viscosities", units::viscosity, required, "viscosities of the two layers, that at the origin first"},
    layerHeights{"heights", units::m, required, "thicknesses of the two layers"},
    layerDensities{"densities", units::density, required, "densities of the two layers"};
const Scalar layerPressureGradient{"pressureGradient", units::forcePerVolume, 0, "fall of the pressure along the flow"},
    layerAcceleration{"acceleration", units::mPerS2, 0, "of a body force on both layers"};
}

namespace
{
/// Two positive numbers, lower layer first.
std::vector<double> pairOf(const Dictionary& d, const ListOf<double>& two)
{
    auto values = two(d);
    if (values.size() == 2 && values[0] > 0 && values[1] > 0) return values;
    two.error(d, two.keyword() + " must be two positive numbers, the layer at the origin first");
    return {1, 1};
}

TwoLayerPoiseuille fromDictionary(const Dictionary& d)
{
    const auto mu = pairOf(d, entry::viscosities), H = pairOf(d, entry::layerHeights), rho = pairOf(d, entry::layerDensities);
    const double dp = entry::layerPressureGradient(d), f = entry::layerAcceleration(d);
    return {mu[0], mu[1], H[0], H[1], dp + rho[0] * f, dp + rho[1] * f};
}
}

TwoLayerPoiseuille::TwoLayerPoiseuille(double mu1, double mu2, double H1, double H2, double G1, double G2)
    : mu1_(mu1), mu2_(mu2), H1_(H1), H2_(H2), G1_(G1), G2_(G2), direction_{1, 0, 0}, normal_{0, 1, 0}
{
    // tau_L = G_1 H_1 + G_2 H_2 - tau_0 in v_1(H_1) = v_2(H_1)
    const double total = G1 * H1 + G2 * H2;
    tau0_ = (H2 * (2 * total - G2 * H2) / mu2 + G1 * H1 * H1 / mu1) / (2 * (H1 / mu1 + H2 / mu2));
    tauL_ = total - tau0_;
}

TwoLayerPoiseuille::TwoLayerPoiseuille(const Dictionary& d) : TwoLayerPoiseuille(fromDictionary(d))
{
    direction_ = entry::direction(d);
    normal_ = entry::normal(d);
    origin_ = entry::origin(d);
}

EntryList TwoLayerPoiseuille::entries()
{
    return {entry::viscosities,       entry::layerHeights, entry::layerDensities, entry::layerPressureGradient,
            entry::layerAcceleration, entry::direction,    entry::normal,         entry::origin};
}

double TwoLayerPoiseuille::speed(double y) const
{
    if (y < H1_) return y / (2 * mu1_) * (2 * tau0_ - G1_ * y);
    const double z = H1_ + H2_ - y;
    return z / (2 * mu2_) * (2 * tauL_ - G2_ * z);
}

}
