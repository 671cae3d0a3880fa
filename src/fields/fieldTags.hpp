/// Field tags: name on disk and in the log, unit, and how an image's value follows from its source's.
///
/// The member template `At` carries the symbol of the papers, so that a term writes i.rho and j.rho; `Real` is the precision that it computes in.
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
struct Position            { static constexpr FieldInfo info{"positions", "m"};                         template<int dim, class Real = double> struct At { Vector<dim, Real> x; }; };
struct Velocity            { static constexpr FieldInfo info{"U", "m/s", Image::ruled, nullptr, "U"};            template<int dim, class Real = double> struct At { Vector<dim, Real> v; }; };
struct Mass                { static constexpr FieldInfo info{"m", "kg"};                                template<int dim, class Real = double> struct At { Real m; }; };
struct DynamicViscosity    { static constexpr FieldInfo info{"mu", "Pa s"};                             template<int dim, class Real = double> struct At { Real mu; }; };
struct Phase               { static constexpr FieldInfo info{"phase", "1"};                             template<int dim, class Real = double> struct At { LabelOf<Real> phase; }; };
struct Density             { static constexpr FieldInfo info{"rho", "kg/m^3"};                          template<int dim, class Real = double> struct At { Real rho; }; };
struct Volume              { static constexpr FieldInfo info{"V", "m^3"};                               template<int dim, class Real = double> struct At { Real V; }; };
struct Pressure            { static constexpr FieldInfo info{"p", "Pa", Image::ruled, nullptr, "p", InLayers::extrapolated};            template<int dim, class Real = double> struct At { Real p; }; };
struct KernelMoment        { static constexpr FieldInfo info{"M", "1/m^3"};                             template<int dim, class Real = double> struct At { Real M; }; };
struct GradientScale       { static constexpr FieldInfo info{"gradientScale", "1"};                      template<int dim, class Real = double> struct At { Real N; }; };
struct Stress              { static constexpr FieldInfo info{"S", "Pa", Image::mirrored, "solidStress"}; template<int dim, class Real = double> struct At { SymmTensor<dim, Real> S; }; };
struct SolidStress         { static constexpr FieldInfo info{"solidStress", "Pa", Image::mirrored};             template<int dim, class Real = double> struct At { SymmTensor<dim, Real> S_s; }; };
struct WallNormal          { static constexpr FieldInfo info{"wallNormal", "1"};                        template<int dim, class Real = double> struct At { Vector<dim, Real> n_w; }; };
struct WallCosine          { static constexpr FieldInfo info{"wallCosine", "1"};                        template<int dim, class Real = double> struct At { Real cosTheta; }; };
struct SmoothedColour      { static constexpr FieldInfo info{"colour", "1"};                            template<int dim, class Real = double> struct At { Real colour; }; };
struct ColourGradient      { static constexpr FieldInfo info{"gradC", "1/m", Image::interface};         template<int dim, class Real = double> struct At { Vector<dim, Real> gradC; }; };
struct RawCurvature        { static constexpr FieldInfo info{"rawKappa", "1/m"};                        template<int dim, class Real = double> struct At { Real rawKappa; }; };
struct Curvature           { static constexpr FieldInfo info{"kappa", "1/m"};                           template<int dim, class Real = double> struct At { Real kappa; }; };
struct Acceleration        { static constexpr FieldInfo info{"dUdt", "m/s^2", Image::mirrored};         template<int dim, class Real = double> struct At { Vector<dim, Real> dvdt; }; };
struct SlowAcceleration    { static constexpr FieldInfo info{"dUdtSlow", "m/s^2", Image::mirrored};     template<int dim, class Real = double> struct At { Vector<dim, Real> a_s; }; };
struct PressureAcceleration{ static constexpr FieldInfo info{"dUdtByPressure", "m/s^2", Image::mirrored}; template<int dim, class Real = double> struct At { Vector<dim, Real> a_p; }; };
struct WallAcceleration    { static constexpr FieldInfo info{"dUdtAtWall", "m/s^2", Image::mirrored};   template<int dim, class Real = double> struct At { Vector<dim, Real> a_w; }; };
struct DensityRate         { static constexpr FieldInfo info{"drhodt", "kg/(m^3 s)"};                   template<int dim, class Real = double> struct At { Real drhodt; }; };
struct ShiftDirection      { static constexpr FieldInfo info{"shift", "1/m", Image::mirrored};          template<int dim, class Real = double> struct At { Vector<dim, Real> shift; }; };
struct TransportVelocity   { static constexpr FieldInfo info{"dUTransport", "m/s", Image::mirrored};     template<int dim, class Real = double> struct At { Vector<dim, Real> w; }; };
struct TransportAcceleration{ static constexpr FieldInfo info{"dUdtTransport", "m/s^2", Image::mirrored}; template<int dim, class Real = double> struct At { Vector<dim, Real> a_t; }; };
struct CorrectionTensor    { static constexpr FieldInfo info{"L", "1", Image::mirrored};                template<int dim, class Real = double> struct At { SymmTensor<dim, Real> L; }; };
struct LeastEigenvalue     { static constexpr FieldInfo info{"lambda", "1"};                            template<int dim, class Real = double> struct At { Real lambda; }; };
struct SurfaceNormal       { static constexpr FieldInfo info{"surfaceNormal", "1/m", Image::mirrored};  template<int dim, class Real = double> struct At { Vector<dim, Real> n; }; };
struct ConcentrationSlope  { static constexpr FieldInfo info{"gradConcentration", "1/m", Image::mirrored}; template<int dim, class Real = double> struct At { Vector<dim, Real> gradN; }; };
struct DensityGradient     { static constexpr FieldInfo info{"gradRho", "kg/m^4", Image::mirrored};     template<int dim, class Real = double> struct At { Vector<dim, Real> gradRho; }; };
struct VelocityChange      { static constexpr FieldInfo info{"dU", "m/s", Image::ruledChange, nullptr, "U"};       template<int dim, class Real = double> struct At { Vector<dim, Real> dv; }; };
struct DelayedImpulse      { static constexpr FieldInfo info{"delayedImpulse", "m/s", Image::mirrored};      template<int dim, class Real = double> struct At { Vector<dim, Real> delayed; }; };
struct ViscousResponse     { static constexpr FieldInfo info{"dUdtOfChange", "m/s^2", Image::mirrored}; template<int dim, class Real = double> struct At { Vector<dim, Real> response; }; };
struct StiffResponse       { static constexpr FieldInfo info{"d2Udt2OfChange", "m/s^3", Image::mirrored}; template<int dim, class Real = double> struct At { Vector<dim, Real> response; }; };
struct StiffRate           { static constexpr FieldInfo info{"stiffRate", "1/s^2"};                     template<int dim, class Real = double> struct At { Real kappa; }; };
struct VolumeStiffness     { static constexpr FieldInfo info{"volumeStiffness", "J m^6"};               template<int dim, class Real = double> struct At { Real a; }; };
struct PressureStrength    { static constexpr FieldInfo info{"pressureStrength", "Pa m^6"};              template<int dim, class Real = double> struct At { Real P; }; };
struct Displacement        { static constexpr FieldInfo info{"displacement", "m/s", Image::mirrored};   template<int dim, class Real = double> struct At { Vector<dim, Real> u; }; };
struct CompressionChange   { static constexpr FieldInfo info{"compressionOfChange", "N m^4"};         template<int dim, class Real = double> struct At { Real q; }; };
struct ViscousRate         { static constexpr FieldInfo info{"viscousRate", "1/s"};                     template<int dim, class Real = double> struct At { Real lambda; }; };
struct ViscousGradient     { static constexpr FieldInfo info{"viscousGradient", "1/s", Image::ruledGradient, nullptr, "U"};       template<int dim, class Real = double> struct At { Tensor<dim, Real> G; }; };
struct PowderFraction      { static constexpr FieldInfo info{"phi", "1"};                               template<int dim, class Real = double> struct At { Real phi; }; };
struct PowderRate          { static constexpr FieldInfo info{"dphidt", "1/s"};                          template<int dim, class Real = double> struct At { Real dphidt; }; };
struct ShearRate           { static constexpr FieldInfo info{"gammaDot", "1/s"};                        template<int dim, class Real = double> struct At { Real gammaDot; }; };
struct ShearStress         { static constexpr FieldInfo info{"tau", "Pa"};                              template<int dim, class Real = double> struct At { Real tau; }; };
struct RelativeViscositySlope { static constexpr FieldInfo info{"viscositySlope", "1"};                 template<int dim, class Real = double> struct At { Real slope; }; };
struct Holder              { static constexpr FieldInfo info{"heldBy", "1"};                             template<int dim, class Real = double> struct At { Real holder; };
                             static constexpr double unknown = -1; }; ///< until openings look at the particle; it counts as one that was there
