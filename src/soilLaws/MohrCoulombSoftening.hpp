/// Softening of Mohr and Coulomb's soil (MohrCoulomb.hpp) by plastic strain, as an option of it:
///
///   c, phi, psi = linear between the rows of a table by kappa, constant beyond its last;    dkappa/dt = sqrt(2 e_p:e_p),  e_p = dev D_p
///   lambda':  n.(C:(D - D_p)) + (dn/dkappa . s - dk/dkappa) dkappa/dt = 0    of each plane that the stress stays on
///
/// kappa [1] is the angle of a plastic simple shear. The multipliers and the softening that they bring are found together, by secants. Soil that softens
/// faster than its elastic stress gives way has no solution, and its step is not resolved. Two rows are the linear softening from a peak to a residual strength.
///
/// | soil | kappa | c | phi |
/// |---|---|---|---|
/// | London Clay, weathered (Potts, Kovacevic & Vaughan 1997) | 0.05, 0.2 | 7, 2 kPa | 20, 13 |
///
/// Softening has no length of its own: shear bands are as wide as the resolution, and so is the work that they take. Verified by
/// test/unit/soilLaws and test/unit/elementTests (drained triaxial test in closed form, steps of any size).
#pragma once
#include "soilLaws/MohrCoulomb.hpp"
#include <vector>

namespace sph
{

namespace entry::mohrCoulombSoftening
{
inline const SubDictionary option{"softening", notGiven, "strength by plastic shear strain, from the peak to the residual"};
inline const ListOf<double> strain{"plasticShearStrain", required, "kappa of the rows, from 0 on"},
    cohesion{"cohesion", units::pressure, byScene("that of the law"), "c of each row"},
    phi{"frictionAngle", degrees, byScene("that of the law"), "phi of each row"},
    psi{"dilatancyAngle", degrees, byScene("that of the law"), "psi of each row"};
/// The entry of the soil at the start.
inline const Scalar start{"softeningStrain", units::none, 0, nonNegative, "kappa where no field gives it, with a law that softens"};
}

/// kappa: the plastic shear strain that has softened the soil.
struct SofteningStrain
{
    double kappa = 0;
    static constexpr std::array<StateVariable, 1> names{{{"softeningStrain", "1"}}};
    static constexpr auto parts(auto& q, const auto& f) { return f(q.kappa); }
    constexpr SofteningStrain& operator+=(SofteningStrain b)
    {
        kappa += b.kappa;
        return *this;
    }
    friend constexpr SofteningStrain operator*(double s, SofteningStrain a) { return {s * a.kappa}; }
};
constexpr SofteningStrain rotated(SofteningStrain a, Tensor<3>) { return a; }
constexpr SofteningStrain turning(SofteningStrain, Tensor<3>) { return {}; }

struct MohrCoulombSoftening
{
    using Option = MohrCoulomb; ///< the law that it is an option of, whose word it answers to
    static constexpr auto name = MohrCoulomb::name, meaning = MohrCoulomb::meaning;
    static constexpr bool tensionless = false;
    using Variables = SofteningStrain;
    using State = SoilState<SofteningStrain>;
    ElasticLaw elastic;
    double cutOff = std::numeric_limits<double>::infinity(); ///< of the cut-off [Pa]
    /// A row of the table; angles in degrees.
    struct Row
    {
        double kappa, phi, psi, cohesion;
    };
    std::vector<Row> rows{Row{0, 30, 0, 0}}; ///< at least one

    MohrCoulombStrength strengthAt(double kappa) const { return strengthOf(rowAt(kappa).first); }

