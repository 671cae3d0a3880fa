/// Field tags: name on disk and in the log, unit, and how an image's value follows from its source's.
///
/// The member template `At` carries the symbol of the papers, so that a term writes i.rho and j.rho.
#pragma once
#include "base/values.hpp"

namespace sph
{

/// copied: the source's own value; mirrored: rotated with the wall (vectors, tensors); ruled: by the rule of the field `ofRule`, without one copied;
/// ruledChange: what that rule makes of a change; ruledGradient: what it makes of a gradient of such values; interface: mirrored, or copied where walls prescribe the interface's direction; placed: what an
/// image is rather than what its source has, written when images are moved and never refreshed.
enum class Image
{
    copied,
    mirrored,
    ruled,
    ruledChange,
    ruledGradient,
    interface,
    placed
};

/// Values of a particle of a wall layer: by pair, a value for each particle of the fluid that sees it; or one value of its own, a mean over the fluid
/// within sight (WallLayers.hpp).
enum class InLayers
{
    byPair,
    extrapolated
};

struct FieldInfo
{
    const char *name, *unit;
    Image image = Image::copied;
    const char* ofGhosts = nullptr; ///< field that wall ghosts take their value from, where the scene has it
    const char* ofRule = nullptr;   ///< field whose rule images follow
    InLayers inLayers = InLayers::byPair;
};

// clang-format off
struct Position            { static constexpr FieldInfo info{"positions", "m"};                         template<int dim> struct At { Vector<dim> x; }; };
struct Velocity            { static constexpr FieldInfo info{"U", "m/s", Image::ruled, nullptr, "U"};            template<int dim> struct At { Vector<dim> v; }; };
struct Mass                { static constexpr FieldInfo info{"m", "kg"};                                template<int dim> struct At { double m; }; };
struct DynamicViscosity    { static constexpr FieldInfo info{"mu", "Pa s"};                             template<int dim> struct At { double mu; }; };
struct Phase               { static constexpr FieldInfo info{"phase", "1"};                             template<int dim> struct At { Label phase; }; };
struct Density             { static constexpr FieldInfo info{"rho", "kg/m^3"};                          template<int dim> struct At { double rho; }; };
struct Volume              { static constexpr FieldInfo info{"V", "m^3"};                               template<int dim> struct At { double V; }; };
struct Pressure            { static constexpr FieldInfo info{"p", "Pa", Image::ruled, nullptr, "p", InLayers::extrapolated};            template<int dim> struct At { double p; }; };
struct KernelMoment        { static constexpr FieldInfo info{"M", "1/m^3"};                             template<int dim> struct At { double M; }; };
struct GradientScale       { static constexpr FieldInfo info{"gradientScale", "1"};                      template<int dim> struct At { double N; }; };
struct Stress              { static constexpr FieldInfo info{"S", "Pa", Image::mirrored, "solidStress"}; template<int dim> struct At { SymmTensor<dim> S; }; };
struct SolidStress         { static constexpr FieldInfo info{"solidStress", "Pa", Image::mirrored};             template<int dim> struct At { SymmTensor<dim> S_s; }; };
struct WallNormal          { static constexpr FieldInfo info{"wallNormal", "1"};                        template<int dim> struct At { Vector<dim> n_w; }; };
struct WallCosine          { static constexpr FieldInfo info{"wallCosine", "1"};                        template<int dim> struct At { double cosTheta; }; };
struct SmoothedColour      { static constexpr FieldInfo info{"colour", "1"};                            template<int dim> struct At { double colour; }; };
struct ColourGradient      { static constexpr FieldInfo info{"gradC", "1/m", Image::interface};         template<int dim> struct At { Vector<dim> gradC; }; };
struct RawCurvature        { static constexpr FieldInfo info{"rawKappa", "1/m"};                        template<int dim> struct At { double rawKappa; }; };
struct Curvature           { static constexpr FieldInfo info{"kappa", "1/m"};                           template<int dim> struct At { double kappa; }; };
struct Acceleration        { static constexpr FieldInfo info{"dUdt", "m/s^2", Image::mirrored};         template<int dim> struct At { Vector<dim> dvdt; }; };
struct SlowAcceleration    { static constexpr FieldInfo info{"dUdtSlow", "m/s^2", Image::mirrored};     template<int dim> struct At { Vector<dim> a_s; }; };
struct PressureAcceleration{ static constexpr FieldInfo info{"dUdtByPressure", "m/s^2", Image::mirrored}; template<int dim> struct At { Vector<dim> a_p; }; };
struct WallAcceleration    { static constexpr FieldInfo info{"dUdtAtWall", "m/s^2", Image::mirrored};   template<int dim> struct At { Vector<dim> a_w; }; };
struct DensityRate         { static constexpr FieldInfo info{"drhodt", "kg/(m^3 s)"};                   template<int dim> struct At { double drhodt; }; };
struct ShiftDirection      { static constexpr FieldInfo info{"shift", "1/m", Image::mirrored};          template<int dim> struct At { Vector<dim> shift; }; };
struct TransportVelocity   { static constexpr FieldInfo info{"dUTransport", "m/s", Image::mirrored};     template<int dim> struct At { Vector<dim> w; }; };
struct TransportAcceleration{ static constexpr FieldInfo info{"dUdtTransport", "m/s^2", Image::mirrored}; template<int dim> struct At { Vector<dim> a_t; }; };
struct CorrectionTensor    { static constexpr FieldInfo info{"L", "1", Image::mirrored};                template<int dim> struct At { SymmTensor<dim> L; }; };
struct LeastEigenvalue     { static constexpr FieldInfo info{"lambda", "1"};                            template<int dim> struct At { double lambda; }; };
struct SurfaceNormal       { static constexpr FieldInfo info{"surfaceNormal", "1/m", Image::mirrored};  template<int dim> struct At { Vector<dim> n; }; };
struct ConcentrationSlope  { static constexpr FieldInfo info{"gradConcentration", "1/m", Image::mirrored}; template<int dim> struct At { Vector<dim> gradN; }; };
struct DensityGradient     { static constexpr FieldInfo info{"gradRho", "kg/m^4", Image::mirrored};     template<int dim> struct At { Vector<dim> gradRho; }; };
struct VelocityChange      { static constexpr FieldInfo info{"dU", "m/s", Image::ruledChange, nullptr, "U"};       template<int dim> struct At { Vector<dim> dv; }; };
struct DelayedImpulse      { static constexpr FieldInfo info{"delayedImpulse", "m/s", Image::mirrored};      template<int dim> struct At { Vector<dim> delayed; }; };
struct ViscousResponse     { static constexpr FieldInfo info{"dUdtOfChange", "m/s^2", Image::mirrored}; template<int dim> struct At { Vector<dim> response; }; };
struct StiffResponse       { static constexpr FieldInfo info{"d2Udt2OfChange", "m/s^3", Image::mirrored}; template<int dim> struct At { Vector<dim> response; }; };
struct StiffRate           { static constexpr FieldInfo info{"stiffRate", "1/s^2"};                     template<int dim> struct At { double kappa; }; };
struct VolumeStiffness     { static constexpr FieldInfo info{"volumeStiffness", "J m^6"};               template<int dim> struct At { double a; }; };
struct PressureStrength    { static constexpr FieldInfo info{"pressureStrength", "Pa m^6"};              template<int dim> struct At { double P; }; };
struct Displacement        { static constexpr FieldInfo info{"displacement", "m/s", Image::mirrored};   template<int dim> struct At { Vector<dim> u; }; };
struct CompressionChange   { static constexpr FieldInfo info{"compressionOfChange", "N m^4"};         template<int dim> struct At { double q; }; };
struct ViscousRate         { static constexpr FieldInfo info{"viscousRate", "1/s"};                     template<int dim> struct At { double lambda; }; };
struct ViscousGradient     { static constexpr FieldInfo info{"viscousGradient", "1/s", Image::ruledGradient, nullptr, "U"};       template<int dim> struct At { Tensor<dim> G; }; };
struct PowderFraction      { static constexpr FieldInfo info{"phi", "1"};                               template<int dim> struct At { double phi; }; };
struct PowderRate          { static constexpr FieldInfo info{"dphidt", "1/s"};                          template<int dim> struct At { double dphidt; }; };
struct ShearRate           { static constexpr FieldInfo info{"gammaDot", "1/s"};                        template<int dim> struct At { double gammaDot; }; };
struct ShearStress         { static constexpr FieldInfo info{"tau", "Pa"};                              template<int dim> struct At { double tau; }; };
struct RelativeViscositySlope { static constexpr FieldInfo info{"viscositySlope", "1"};                 template<int dim> struct At { double slope; }; };
struct Holder              { static constexpr FieldInfo info{"heldBy", "1"};                             template<int dim> struct At { double holder; }; };
struct HeldPressure        { static constexpr FieldInfo info{"heldPressure", "Pa"};                      template<int dim> struct At { double p_h; };
                             static constexpr double ofDensity = -1e30; }; ///< of what has the pressure of its density
struct BoundaryShare       { static constexpr FieldInfo info{"boundaryShare", "1", Image::placed};              template<int dim> struct At { double s_b; }; };
struct BoundaryAcceleration{ static constexpr FieldInfo info{"dUdtByBoundary", "m/s^2", Image::mirrored}; template<int dim> struct At { Vector<dim> a_b; }; };
struct BoundaryDensityRate { static constexpr FieldInfo info{"drhodtByBoundary", "kg/(m^3 s)"};          template<int dim> struct At { double drhodt_b; }; };
struct ImageWeight         { static constexpr FieldInfo info{"volumeFactor", "1"};                      template<int dim> struct At { double w; }; };
/// 0 in the fluid and its periodic images, 1 + wall in a ghost (of the wall that it was mirrored in last, behind which it lies).
struct GhostWall           { static constexpr FieldInfo info{"ghostWall", "1", Image::placed};                  template<int dim> struct At { double wall; }; };
// clang-format on

template<class... F> struct Fields
{
    static constexpr int count = sizeof...(F);
};

template<class F, int dim> using At = typename F::template At<dim>;
/// The one value that a field's At holds.
constexpr auto unwrap(auto named)
{
    auto [value] = named;
    return value;
}
template<class F, int dim> using FieldValue = decltype(unwrap(At<F, dim>{}));
template<class F, int dim> constexpr int fieldComponents = components<FieldValue<F, dim>>;

/// `Values<Fields<Density, Pressure>, dim>` has the members rho and p and no other: reading a field that was not declared does not
/// compile.
template<class List, int dim> struct Values;
template<class... F, int dim> struct Values<Fields<F...>, dim> : At<F, dim>...
{};

/// Number of components of these values.
template<class V> constexpr int valueComponents = 0;
template<class... F, int dim> constexpr int valueComponents<Values<Fields<F...>, dim>> = (fieldComponents<F, dim> + ... + 0);

}
