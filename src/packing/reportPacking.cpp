#include "case/replaceCloud.hpp"
#include "geometry/components.hpp"
#include "geometry/crevice.hpp"
#include "packing/Packing.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
void row(std::string& to, const char* name, const KernelResidual::Moments& m)
{
    to += fmt::format("    {:<22} {:>9} {:>+11.5f} {:>10.5f} {:>10.5f} {:>10.5f}\n", name, m.particles, m.mean, m.rms, m.max, m.scatter);
}

std::string residuals(const PackingPlan& plan, const RelaxationResult& r)
{
    std::string s = "Kernel residual sum_j V_j W_ij - 1, images included\n";
    s += fmt::format("    {:<22} {:>9} {:>11} {:>10} {:>10} {:>10}\n", "", "particles", "mean", "rms", "max", "scatter");
    const bool hasMoved = r.steps > 0;
    row(s, hasMoved ? "before, all" : "all", r.before.overall);
    row(s, hasMoved ? "before, within H" : "within H of walls", r.before.nearWalls);
    if (hasMoved)
    {
        row(s, "after, all", r.after.overall);
        row(s, "after, within H", r.after.nearWalls);
    }
    if (plan.relaxation)
        s += fmt::format("Relaxation: {} steps, last shift {:.2g} spacings, centre of mass moved {:.2g} spacings, closest pair {:.3f} "
                         "spacings, {} particles held back by walls\n",
                         r.steps, r.largestShift, r.centreOfMassDrift, r.closestPair / plan.lattice.spacing, r.heldBack);
    return s;
}

/// The bed as its hydrodynamics is quoted: solid fraction, and the Bond number rho g L^2/gamma on the period and on the radius.
std::string bed(const PackingPlan& plan, const Packing& packing)
{
    double largest = 0;
    for (const auto& ball : packing.balls) largest = std::max(largest, ball.radius);
    std::string s = fmt::format("Bed: {} {} a cell, largest radius {:g} m, solid fraction {:.6g}\n", packing.balls.size(),
                                plan.geometry.dimension == 3 ? "spheres" : "circles", largest, 1 - packing.porosity);
    if (plan.bondPerArea > 0)
    {
        s += fmt::format("     Bond number rho g R^2/gamma {:.4g}", plan.bondPerArea * largest * largest);
        if (plan.bedPeriod > 0)
            s += fmt::format(", rho g L^2/gamma {:.4g} with the period L = {:g} m", plan.bondPerArea * plan.bedPeriod * plan.bedPeriod,
                             plan.bedPeriod);
        s += "\n";
    }
    return s;
}
}

void warnOfCrowd(const PackingPlan& plan, const Packing& packing, Diagnostics& diagnostics)
{
    const auto& [particles, residual, at] = packing.crowd;
    if (particles == 0 || plan.lattice.jitter > 0) return;
    diagnostics.warning(
        plan.spacingAt,
        fmt::format(
            "{} of {} particles are packed denser than at rest by more than {:g} %, by {:.0f} % at ({:.4g} {:.4g} {:.4g}), and will push one "
            "another apart: the walls there leave no room for a whole number of spacings of {:g} m. {}",
            particles, packing.points.size(), 100 * crowdedFrom, 100 * residual, at.x, at.y, at.z, plan.lattice.spacing,
            plan.relaxation
                ? "Choose a finer spacing, or more steps of `relax`"
                : "Relax the packing (`relax { steps 200; }` in system/packParticlesDict), or choose a spacing that divides the gap"));
}

