#include "elementTests/ElementTest.hpp"
#include <Eigen/Dense>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Stress and strain together: where stresses are held, the strain is part of what is solved for.
struct ElementState
{
    SymmTensor<3> stress, strain;
    ElementState& operator+=(const ElementState& b)
    {
        stress += b.stress;
        strain += b.strain;
        return *this;
    }
    friend ElementState operator*(double s, const ElementState& a) { return {s * a.stress, s * a.strain}; }
};

/// The stress rates that are to vanish, 0 for components that are not held.
template<class Law>
SymmTensor<3> heldRates(const Law& law, SymmTensor<3> stress, SymmTensor<3> D, SymmTensor<3> spun, const std::array<bool, 6>& held)
{
    auto rate = law.rate(stress, D) + spun;
    for (std::size_t k = 0; k < held.size(); ++k)
        if (!held[k]) rate.*symmComponents[k] = 0;
    return rate;
}

/// The change of D by which the rates would vanish if they were linear; of components that are not held it is 0.
template<class Law>
SymmTensor<3> newtonChange(const Law& law, SymmTensor<3> stress, SymmTensor<3> D, SymmTensor<3> spun, const std::array<bool, 6>& held,
                           SymmTensor<3> rates, double step)
{
    Eigen::Matrix<double, 6, 6> slope = law.stiffness(stress) * Eigen::Matrix<double, 6, 6>::Identity();
    Eigen::Matrix<double, 6, 1> right;
    for (std::size_t j = 0; j < held.size(); ++j)
    {
        right[Eigen::Index(j)] = -(rates.*symmComponents[j]);
        if (!held[j]) continue;
        auto above = D, below = D;
        above.*symmComponents[j] += step;
        below.*symmComponents[j] -= step;
        const auto column = 1 / (2 * step) * (heldRates(law, stress, above, spun, held) - heldRates(law, stress, below, spun, held));
        for (std::size_t i = 0; i < held.size(); ++i) slope(Eigen::Index(i), Eigen::Index(j)) = column.*symmComponents[i];
    }
    const Eigen::Matrix<double, 6, 1> solved = slope.fullPivLu().solve(right);
    SymmTensor<3> change;
    for (std::size_t i = 0; i < held.size(); ++i) change.*symmComponents[i] = solved[Eigen::Index(i)];
    return change;
}

/// Newton's method, with steps halved until the rates fall: they have kinks where loading turns to unloading.
template<class Law>
std::optional<SymmTensor<3>> solveHeld(const Law& law, SymmTensor<3> stress, SymmTensor<3> D, Tensor<3> W, const std::array<bool, 6>& held)
{
    constexpr double exact = 1e-13, byRounding = 1e-10, difference = 1e-6;
    constexpr int iterations = 60, halvings = 30;
    const auto spun = turning(stress, W);
    const double size = std::sqrt(doubleDot(D, D) + doubleDot(W, W)), stiffness = law.stiffness(stress);
    auto rates = heldRates(law, stress, D, spun, held);
    for (int k = 0; k < iterations; ++k)
    {
        const double unit = std::fmax(size, norm(D));
        if (norm(rates) <= exact * stiffness * unit) return D;
        const auto change = newtonChange(law, stress, D, spun, held, rates, difference * unit);
        const auto reduced = [&]
        {
            double share = 1;
            for (int n = 0; n < halvings; ++n, share *= 0.5)
                if (const auto left = heldRates(law, stress, D + share * change, spun, held); norm(left) < norm(rates))
                {
                    D += share * change;
                    rates = left;
                    return true;
                }
            return false;
        };
        if (!reduced()) return norm(rates) <= byRounding * stiffness * unit ? std::optional(D) : std::nullopt;
    }
    return {};
}

