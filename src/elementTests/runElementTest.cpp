#include "elementTests/ElementTest.hpp"
#include <Eigen/Dense>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// State and strain together: where stresses are controlled, the strain is part of what is solved for.
template<class Material> struct ElementState
{
    Material soil;
    SymmTensor<3> strain;
    ElementState& operator+=(const ElementState& b)
    {
        soil += b.soil;
        strain += b.strain;
        return *this;
    }
    friend ElementState operator*(double s, const ElementState& a) { return {s * a.soil, s * a.strain}; }
};

/// The strain rates that controls find: rates of their measures as they are to be.
template<ConstitutiveLaw Law> struct Controlled
{
    using Material = StateOf<Law>;
    const Law& law;
    SymmTensor<3> prescribed; ///< D without what is found
    Tensor<3> W;
    const std::vector<StressControl>& controls;
    Eigen::VectorXd rates; ///< of the measures

    SymmTensor<3> D(const Eigen::VectorXd& x) const
    {
        auto D = prescribed;
        for (Eigen::Index k = 0; k < x.size(); ++k) D += x[k] * controls[std::size_t(k)].strain;
        return D;
    }
    Eigen::VectorXd off(const Material& s, const Eigen::VectorXd& x) const
    {
        const Material rate = law.rate(s, D(x));
        const auto whole = rate.stress + turning(s.stress, W);
        Eigen::VectorXd off(x.size());
        for (Eigen::Index k = 0; k < x.size(); ++k) off[k] = doubleDot(controls[std::size_t(k)].measure, whole) - rates[k];
        return off;
    }
    /// Elastic soil of the law's stiffness would do this: the direction is right.
    Eigen::VectorXd guess(const Material& s) const
    {
        Eigen::VectorXd x(rates.size());
        for (Eigen::Index k = 0; k < x.size(); ++k)
        {
            const auto& control = controls[std::size_t(k)];
            x[k] = rates[k] / (law.stiffness(s) * doubleDot(control.measure, control.strain));
        }
        return x;
    }
    /// Two stresses that stay equal along an edge of a yield surface leave the difference of the strains that hold them open: the
    /// smallest of all solutions keeps these equal.
    static Eigen::VectorXd solution(const Eigen::MatrixXd& slope, const Eigen::VectorXd& right)
    {
        constexpr double open = 1e-6; // difference quotients are good to 1e-9
        Eigen::FullPivLU<Eigen::MatrixXd> solver(slope);
        const Eigen::VectorXd pivots = solver.matrixLU().diagonal().cwiseAbs();
        if (pivots.minCoeff() > open * pivots.maxCoeff()) return solver.solve(right);
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least;
        least.setThreshold(open);
        return least.compute(slope).solve(right);
    }
    /// Newton's method, with steps halved until the rates fall: they have kinks where loading turns to unloading.
    std::optional<Eigen::VectorXd> solve(const Material& s, Eigen::VectorXd x) const
    {
        constexpr double exact = 1e-13, byRounding = 1e-10, difference = 1e-6;
        constexpr int iterations = 60, halvings = 30;
        const double stiffness = law.stiffness(s), asked = rates.norm() / stiffness;
        const double size = std::fmax(asked, std::sqrt(doubleDot(prescribed, prescribed) + doubleDot(W, W)));
        auto now = off(s, x);
        for (int k = 0; k < iterations; ++k)
        {
            const double unit = std::fmax(size, norm(D(x)));
            if (now.norm() <= exact * stiffness * unit) return x;
            Eigen::MatrixXd slope(x.size(), x.size());
            for (Eigen::Index j = 0; j < x.size(); ++j)
            {
                auto above = x, below = x;
                above[j] += difference * unit;
                below[j] -= difference * unit;
                slope.col(j) = (off(s, above) - off(s, below)) / (2 * difference * unit);
            }
            const Eigen::VectorXd change = solution(slope, -now);
            const auto reduced = [&]
            {
                double share = 1;
                for (int n = 0; n < halvings; ++n, share *= 0.5)
                    if (const auto left = off(s, x + share * change); left.norm() < now.norm())
                    {
                        x += share * change;
                        now = left;
                        return true;
                    }
                return false;
            };
            if (!reduced()) return now.norm() <= byRounding * stiffness * unit ? std::optional(x) : std::nullopt;
        }
        return {};
    }
};