    State rate(const State& s, SymmTensor<3> D) const
    {
        const auto trial = elastic.rate(s.stress, D);
        if (!yields(s)) return {trial, {}};
        const double kappa = s.variables.kappa, near = width(s.stress);
        const auto [row, slope] = rowAt(kappa);
        const auto strength = strengthOf(row);
        const PrincipalRate at(s.stress, trial, near);
        // The rate at which each plane passes over the stress, per kappa, is a small difference along the table's own line.
        const auto all = strength.planes(elastic);
        const auto there = strengthOf({0, row.phi + difference * slope.phi, row.psi, row.cohesion + difference * slope.cohesion}),
                   back = strengthOf({0, row.phi - difference * slope.phi, row.psi, row.cohesion - difference * slope.cohesion});
        const auto above = there.planes(elastic), below = back.planes(elastic);
        YieldPlanes on;
        std::array<double, YieldPlanes::most> passes{};
        for (std::size_t i = 0; i < all.count; ++i)
        {
            const auto beyond = [&](const YieldPlanes& planes) { return dot(planes.planes[i].n, at.stress) - planes.planes[i].k; };
            if (beyond(all) < -near) continue;
            passes[on.count] = (beyond(above) - beyond(below)) / (2 * difference);
            on.push_back(all.planes[i]);
        }
        const auto flowAt = [&](double kappaRate)
        {
            for (std::size_t i = 0; i < on.count; ++i) on.planes[i].k = -passes[i] * kappaRate;
            return flow(on, at.along());
        };
        const double kappaRate = fixedPoint([&](double x) { return shearOf(flowAt(x).strain); });
        return {at.with(flowAt(kappaRate).stress), {kappaRate}};
    }
    State strained(const State& from, SymmTensor<3> strain, const EmbeddedPair&, double tolerance, SubSteps& taken) const
    {
        const double allowed = tolerance * std::fmax(norm(from.stress), smallStress());
        return inReturns(
            from, strain, taken, [&](const State& s, SymmTensor<3> part) { return mapped(s, s.stress + elastic.rate(s.stress, part)); },
            [&](const State& a, const State& b)
            { return norm(a.stress - b.stress) / allowed + std::abs(a.variables.kappa - b.variables.kappa) / tolerance; },
            [&](const State& s) { return returned(s); });
    }
    MohrCoulombSoftening reduced(double F) const
    {
        MohrCoulombSoftening weaker{elastic, cutOff / F, rows};
        constexpr double degree = std::numbers::pi / 180;
        for (auto& row : weaker.rows)
        {
            const auto strength = MohrCoulombStrength::of(row.phi, row.psi, row.cohesion).reduced(F);
            row = {row.kappa, std::asin(strength.sinPhi) / degree, std::asin(strength.sinPsi) / degree, strength.cohesion};
        }
        return weaker;
    }
    double stiffness(const State& = {}) const { return elastic.stiffness(); }
    bool yields(const State& s) const { return excess(s) >= -width(s.stress); }
    bool admits(const State& s) const { return excess(s) <= width(s.stress); }
    /// kappa stays.
    State returned(const State& s) const
    {
        const MohrCoulomb now{elastic, strengthAt(s.variables.kappa)};
        return {now.returned(s.stress), s.variables};
    }
    double beyond(const State& s) const { return norm(returned(s).stress - s.stress); }
    static double variableError(SofteningStrain error, const State&) { return std::abs(error.kappa); }
    static bool apart(const State&) { return false; }
    static SofteningStrain strainedFreely(SofteningStrain q, SymmTensor<3>) { return q; }
    static std::string objection(const State&) { return ""; }

