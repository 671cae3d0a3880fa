/// Elastic, perfectly plastic soil with the criterion of Mohr and Coulomb (1776), and a cut-off of tension:
///
///   (s_1 - s_3)/2 + (s_1 + s_3)/2 sin(phi) <= c cos(phi),    s_1 <= T
///   sigma^ = C:(D - D_p),   D_p = sum lambda' m along the principal axes,   m = ( (1 + sin(psi))/2, 0, -(1 - sin(psi))/2 ) of the face,
///   along s_1 of the cut-off
///
/// sigma^ [Pa/s] Jaumann rate, D [1/s] strain rate, s_1 >= s_2 >= s_3 [Pa] principal stresses, tension positive, phi, psi friction and
/// dilatancy angle, c [Pa] cohesion, T [Pa] tensile strength, at most that of the apex, c cot(phi), C of ElasticLaw. Where two principal stresses are equal
/// two faces meet, where all are three, and each adds its flow (YieldPlanes.hpp). At the apex soil is pulled apart at a constant stress, whatever psi.
///
///   triaxial compression:  s_3 = N s_1 - 2 c sqrt(N),    extension: s_1 = N s_3 + 2 c sqrt(N) with the axial s_1,    N = (1 + sin(phi))/(1 - sin(phi))
///
/// A step's end is the return of its elastic trial stress to the faces, edges or apex. That has no error while the principal axes do not turn; where the
/// strain turns them the step is compared with two of half its size, and is taken in substeps, second order in their size.
///
/// | soil | E | nu | phi | psi | c |
/// |---|---|---|---|---|---|
/// | London Clay, weathered, at the peak (Potts, Kovacevic & Vaughan 1997, Geotechnique 47:953; E of their 25 (p' + 100 kPa) at 100 kPa) | 5 MPa | 0.2 | 20 | 0 | 7 kPa |
/// | Hostun sand, dense (Schanz & Vermeer 1998, Geotechnique 48:383; E_50 at 100 kPa) | 37 MPa | 0.2 | 41 | 14 | 0 |
///
/// Verified by test/unit/soilLaws (face, edges, apex, rates, turning axes) and test/unit/elementTests (strength in triaxial compression and
/// extension, plane strain, simple shear).
#pragma once
#include "soilLaws/YieldPlanes.hpp"
#include <fmt/format.h>
#include <numbers>

namespace sph
{

namespace entry::mohrCoulomb
{
inline const Scalar phi{"frictionAngle", degrees, required, Range{0, 90, true, false}, "phi"},
    psi{"dilatancyAngle", degrees, byScene("0"), Range{0, 90, true, false}, "psi, at most phi; equal to it: the associated flow rule"},
    cohesion{"cohesion", units::pressure, 0, nonNegative, "c"},
    tensileStrength{"tensileStrength", units::pressure, byScene("of the apex, c cot(phi)"), nonNegative, "largest principal stress"};
}

/// phi, psi and c as the law computes with them.
struct MohrCoulombStrength
{
    double sinPhi = 0, sinPsi = 0, cohesion = 0;             ///< [1], [1], [Pa]
    double cutOff = std::numeric_limits<double>::infinity(); ///< T, the apex apart [Pa]

    static MohrCoulombStrength of(double phi, double psi, double cohesion)
    {
        constexpr double degree = std::numbers::pi / 180;
        return {std::sin(phi * degree), std::sin(psi * degree), cohesion};
    }
    double cosPhi() const { return std::sqrt(1 - sinPhi * sinPhi); }
    /// c, tan(phi) and T over F; psi stays, up to phi.
    MohrCoulombStrength reduced(double F) const
    {
        const double reducedSine = reducedSinPhi(sinPhi, F);
        return {reducedSine, std::fmin(sinPsi, reducedSine), cohesion / F, cutOff / F};
    }
    /// The tensile strength [Pa], infinite where there is neither friction nor a cut-off.
    double largestTension() const { return std::fmin(cutOff, sinPhi > 0 ? cohesion * cosPhi() / sinPhi : cutOff); }

    /// The planes that the law's sorted principal stresses may be on.
    YieldPlanes planes(const ElasticLaw& elastic) const
    {
        const double up = 0.5 * (1 + sinPhi), down = -0.5 * (1 - sinPhi), flowUp = 0.5 * (1 + sinPsi), flowDown = -0.5 * (1 - sinPsi);
        YieldPlanes all;
        for (const auto& [i, j] : {std::array<std::size_t, 2>{0, 2}, {1, 2}, {0, 1}})
        {
            Principal n{}, m{};
            n[i] = up, n[j] = down, m[i] = flowUp, m[j] = flowDown;
            all.push_back(YieldPlane::of(elastic, n, m, cohesion * cosPhi()));
        }
        if (const double T = largestTension(); std::isfinite(T))
            for (std::size_t i = 0; i < 3; ++i)
            {
                Principal n{};
                n[i] = 1;
                all.push_back(YieldPlane::of(elastic, n, n, T));
            }
        return all;
    }
};

/// A stress in its axes, and a rate of it there. Where principal stresses are equal, within `width` [Pa], their axes are those of the rate,
/// along which the stress leaves, the largest first.
struct PrincipalRate
{
    Principal stress;
    Tensor<3> axes;
    SymmTensor<3> rate; ///< in these axes