struct HeldPressure        { static constexpr FieldInfo info{"heldPressure", "Pa"};                      template<int dim, class Real = double> struct At { Real p_h; };
                             static constexpr double ofDensity = -1e30; }; ///< of what has the pressure of its density
struct BoundaryShare       { static constexpr FieldInfo info{"boundaryShare", "1", Image::placed};              template<int dim, class Real = double> struct At { Real s_b; }; };
struct BoundaryAcceleration{ static constexpr FieldInfo info{"dUdtByBoundary", "m/s^2", Image::mirrored}; template<int dim, class Real = double> struct At { Vector<dim, Real> a_b; }; };
struct BoundaryDensityRate { static constexpr FieldInfo info{"drhodtByBoundary", "kg/(m^3 s)"};          template<int dim, class Real = double> struct At { Real drhodt_b; }; };
struct ImageWeight         { static constexpr FieldInfo info{"volumeFactor", "1"};                      template<int dim, class Real = double> struct At { Real w; }; };
/// 0 in the fluid and its periodic images, 1 + wall in a ghost (of the wall that it was mirrored in last, behind which it lies).
struct GhostWall           { static constexpr FieldInfo info{"ghostWall", "1", Image::placed};                  template<int dim, class Real = double> struct At { Real wall; }; };
/// Number of a particle's images among those last made (MadeImages::particles), and 1; 0: of none.
struct ImagesMade          { static constexpr FieldInfo info{"imagesMade", "1"};                        template<int dim, class Real = double> struct At { Real number; }; };
// clang-format on

template<class... F> struct Fields
{
    static constexpr int count = sizeof...(F);
};

template<class F, int dim, class Real = double> using At = typename F::template At<dim, Real>;
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
template<class List, int dim, class Real = double> struct Values;
template<class... F, int dim, class Real> struct Values<Fields<F...>, dim, Real> : At<F, dim, Real>...
{};

/// Number of components of these values.
template<class V> constexpr int valueComponents = 0;
template<class... F, int dim, class Real>
constexpr int valueComponents<Values<Fields<F...>, dim, Real>> = (fieldComponents<F, dim> + ... + 0);

}
