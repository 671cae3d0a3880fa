/// Flow on the cone of Drucker and Prager (DruckerPrager.hpp) while the strain rate does not change. The deviator stays in the plane of its
/// start and of the strain rate's deviator e; with r = |s| and the angle theta between the two the law is, over one strain D dt taken from
/// t = 0 to 1,
///
///   dr/dt = a cos(theta) + b,    du/dt = -omega/r,    u = ln tan(theta/2), cos(theta) = -tanh(u)
///   omega = 2 G |e|,    a = omega 9 K alpha_phi alpha_psi/d,    b = -3 sqrt(2) G K alpha_phi tr(D)/d,    d = 9 K alpha_phi alpha_psi + G
///
/// r, a, b, omega [Pa]. Without dilatancy a = 0, and the integral is known: r = r_0 + b t, u = u_0 - omega/b ln(1 + b t/r_0) (Loret &
/// Prevost 1986, Comput. Methods Appl. Mech. Eng. 56, after Krieg & Krieg 1977). Else it is taken by substeps: u and r are not stiff where
/// the stress itself is, beside the vertex, to which r -> 0 leads where a + b < 0. Verified by test/unit/soilLaws against substeps of the
/// law itself.
#pragma once
#include "soilLaws/EmbeddedPair.hpp"
#include <limits>

namespace sph
{

struct OnCone
{
    double u = 0, r = 0; ///< [1], [Pa]; r = 0 is the vertex
    OnCone& operator+=(const OnCone& b)
    {
        u += b.u;
        r += b.r;
        return *this;
    }
    friend OnCone operator*(double s, const OnCone& a) { return {s * a.u, s * a.r}; }
};

struct ConeFlow
{
    double a = 0, b = 0, omega = 0; ///< [Pa]

    OnCone rate(const OnCone& q) const
    {
        if (!(q.r > 0)) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()}; // beyond the vertex
        return {-omega / q.r, b - a * std::tanh(q.u)};
    }
    /// The end of the flow from a place beside the vertex. `allowed` [Pa]: error of a substep.
    OnCone end(OnCone q, const EmbeddedPair& pair, double allowed, SubSteps& taken) const
    {
        if (a == 0)
        {
            const double growth = b / q.r;
            if (!(growth > -1)) return {};
            return {q.u - omega / q.r * (growth == 0 ? 1 : std::log1p(growth) / growth), q.r + b};
        }
        const auto vertex = [&](const OnCone& now) { return a + b < 0 && now.r < 0.1 * allowed; };
        taken = integrate(
            pair, q, 1, [&](double, const OnCone& now) { return rate(now); },
            [&](const OnCone& e, const OnCone& now) { return std::hypot(e.r, now.r * e.u / std::cosh(now.u)) / allowed; },
            [](const OnCone& now) { return now.r > 0; }, [](const OnCone&) { return false; }, vertex);
        return vertex(q) ? OnCone{} : q;
    }
};

}
