#include "elementTests/fitConstants.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace
{

constexpr double tolerance = 1e-9; ///< of the tests' integration: below what the difference quotients see

double largestOf(const MeasuredCurve& curve)
{
    double most = 0;
    for (const double value : curve.values) most = std::max(most, std::abs(value));
    return most > 0 ? most : 1;
}

/// The constants as shares of their bounds, 0 to 1.
class Fitting
{
    const FitPlan& plan_;
    const FitTrial& trial_;

public:
    Fitting(const FitPlan& plan, const FitTrial& trial) : plan_(plan), trial_(trial) {}

    Eigen::Index size() const { return Eigen::Index(plan_.constants.size()); }
    double width(Eigen::Index k) const
    {
        const auto& constant = plan_.constants[std::size_t(k)];
        return constant.largest - constant.least;
    }
    std::vector<double> values(const Eigen::VectorXd& shares) const
    {
        std::vector<double> values;
        for (Eigen::Index k = 0; k < size(); ++k) values.push_back(plan_.constants[std::size_t(k)].least + shares[k] * width(k));
        return values;
    }
    /// Throws CaseError where a test does not run.
    Eigen::VectorXd residuals(const Eigen::VectorXd& shares) const
    {
        auto [soil, tests] = trial_(values(shares));
        soil.integration.tolerance = std::min(soil.integration.tolerance, tolerance);
        std::vector<double> all;
        for (const auto& [test, curves] : tests)
        {
            const auto rows = runElementTest(soil, test);
            for (const auto& curve : curves)
            {
                const double size = largestOf(curve);
                for (std::size_t i = 0; i < curve.values.size(); ++i)
                    all.push_back((curve.of(rows[(i + 1) * std::size_t(test.points)]) - curve.values[i]) / size);
            }
        }
        return Eigen::Map<Eigen::VectorXd>(all.data(), Eigen::Index(all.size()));
    }
    std::optional<Eigen::VectorXd> residualsIfAny(const Eigen::VectorXd& shares) const
    {
        try
        {
            auto r = residuals(shares);
            return r.allFinite() ? std::optional(r) : std::nullopt;
        }
        catch (const CaseError&)
        {
            return {};
        }
    }
    /// d(residuals)/d(shares), one-sided beside a bound and where a side does not run.
    Eigen::MatrixXd slopes(const Eigen::VectorXd& shares, const Eigen::VectorXd& here) const
    {
        constexpr double step = 1e-4;
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(here.size(), size());
        for (Eigen::Index k = 0; k < size(); ++k)
        {
            const auto at = [&](double change)
            {
                auto there = shares;
                there[k] += change;
                return there[k] >= 0 && there[k] <= 1 ? residualsIfAny(there) : std::nullopt;
            };
            const auto above = at(step), below = at(-step);
            if (above && below) J.col(k) = (*above - *below) / (2 * step);
            else if (above) J.col(k) = (*above - here) / step;
            else if (below) J.col(k) = (here - *below) / step;
        }
        return J;
    }
};

/// Student's t of 97.5 % for so many degrees of freedom (Abramowitz & Stegun 1964, 26.7.5).
double studentT(double freedom)
{
    constexpr double z = 1.959964;
    return z + (std::pow(z, 3) + z) / (4 * freedom) + (5 * std::pow(z, 5) + 16 * std::pow(z, 3) + 3 * z) / (96 * freedom * freedom);
}

/// The test that finds a constant, as the law names it.
std::string testFor(const SoilLaw& any, const std::string& entry)
{
    return std::visit(
        [&]<class Law>(const Law&) -> std::string
        {
            if constexpr (requires { Law::foundBy; })
                for (const auto& [name, test] : Law::foundBy)
                    if (entry == name) return test;
            return "a test in which the stress or the volume changes with it";
        },
        any);
}

}