std::string report(const PackingPlan& plan, const Packing& packing)
{
    const auto& g = plan.geometry;
    const bool isFlat = g.dimension == 2;
    const double spacing = plan.lattice.spacing;
    std::string s =
        fmt::format("Lattice: {}, spacing {:g} m, support {:g} m ({}), layers", plan.lattice.type, spacing, plan.support, plan.kernel);
    for (int k = 0; k < g.dimension; ++k) s += fmt::format("{} {}", k ? " x" : "", packing.layers[k]);
    s += "\n         fitted spacing";
    for (int k = 0; k < g.dimension; ++k)
        s += fmt::format(" {} {:g} m ({:+.3f} %)", coordinateNames[k], packing.fittedSpacing.*component(k),
                         100 * (packing.fittedSpacing.*component(k) / spacing - 1));
    s +=
        fmt::format("\nFluid volume: {:.10g} {} ({}), porosity {:.6g}\n", packing.volume.value, isFlat ? "m^2" : "m^3",
                    packing.volume.exact ? "exact" : fmt::format("quadrature, error about {:.1g}", packing.volume.error), packing.porosity);
    const double ratio = packing.particleVolume / std::pow(spacing, g.dimension);
    s += fmt::format("Particle volume: {:.10g} {} ({:.5f} spacing^{})\n", packing.particleVolume, isFlat ? "m^2" : "m^3", ratio,
                     g.dimension);
    if (packing.inCrevices)
        s += fmt::format(
            "Crevices narrower than {:g} spacings: {:.3g} % of the fluid's volume, {} places; no particle fits in, and the others have that volume\n",
            narrowestCrevice, 100 * packing.shareOfCrevices, packing.inCrevices);
    if (const auto& sealed = packing.relaxation.sealed; sealed.added + sealed.takenOut)
        s += fmt::format(
            "Sealed pockets: {} that see no others through fluid; {} particles were put into such and {} taken out, until each was as dense as the rest to {:g} % or one particle\n",
            sealed.pockets, sealed.added, sealed.takenOut, 100 * pocketsDiffer);
    if (std::fabs(ratio - 1) > 0.1) s += "         far from 1: the spacing does not resolve the gaps between the walls\n";
    if (!packing.balls.empty()) s += bed(plan, packing);
    s += residuals(plan, packing.relaxation);

    s += fmt::format("Particles: {}", packing.points.size());
    if (packing.leftEmpty) s += fmt::format(", {} places left empty", packing.leftEmpty);
    s += "\n";
    for (std::size_t k = 0; k < plan.phases.size(); ++k)
        s += fmt::format("    {:<12} {:>10} particles, mass {:.10g} {}\n", plan.phases[k].name, packing.phases[k].particles,
                         packing.phases[k].mass, isFlat ? "kg/m" : "kg");
    if (plan.saturation)
        s += fmt::format("Saturation of {}: asked {:g}, reached {:.8g} ({})\n", plan.phases[plan.saturation->phase].name,
                         plan.saturation->value, packing.saturation, plan.saturation->placement);
    return s;
}

void writePacking(const Case& c, const std::string& time, const PackingPlan& plan, const Packing& packing, const WriteOptions& options)
{
    const bool isFlat = plan.geometry.dimension == 2;
    const auto& x = packing.points;
    const auto& U = packing.velocity;
    auto p = packing.p;
    p.resize(x.size());
    const FieldView positions{"positions", FieldClass::vector, {x.x.data(), x.y.data(), isFlat ? nullptr : x.z.data()}};
    std::vector<FieldView> fields{{"U", FieldClass::vector, {U.x.data(), U.y.data(), isFlat ? nullptr : U.z.data()}},
                                  {"p", FieldClass::scalar, {p.data()}},
                                  {"m", FieldClass::scalar, {packing.mass.data()}},
                                  {"phase", FieldClass::label, {packing.phase.data()}}};
    const std::vector<double> V(packing.p.empty() ? 0 : x.size(), packing.particleVolume);
    if (packing.p.empty()) fields.push_back({"rho", FieldClass::scalar, {packing.rho.data()}});
    else fields.push_back({"V", FieldClass::scalar, {V.data()}});
    replaceCloud(c.folder(), time, "sph", x.size(), positions, fields, options);

    const auto &low = plan.geometry.low, &high = plan.geometry.high;
    const double half = 0.5 * plan.lattice.spacing;
    writeBoundingMesh(c.folder(), {low.x, low.y, isFlat ? -half : low.z}, {high.x, high.y, isFlat ? half : high.z});
}

}