    PrincipalRate(SymmTensor<3> sigma, SymmTensor<3> change, double width)
    {
        const auto at = principalAxes(sigma);
        stress = at.values;
        axes = at.axes;
        rate = rotated(change, transpose(axes));
        const bool first = stress[0] - stress[1] <= width, last = stress[1] - stress[2] <= width;
        Tensor<3> turn{1, 0, 0, 0, 1, 0, 0, 0, 1};
        if (first && last) turn = principalAxes(rate).axes;
        else if (first || last)
        {
            const double angle =
                first ? 0.5 * std::atan2(2 * rate.xy, rate.xx - rate.yy) : 0.5 * std::atan2(2 * rate.yz, rate.yy - rate.zz);
            const double c = std::cos(angle), s = std::sin(angle);
            if (first) turn = {c, -s, 0, s, c, 0, 0, 0, 1};
            else turn = {1, 0, 0, 0, c, -s, 0, s, c};
        }
        else return;
        axes = axes * turn;
        rate = rotated(rate, transpose(turn));
    }
    Principal along() const { return {rate.xx, rate.yy, rate.zz}; }
    /// The rate with other values along the axes, in the axes of space.
    SymmTensor<3> with(const Principal& values) const
    {
        return rotated(SymmTensor<3>{values[0], rate.xy, rate.xz, values[1], rate.yz, values[2]}, axes);
    }
};

/// A strain at a constant rate by a return map `mapped(state, strain)`, which is of first order where the principal axes turn or the
/// surface changes: a step is compared with two halves, and extrapolated from both. `error(a, b)`: difference over what is tolerated.
template<class State>
State inReturns(State now, SymmTensor<3> strain, SubSteps& taken, const auto& mapped, const auto& error, const auto& putBack)
{
    constexpr double shortest = 1e-14, safety = 0.9, mostGrowth = 5, leastGrowth = 0.2, none = 1e-6;
    constexpr int most = 100000;
    for (double t = 0, h = 1; t < 1;)
    {
        if (h < shortest || taken.accepted + taken.rejected >= most)
        {
            taken.resolved = false;
            break;
        }
        const bool last = h >= 1 - t;
        if (last) h = 1 - t;
        const auto whole = mapped(now, h * strain);
        if (whole && !whole->second)
        {
            now = whole->first; // elastic: the surface is convex, and the path straight
            if (last) break;
            t += h;
            continue;
        }
        const auto first = mapped(now, 0.5 * h * strain), second = first ? mapped(first->first, 0.5 * h * strain) : first;
        const double off = whole && second ? error(whole->first, second->first) : std::numeric_limits<double>::infinity();
        if (off <= 1)
        {
            ++taken.accepted;
            now = second->first;
            if (off > none)
            {
                now = 2 * now;
                now += -1.0 * whole->first;
                now = putBack(now);
            }
            if (last) break;
            t += h;
            h *= std::fmin(mostGrowth, safety / std::sqrt(std::fmax(off, none)));
        }
        else
        {
            ++taken.rejected;
            h *= std::fmax(leastGrowth, safety / std::sqrt(off));
        }
    }
    return now;
}

struct MohrCoulomb
{
    static constexpr auto name = "mohrCoulomb", meaning = "elastic and perfectly plastic, Mohr and Coulomb, with softening as an option";
    static constexpr bool tensionless = false;
    ElasticLaw elastic;
    MohrCoulombStrength strength;

    static MohrCoulomb of(ElasticLaw elastic, double phi, double psi, double cohesion)
    {
        return {elastic, MohrCoulombStrength::of(phi, psi, cohesion)};
    }