Fit fitConstants(const FitPlan& plan, const std::vector<double>& start, const FitTrial& trial)
{
    const Fitting fitting(plan, trial);
    const Eigen::Index m = fitting.size();
    Eigen::VectorXd x(m);
    for (Eigen::Index k = 0; k < m; ++k) x[k] = (start[std::size_t(k)] - plan.constants[std::size_t(k)].least) / fitting.width(k);
    Eigen::VectorXd r = fitting.residuals(x);
    if (r.size() <= m)
        throw CaseError(plan.where, fmt::format("{} measured points for {} constants: more points than constants are needed", r.size(), m));

    constexpr int most = 100;
    constexpr double still = 1e-9, exact = 1e-12;
    double damping = 1e-3;
    Eigen::MatrixXd J = fitting.slopes(x, r);
    for (int iterations = 0; iterations < most && damping < 1e12; ++iterations)
    {
        const Eigen::VectorXd gradient = J.transpose() * r;
        Eigen::MatrixXd normal = J.transpose() * J;
        normal.diagonal() *= 1 + damping;
        normal.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff(); // what no test depends on stays
        Eigen::VectorXd right = gradient;
        for (Eigen::Index k = 0; k < m; ++k)
            if ((x[k] <= 0 && gradient[k] > 0) || (x[k] >= 1 && gradient[k] < 0))
            {
                normal.row(k).setZero();
                normal.col(k).setZero();
                normal(k, k) = 1;
                right[k] = 0;
            }
        const Eigen::VectorXd next = (x - normal.ldlt().solve(right)).cwiseMax(0).cwiseMin(1);
        const double change = (next - x).cwiseAbs().maxCoeff();
        const auto there = change > still ? fitting.residualsIfAny(next) : std::nullopt;
        if (there && there->squaredNorm() < r.squaredNorm())
        {
            const bool done = there->squaredNorm() > (1 - exact) * r.squaredNorm();
            x = next;
            r = *there;
            J = fitting.slopes(x, r);
            damping = std::max(1e-12, 0.1 * damping);
            if (done) break;
        }
        else if (change <= still) break;
        else damping *= 10;
    }

    const auto law = trial(fitting.values(x)).first.law;
    const auto refuse = [&](const std::vector<Eigen::Index>& which, const std::string& why)
    {
        std::string missing;
        std::vector<std::string> names;
        for (const auto k : which)
        {
            const auto& entry = plan.constants[std::size_t(k)].entry;
            names.push_back(entry);
            missing += fmt::format("{}{} by {}", missing.empty() ? "" : "; ", entry, testFor(law, entry));
        }
        throw CaseError(plan.constants[std::size_t(which.front())].where,
                        fmt::format("{} cannot be found: {}. A test is missing: {}", fmt::join(names, ", "), why, missing));
    };
    Fit fit;
    fit.points = std::size_t(r.size());
    std::vector<Eigen::Index> inside;
    for (Eigen::Index k = 0; k < m; ++k)
    {
        fit.constants.push_back({fitting.values(x)[std::size_t(k)], 0, 0, x[k] <= 0 || x[k] >= 1});
        if (!(J.col(k).norm() > 1e-6 * std::sqrt(double(r.size())))) refuse({k}, "none of the tests depends on it");
        if (!fit.constants.back().onBound) inside.push_back(k);
    }
    if (!inside.empty())
    {
        Eigen::MatrixXd scaled(r.size(), Eigen::Index(inside.size()));
        for (std::size_t j = 0; j < inside.size(); ++j) scaled.col(Eigen::Index(j)) = J.col(inside[j]).normalized();
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
        constexpr double apart = 1e-4, share = 0.1;
        const auto last = Eigen::Index(inside.size()) - 1;
        if (svd.singularValues()[last] < apart)
        {
            std::vector<Eigen::Index> which;
            for (std::size_t j = 0; j < inside.size(); ++j)
                if (std::abs(svd.matrixV()(Eigen::Index(j), last)) > share) which.push_back(inside[j]);
            refuse(which, "the tests depend on them together alone, and do not tell them apart");
        }
        const double freedom = double(r.size()) - double(inside.size()), s2 = r.squaredNorm() / freedom;
        for (std::size_t j = 0; j < inside.size(); ++j)
        {
            const auto row = svd.matrixV().row(Eigen::Index(j)).transpose();
            const double variance = row.cwiseQuotient(svd.singularValues()).squaredNorm() * s2 / J.col(inside[j]).squaredNorm();
            const double error = std::sqrt(variance);
            if (studentT(freedom) * error > 1)
                refuse({inside[j]}, fmt::format("95 % of confidence, +- {:.4g}, are wider than its bounds",
                                                studentT(freedom) * error * fitting.width(inside[j])));
            auto& constant = fit.constants[std::size_t(inside[j])];
            constant.standardError = error * fitting.width(inside[j]);
            constant.halfWidth = studentT(freedom) * constant.standardError;
        }
    }
    Eigen::Index first = 0;
    for (const auto& [test, curves] : plan.tests)
    {
        fit.misfits.emplace_back();
        for (const auto& curve : curves)
        {
            const auto n = Eigen::Index(curve.values.size());
            fit.misfits.back().push_back(std::sqrt(r.segment(first, n).squaredNorm() / double(n)));
            first += n;
        }
    }
    return fit;
}

}
