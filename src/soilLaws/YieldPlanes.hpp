/// Plastic flow on a yield surface of planes in the space of the principal stresses, by Koiter's rule (1953): each plane i that is active
/// adds lambda_i m_i to the plastic strain,
///
///   n_i . s <= k_i,    s = s_trial - sum_i lambda_i a_i,    a_i = C m_i = 2 G m_i + (K - 2 G/3) (m_i . 1) 1
///   lambda_i >= 0,     lambda_i (n_i . s - k_i) = 0
///
/// s [Pa] principal stresses, the largest first, k_i [Pa], m_i [1] flow directions, lambda_i [1]. Isotropy leaves the axes of the trial stress, so that this is the
/// return map of backward Euler without error: to a face, an edge or an apex, which is the point of three planes (de Souza Neto, Peric & Owen 2008,
/// Computational Methods for Plasticity, section 8.2; Clausen, Damkilde & Andersen 2006, Eng. Comput. 23:365). With rates in place of the
/// stresses and k_i = 0 of those planes that the stress is on, the same equations give the rate of the stress.
///
/// Sets of planes are tried by their number, until one has positive multipliers and leaves no plane violated. Verified by
/// test/unit/soilLaws (face, edges, apex, cut-off by hand, and Koiter's conditions of random states).
#pragma once
#include "soilLaws/ElasticLaw.hpp"
#include "soilLaws/PrincipalAxes.hpp"
#include <span>

namespace sph
{

using Principal = std::array<double, 3>;
constexpr double dot(const Principal& a, const Principal& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
constexpr void add(Principal& a, double factor, const Principal& b)
{
    for (std::size_t c = 0; c < 3; ++c) a[c] += factor * b[c];
}
inline double norm(const Principal& a) { return std::sqrt(dot(a, a)); }

struct YieldPlane
{
    Principal n, m, a; ///< outward, of the flow, and of the stress that the flow takes
    double k;          ///< [Pa]

    static constexpr YieldPlane of(const ElasticLaw& elastic, Principal n, Principal m, double k)
    {
        const double volume = (elastic.K - 2 * elastic.G / 3) * (m[0] + m[1] + m[2]), G2 = 2 * elastic.G;
        return {n, m, {G2 * m[0] + volume, G2 * m[1] + volume, G2 * m[2] + volume}, k};
    }
};

/// The planes that may be active of stresses that are sorted.
struct YieldPlanes
{
    static constexpr std::size_t most = 6;
    std::array<YieldPlane, most> planes{};
    std::size_t count = 0;
    void push_back(const YieldPlane& plane) { planes[count++] = plane; }
    auto begin() const { return planes.begin(); }
    auto end() const { return planes.begin() + std::ptrdiff_t(count); }
};

struct PlasticFlow
{
    Principal stress{}, strain{}; ///< at the end or its rate; the plastic part of the strain
};

/// Solves the equations above; a stress that is not finite where no set of planes does.
inline PlasticFlow flow(const YieldPlanes& planes, const Principal& trial)
{
    double size = norm(trial);
    for (const auto& plane : planes) size = std::fmax(size, std::abs(plane.k));
    constexpr double ofRounding = 1e-13;
    const double allowed = ofRounding * size;
    const auto excess = [](const YieldPlane& plane, const Principal& s) { return dot(plane.n, s) - plane.k; };
    const auto holds = [&](const Principal& s)
    { return std::ranges::all_of(planes, [&](const YieldPlane& plane) { return excess(plane, s) <= allowed; }); };
    if (holds(trial)) return {trial, {}};
    /// The set by its planes and multipliers, where that is the solution.
    const auto by = [&](std::initializer_list<std::pair<const YieldPlane*, double>> set)
    {
        std::optional<PlasticFlow> end;
        for (const auto& [plane, lambda] : set)
            if (!(lambda >= 0)) return end;
        end = PlasticFlow{trial, {}};
        for (const auto& [plane, lambda] : set)
        {
            add(end->stress, -lambda, plane->a);
            add(end->strain, lambda, plane->m);
        }
        if (!holds(end->stress)) end.reset();
        return end;
    };
    for (const auto& p : planes)
        if (const auto end = by({{&p, excess(p, trial) / dot(p.n, p.a)}})) return *end;
    constexpr double singular = 1e-12;
    for (auto p = planes.begin(); p != planes.end(); ++p)
        for (auto q = p + 1; q != planes.end(); ++q)
        {
            const double pp = dot(p->n, p->a), pq = dot(p->n, q->a), qp = dot(q->n, p->a), qq = dot(q->n, q->a), d = pp * qq - pq * qp;
            if (!(std::abs(d) > singular * std::abs(pp * qq))) continue;
            const double f = excess(*p, trial), g = excess(*q, trial);
            if (const auto end = by({{&*p, (qq * f - pq * g) / d}, {&*q, (pp * g - qp * f) / d}})) return *end;
        }
    for (auto p = planes.begin(); p != planes.end(); ++p)
        for (auto q = p + 1; q != planes.end(); ++q)
            for (auto r = q + 1; r != planes.end(); ++r)
            {
                const Tensor<3> A{dot(p->n, p->a), dot(p->n, q->a), dot(p->n, r->a), dot(q->n, p->a), dot(q->n, q->a),
                                  dot(q->n, r->a), dot(r->n, p->a), dot(r->n, q->a), dot(r->n, r->a)};
                if (!(std::abs(determinant(A)) > singular * std::abs(A.xx * A.yy * A.zz))) continue;
                const auto lambda = inverse(A) * Vector<3>{excess(*p, trial), excess(*q, trial), excess(*r, trial)};
                if (const auto end = by({{&*p, lambda.x}, {&*q, lambda.y}, {&*r, lambda.z}})) return *end;
            }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {{none, none, none}, {}};
}

/// sqrt(2 dev e:dev e) of a strain by its principal values: the angle gamma of a simple shear.
inline double shearOf(const Principal& e)
{
    const double mean = (e[0] + e[1] + e[2]) / 3;
    return std::sqrt(2 * (sqr(e[0] - mean) + sqr(e[1] - mean) + sqr(e[2] - mean)));
}

}