/// One row where stresses are controlled: the strain rate follows from the state at every stage of the integration.
template<ConstitutiveLaw Law>
ElementRow controlledRow(const Law& law, const StressIntegration& how, const ElementRow& from, Tensor<3> deformation,
                         const std::vector<StressControl>& controls, const Eigen::VectorXd& changes)
{
    using Material = StateOf<Law>;
    auto row = from;
    const Controlled<Law> controlled{law, symm(deformation), skew(deformation), controls, changes};
    ElementState<Material> now{stateFrom<Material>(from.stress, from.variables), from.strain};
    auto guess = controlled.guess(now.soil);
    const auto rate = [&](double, const ElementState<Material>& s)
    {
        const auto x = controlled.solve(s.soil, guess);
        // A strain rate that does not exist makes the substep shorter.
        if (!x) return std::numeric_limits<double>::quiet_NaN() * s;
        guess = *x;
        const auto D = controlled.D(*x);
        Material soil = law.rate(s.soil, D);
        soil += turning(s.soil, controlled.W);
        return ElementState<Material>{soil, D};
    };
    const auto error = [&](const ElementState<Material>& e, const ElementState<Material>& s)
    {
        const double strained =
            norm(e.strain) * law.stiffness(s.soil) / (std::fmax(norm(now.soil.stress), norm(s.soil.stress)) * how.tolerance);
        return substepError(law, e.soil, from.stress, now.soil, s.soil, how.tolerance) + strained;
    };
    const auto admits = [&](const ElementState<Material>& s) { return mayEndAt(law, s.soil); };
    const auto settled = [&](ElementState<Material>& s) { return settle(law, how, s.soil, row.state); };
    row.state = StressState::regular;
    const double size = std::sqrt(doubleDot(deformation, deformation)) + norm(controlled.D(guess));
    row.subSteps = integrate(*how.pair, now, how.pair->firstStrain / size, rate, error, admits, settled,
                             [](const ElementState<Material>&) { return false; });
    row.stress = now.soil.stress;
    row.variables = numbersOf(now.soil.variables);
    row.strain = now.strain;
    if (!row.subSteps.resolved) row.state = StressState::unresolved;
    return row;
}

template<ConstitutiveLaw Law>
ElementRow strainedRow(const Law& law, const StressIntegration& how, const ElementRow& from, Tensor<3> deformation)
{
    auto row = from;
    const auto step = integrateStress(law, stateFrom<StateOf<Law>>(from.stress, from.variables), deformation, how);
    row.stress = step.stress;
    row.variables = numbersOf(step.variables);
    row.strain += symm(deformation);
    row.state = step.state;
    row.subSteps = step.subSteps;
    return row;
}

/// Messages begin with this.
std::string nameOf(const ElementTest& test, const std::string& stage)
{
    return "test " + test.name + (stage.empty() ? "" : ", stage " + stage);
}

}

StressControl heldComponent(double SymmTensor<3>::*component)
{
    SymmTensor<3> unit;
    unit.*component = 1;
    return {unit, unit};
}

std::optional<SymmTensor<3>> heldStrainRate(const SoilLaw& any, SymmTensor<3> stress, SymmTensor<3> D, Tensor<3> W,
                                            const std::array<bool, 6>& held, const std::vector<double>& variables)
{
    std::vector<StressControl> controls;
    for (std::size_t k = 0; k < held.size(); ++k)
        if (held[k]) controls.push_back(heldComponent(symmComponents[k]));
    return std::visit(
        [&]<class Law>(const Law& law) -> std::optional<SymmTensor<3>>
        {
            const Controlled<Law> controlled{law, D, W, controls, Eigen::VectorXd::Zero(Eigen::Index(controls.size()))};
            const auto state = stateFrom<StateOf<Law>>(stress, variables);
            const auto x = controlled.solve(state, controlled.guess(state));
            return x ? std::optional(controlled.D(*x)) : std::nullopt;
        },
        any);
}

std::vector<ElementRow> runElementTest(const Soil& soil, const ElementTest& test)
{
    std::vector<ElementRow> rows{{.stress = test.stress, .variables = test.variables}};
    double from = 0;
    for (const auto& leg : test.legs)
    {
        const auto start = rows.back();
        if (start.stage != leg.stage) from = 0;
        if (rows.size() == 1) rows[0].stage = leg.stage;
        Eigen::VectorXd changes = Eigen::VectorXd::Zero(Eigen::Index(leg.controls.size()));
        for (std::size_t k = 0; k < leg.controls.size(); ++k)
            if (const auto& control = leg.controls[k]; control.target)
            {
                const double now = doubleDot(control.measure, start.stress);
                changes[Eigen::Index(k)] = (*control.target - now) / test.points;
                from = now;
            }
        for (int k = 0; k < test.points; ++k)
        {
            const auto part = 1.0 / test.points * leg.deformation;
            auto row = std::visit(
                [&](const auto& law)
                {
                    return leg.controls.empty() ? strainedRow(law, soil.integration, rows.back(), part)
                                                : controlledRow(law, soil.integration, rows.back(), part, leg.controls, changes);
                },
                soil.law);
            row.path = from + (leg.path - from) * (k + 1) / test.points;
            row.stage = leg.stage;
            row.porePressure = leg.drains ? 0 : start.porePressure + row.stress.xx - start.stress.xx;
            if (row.state == StressState::inadmissible)
                throw CaseError(test.where,
                                fmt::format("{}: a principal stress is tensile at path {:.6g}, or the stress is beyond the soil's "
                                            "strength{}",
                                            nameOf(test, leg.stage), rows.back().path,
                                            test.variables.empty() ? "" : ", or the void ratio beyond the law's range"));
            if (row.state == StressState::unresolved)
                throw CaseError(
                    test.where,
                    fmt::format("{}: stopped behind path {:.6g}, where {}", nameOf(test, leg.stage), rows.back().path,
                                leg.controls.empty()
                                    ? "substeps have become too short or too many: the law is too stiff for the steps between rows"
                                    : "no strain rate gives the stresses that are asked for"));
            rows.push_back(row);
        }
        from = leg.path;
    }
    return rows;
}

double deviatorStress(SymmTensor<3> s) { return std::sqrt(1.5) * norm(deviator(s)); }

}