/// One row where stresses are held: the strain rate follows from the stress at every stage of the integration.
template<ConstitutiveLaw Law>
ElementRow heldRow(const Law& law, const StressIntegration& how, const ElementRow& from, Tensor<3> deformation,
                   const std::array<bool, 6>& held)
{
    auto row = from;
    const auto prescribed = symm(deformation);
    const auto W = skew(deformation);
    auto guess = prescribed;
    ElementState state{from.stress, from.strain};
    const auto rate = [&](double, const ElementState& s)
    {
        const auto D = solveHeld(law, s.stress, guess, W, held);
        // A strain rate that does not exist makes the substep shorter.
        if (!D) return std::numeric_limits<double>::quiet_NaN() * s;
        guess = *D;
        return ElementState{law.rate(s.stress, *D) + turning(s.stress, W), *D};
    };
    const auto error = [&](const ElementState& e, const ElementState& s)
    {
        const double strained = norm(e.strain) * law.stiffness(s.stress) / (std::fmax(norm(state.stress), norm(s.stress)) * how.tolerance);
        return substepError(law, e.stress, from.stress, state.stress, s.stress, how.tolerance) + strained;
    };
    const auto admits = [&](const ElementState& s) { return !Law::tensionless || law.admits(s.stress); };
    const auto settled = [&](ElementState& s) { return settle(law, how, s.stress, row.state); };
    row.state = StressState::regular;
    const double size = std::sqrt(doubleDot(deformation, deformation));
    row.subSteps =
        integrate(*how.pair, state, how.pair->firstStrain / size, rate, error, admits, settled, [](const ElementState&) { return false; });
    row.stress = state.stress;
    row.strain = state.strain;
    if (!row.subSteps.resolved) row.state = StressState::unresolved;
    return row;
}

template<ConstitutiveLaw Law>
ElementRow strainedRow(const Law& law, const StressIntegration& how, const ElementRow& from, Tensor<3> deformation)
{
    auto row = from;
    const auto step = integrateStress(law, from.stress, deformation, how);
    row.stress = step.stress;
    row.strain += symm(deformation);
    row.state = step.state;
    row.subSteps = step.subSteps;
    return row;
}

}

std::optional<SymmTensor<3>> heldStrainRate(const SoilLaw& any, SymmTensor<3> stress, SymmTensor<3> D, Tensor<3> W,
                                            const std::array<bool, 6>& held)
{
    return std::visit([&](const auto& law) { return solveHeld(law, stress, D, W, held); }, any);
}

std::vector<ElementRow> runElementTest(const Soil& soil, const ElementTest& test)
{
    const bool holds = std::ranges::any_of(test.held, [](bool h) { return h; });
    std::vector<ElementRow> rows{{0, {}, test.stress, StressState::regular, {}}};
    double from = 0;
    for (const auto& leg : test.legs)
    {
        for (int k = 0; k < test.points; ++k)
        {
            const auto part = 1.0 / test.points * leg.deformation;
            auto row = std::visit(
                [&](const auto& law) {
                    return holds ? heldRow(law, soil.integration, rows.back(), part, test.held)
                                 : strainedRow(law, soil.integration, rows.back(), part);
                },
                soil.law);
            row.path = from + (leg.path - from) * (k + 1) / test.points;
            if (row.state == StressState::inadmissible)
                throw CaseError(test.where,
                                fmt::format("test {}: a principal stress is tensile at path {:.6g}, or the stress is beyond the soil's "
                                            "strength",
                                            test.name, rows.back().path));
            if (row.state == StressState::unresolved)
                throw CaseError(
                    test.where,
                    fmt::format("test {}: stopped behind path {:.6g}, where {}", test.name, rows.back().path,
                                holds ? "no strain rate holds the stresses that are to be held"
                                      : "substeps have become too short or too many: the law is too stiff for the steps between rows"));
            rows.push_back(row);
        }
        from = leg.path;
    }
    return rows;
}

double deviatorStress(SymmTensor<3> s) { return std::sqrt(1.5) * norm(deviator(s)); }

}