    SymmTensor<3> rate(SymmTensor<3> sigma, SymmTensor<3> D) const
    {
        const auto trial = elastic.rate(sigma, D);
        if (!yields(sigma)) return trial;
        const PrincipalRate at(sigma, trial, width(sigma));
        return at.with(flow(active(strength.planes(elastic), at.stress, width(sigma)), at.along()).stress);
    }
    SymmTensor<3> strained(SymmTensor<3> sigma, SymmTensor<3> strain, const EmbeddedPair&, double tolerance, SubSteps& taken) const
    {
        const double allowed = tolerance * std::fmax(norm(sigma), smallStress());
        return inReturns(
            sigma, strain, taken, [&](SymmTensor<3> from, SymmTensor<3> part) { return mapped(from + elastic.rate(from, part)); },
            [&](SymmTensor<3> a, SymmTensor<3> b) { return norm(a - b) / allowed; }, [&](SymmTensor<3> s) { return returned(s); });
    }
    MohrCoulomb reduced(double F) const { return {elastic, strength.reduced(F)}; }
    double stiffness(SymmTensor<3> = {}) const { return elastic.stiffness(); }
    bool yields(SymmTensor<3> sigma) const { return excess(strength, elastic, sigma) >= -width(sigma); }
    bool admits(SymmTensor<3> sigma) const { return excess(strength, elastic, sigma) <= width(sigma); }
    SymmTensor<3> returned(SymmTensor<3> sigma) const { return mapped(sigma)->first; }
    double beyond(SymmTensor<3> sigma) const { return norm(returned(sigma) - sigma); }

    double smallStress() const { return smallStrain * elastic.stiffness(); }
    /// The width of what counts as on the surface, by rounding [Pa].
    double width(SymmTensor<3> sigma) const { return 1e-9 * (norm(sigma) + strength.cohesion + smallStress()); }
    /// How far the stress is beyond the plane that it is furthest beyond [Pa], negative within.
    static double excess(const MohrCoulombStrength& strength, const ElasticLaw& elastic, SymmTensor<3> sigma)
    {
        const auto s = principalAxes(sigma).values;
        double most = -std::numeric_limits<double>::infinity();
        for (const auto& plane : strength.planes(elastic)) most = std::fmax(most, dot(plane.n, s) - plane.k);
        return most;
    }
    /// Those planes that the stress is on, for a rate.
    static YieldPlanes active(const YieldPlanes& all, const Principal& s, double width)
    {
        YieldPlanes on;
        for (auto plane : all)
            if (dot(plane.n, s) - plane.k >= -width)
            {
                plane.k = 0;
                on.push_back(plane);
            }
        return on;
    }

    /// The tests that find each constant.
    static constexpr std::pair<const char*, const char*> foundBy[]{
        {"E", "the start of a triaxial test"},
        {"nu", "the volume strain at the start of a drained triaxial test"},
        {"bulkModulus", "an isotropic test, or the volume strain at the start of a drained triaxial test"},
        {"shearModulus", "the start of a triaxial test"},
        {"frictionAngle", "triaxial tests to failure at two lateral pressures"},
        {"cohesion", "triaxial tests to failure at two lateral pressures"},
        {"dilatancyAngle", "the volume strain of a drained triaxial test at failure"},
        {"tensileStrength", "a test that pulls the soil apart"}};
    static EntryList entries()
    {
        namespace e = entry::mohrCoulomb;
        return ElasticLaw::entries() + EntryList{e::phi, e::psi, e::cohesion, e::tensileStrength};
    }
    static MohrCoulomb read(const Dictionary& d)
    {
        namespace e = entry::mohrCoulomb;
        const auto elastic = ElasticLaw::read(d);
        const double phi = e::phi(d), psi = e::psi(d, 0), c = e::cohesion(d);
        auto law = of(elastic, phi, psi, c);
        if (psi > phi) e::psi.error(d, aboveFriction(psi, phi));
        if (e::phi.given(d) && phi == 0 && c == 0) e::phi.error(d, "frictionAngle and cohesion are both 0: such soil has no strength");
        if (const double apex = law.strength.largestTension(); e::tensileStrength.given(d))
        {
            law.strength.cutOff = e::tensileStrength(d, 0);
            if (law.strength.cutOff > apex)
                e::tensileStrength.error(d, fmt::format("{:.6g} Pa is above the apex, c cot(phi) = {:.6g} Pa: possible are 0 to that",
                                                        law.strength.cutOff, apex));
        }
        return law;
    }
    static std::string aboveFriction(double psi, double phi)
    {
        return fmt::format("dilatancyAngle {:.6g} is above frictionAngle {:.6g}: such soil would make work of nothing", psi, phi);
    }

private:
    /// The return of a trial stress, and whether the strain was plastic.
    std::optional<std::pair<SymmTensor<3>, bool>> mapped(SymmTensor<3> trial) const
    {
        const auto at = principalAxes(trial);
        const auto end = flow(strength.planes(elastic), at.values);
        if (dot(end.strain, end.strain) == 0) return std::pair(trial, false);
        return std::pair(inAxes(end.stress, at.axes), true);
    }
};

}