    static constexpr auto& foundBy = MohrCoulomb::foundBy;
    static constexpr auto startWords = "`softeningStrain`";
    static const Parameter& startEntry() { return entry::mohrCoulombSoftening::start; }
    static bool startGiven(const Dictionary&) { return true; }
    static auto readVariables(const Dictionary& d)
    {
        return [kappa = entry::mohrCoulombSoftening::start(d)](SymmTensor<3>) { return SofteningStrain{kappa}; };
    }
    static EntryList variableEntries() { return {entry::mohrCoulombSoftening::start}; }
    /// Beside those of the law.
    static EntryList entries()
    {
        namespace e = entry::mohrCoulombSoftening;
        return {{e::option, {e::strain, e::cohesion, e::phi, e::psi}}};
    }
    static bool given(const Dictionary& d) { return entry::mohrCoulombSoftening::option.given(d); }
    static MohrCoulombSoftening read(const Dictionary& d, const MohrCoulomb& law)
    {
        namespace e = entry::mohrCoulombSoftening;
        const auto own = e::option(d);
        const auto strain = e::strain(own);
        const auto column = [&](const ListOf<double>& list, double ofLaw)
        {
            const auto values = list(own, std::vector<double>(strain.size(), ofLaw));
            if (values.size() == strain.size()) return values;
            list.error(own, fmt::format("{} values for {} of plasticShearStrain: one for each", values.size(), strain.size()));
            return std::vector<double>(strain.size(), ofLaw);
        };
        constexpr double degree = std::numbers::pi / 180;
        const auto c = column(e::cohesion, law.strength.cohesion), phi = column(e::phi, std::asin(law.strength.sinPhi) / degree),
                   psi = column(e::psi, std::asin(law.strength.sinPsi) / degree);
        MohrCoulombSoftening soft{law.elastic, law.strength.cutOff, {}};
        for (std::size_t k = 0; k < strain.size(); ++k)
        {
            if (strain[k] < 0 || (k > 0 && !(strain[k] > strain[k - 1])))
                e::strain.error(own, fmt::format("plasticShearStrain is to grow from row to row, from 0 on: {:.6g} is row {}", strain[k],
                                                 k + 1));
            if (!(c[k] >= 0)) e::cohesion.error(own, fmt::format("cohesion {:.6g} Pa of row {} is negative", c[k], k + 1));
            if (!(phi[k] >= 0 && phi[k] < 90))
                e::phi.error(own, fmt::format("frictionAngle {:.6g} of row {} is not in 0 to 90", phi[k], k + 1));
            if (!(psi[k] >= 0)) e::psi.error(own, fmt::format("dilatancyAngle {:.6g} of row {} is negative", psi[k], k + 1));
            if (psi[k] > phi[k]) e::psi.error(own, fmt::format("row {}: {}", k + 1, MohrCoulomb::aboveFriction(psi[k], phi[k])));
            soft.rows.push_back({strain[k], phi[k], psi[k], c[k]});
        }
        if (strain.empty())
        {
            e::strain.error(own, "the table is empty: give at least one row");
            soft.rows = MohrCoulombSoftening{}.rows;
        }
        return soft;
    }

private:
    static constexpr double difference = 1e-4;
    double smallStress() const { return smallStrain * elastic.stiffness(); }
    double width(SymmTensor<3> sigma) const { return 1e-9 * (norm(sigma) + rows.front().cohesion + smallStress()); }
    double excess(const State& s) const { return MohrCoulomb::excess(strengthAt(s.variables.kappa), elastic, s.stress); }
    MohrCoulombStrength strengthOf(const Row& row) const
    {
        auto strength = MohrCoulombStrength::of(row.phi, row.psi, row.cohesion);
        strength.cutOff = cutOff;
        return strength;
    }
    /// The row at kappa, and its slopes.
    std::pair<Row, Row> rowAt(double kappa) const
    {
        if (kappa < rows.front().kappa || rows.size() == 1) return {rows.front(), {}};
        const auto next = std::ranges::find_if(rows, [&](const Row& row) { return row.kappa > kappa; });
        if (next == rows.end()) return {rows.back(), {}};
        const auto &a = *(next - 1), &b = *next;
        const double width = b.kappa - a.kappa, share = (kappa - a.kappa) / width;
        const Row slope{1, (b.phi - a.phi) / width, (b.psi - a.psi) / width, (b.cohesion - a.cohesion) / width};
        return {{kappa, a.phi + share * (b.phi - a.phi), a.psi + share * (b.psi - a.psi), a.cohesion + share * (b.cohesion - a.cohesion)},
                slope};
    }
    /// The end of an elastic trial stress, and whether the strain was plastic; none where there is none.
    std::optional<std::pair<State, bool>> mapped(const State& from, SymmTensor<3> trial) const
    {
        const auto at = principalAxes(trial);
        const auto flowAt = [&](double growth) { return flow(strengthAt(from.variables.kappa + growth).planes(elastic), at.values); };
        const double growth = fixedPoint([&](double x) { return shearOf(flowAt(x).strain); });
        if (std::isnan(growth)) return {};
        const auto end = flowAt(growth);
        if (growth == 0 && dot(end.strain, end.strain) == 0) return std::pair(State(trial, from.variables), false);
        return std::pair(State(inAxes(end.stress, at.axes), {from.variables.kappa + growth}), true);
    }
    /// x = g(x) from 0 up, by secants, exact after one where g is linear; not a number where there is none.
    static double fixedPoint(const auto& g)
    {
        constexpr double exact = 1e-14;
        constexpr int most = 50;
        double x = 0, off = g(0);
        if (off == 0) return 0;
        double next = off;
        const double scale = off;
        for (int k = 0; k < most; ++k)
        {
            const double offNext = g(next) - next;
            if (std::abs(offNext) <= exact * std::fmax(scale, next)) return next;
            const double slope = (offNext - off) / (next - x);
            x = next;
            off = offNext;
            next = x - off / slope;
            if (!(next > 0)) break;
        }
        return std::numeric_limits<double>::quiet_NaN();
    }
};

}
