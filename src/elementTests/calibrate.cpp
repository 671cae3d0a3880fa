#include "elementTests/calibrate.hpp"
#include "elementTests/ElementTest.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

[[noreturn]] void impossible(const Measurement& m, const std::string& what)
{
    throw CaseError(m.where, "no constants of law wuBauer give what was measured: " + what);
}

/// The four equations of calibrate.hpp.
WuBauer constantsOf(const Measurement& m, const TriaxialFigures& f)
{
    const double R = 1 + f.peak / f.pressure, a = 0.5 * (1 - f.initialVolumeSlope), b = 0.5 * (1 - f.peakVolumeSlope);
    const SymmTensor<3> r = 1 / (2 + R) * SymmTensor<3>{1, 0, 0, 1, 0, R}, D{b, 0, 0, b, 0, -1};
    const auto rr = square(r), ss = square(deviator(r));
    const double rD = doubleDot(r, D), n = norm(D);
    Eigen::Matrix4d equations;
    Eigen::Vector4d right(f.initialStiffness / f.pressure, 0, 0, 0);
    equations << -3 * (1 + a), 0, 0, 0,                //
        9 * a, 2 * a - 1, std::sqrt(1 + 2 * a * a), 0, //
        b, rD * r.xx, n * rr.xx, n * ss.xx,            //
        -1, rD * r.zz, n * rr.zz, n * ss.zz;
    const Eigen::FullPivLU<Eigen::Matrix4d> solver(equations);
    if (!solver.isInvertible()) impossible(m, "the four figures do not determine them, the equations are singular");
    const Eigen::Vector4d c = solver.solve(right);
    return {c[0], c[1], c[2], c[3]};
}

/// Rows at the axial strains of the points, and their misfits.
struct Residuals
{
    Eigen::VectorXd values; ///< of q over its peak, then of the volume strain over its largest
    double stress = 0, volume = 0;
};

std::optional<Residuals> residualsOf(const WuBauer& law, const Measurement& m)
{
    Soil soil;
    soil.law = law;
    soil.integration.tolerance = 1e-10; // below what a difference quotient of 1e-6 sees
    soil.integration.floorPressure = 1e-6 * m.figures.pressure;
    ElementTest test;
    const double p = m.figures.pressure;
    test.stress = {-p, 0, 0, -p, 0, -p};
    const std::vector<StressControl> lateral{heldComponent(&SymmTensor<3>::xx), heldComponent(&SymmTensor<3>::yy)};
    test.points = 1;
    test.where = m.where;
    double before = 0, mostVolume = 0;
    for (const auto& point : m.points)
    {
        if (point.axialStrain > before)
            test.legs.push_back({{0, 0, 0, 0, 0, 0, 0, 0, before - point.axialStrain}, point.axialStrain, lateral});
        before = std::max(before, point.axialStrain);
        mostVolume = std::max(mostVolume, std::abs(point.volumeStrain));
    }
    if (!law.K0()) return {};
    std::vector<ElementRow> rows;
    try
    {
        rows = runElementTest(soil, test);
    }
    catch (const CaseError&)
    {
        return {};
    }
    const auto n = Eigen::Index(m.points.size());
    Residuals r{Eigen::VectorXd(2 * n)};
    for (Eigen::Index k = 0; k < n; ++k)
    {
        const auto& point = m.points[std::size_t(k)];
        const auto& row = *std::ranges::find_if(rows, [&](const ElementRow& each) { return each.path >= point.axialStrain; });
        r.values[k] = (row.stress.xx - row.stress.zz - point.q) / m.figures.peak;
        r.values[n + k] = (-trace(row.strain) - point.volumeStrain) / mostVolume;
    }
    r.stress = std::sqrt(r.values.head(n).squaredNorm() / double(n));
    r.volume = std::sqrt(r.values.tail(n).squaredNorm() / double(n));
    return r;
}

/// Least squares over all points, by Levenberg and Marquardt, from a first set of constants.
void fit(const Measurement& m, WuBauer& law)
{
    const auto constants = [](WuBauer& l) { return std::array{&l.c1, &l.c2, &l.c3, &l.c4}; };
    auto r = residualsOf(law, m);
    if (!r) return;
    double damping = 1e-3;
    for (int iterations = 0; iterations < 200 && damping < 1e12; ++iterations)
    {
        Eigen::MatrixXd slope(r->values.size(), 4);
        for (std::size_t j = 0; j < 4; ++j)
        {
            auto other = law;
            const double step = 1e-6 * *constants(law)[j];
            *constants(other)[j] += step;
            const auto there = residualsOf(other, m);
            if (!there) return;
            slope.col(Eigen::Index(j)) = (there->values - r->values) / step;
        }
        Eigen::Matrix4d normal = slope.transpose() * slope;
        normal.diagonal() *= 1 + damping;
        const Eigen::Vector4d change = normal.ldlt().solve(slope.transpose() * r->values);
        auto next = law;
        double largest = 0;
        for (std::size_t j = 0; j < 4; ++j)
        {
            *constants(next)[j] -= change[Eigen::Index(j)];
            largest = std::max(largest, std::abs(change[Eigen::Index(j)] / *constants(law)[j]));
        }
        const auto there = residualsOf(next, m);
        if (there && there->values.norm() < r->values.norm())
        {
            law = next;
            r = there;
            damping = std::max(1e-12, 0.1 * damping);
            if (largest < 1e-9) return;
        }
        else
        {
            if (largest < 1e-9) return;
            damping *= 10;
        }
    }
}

void checkPoints(const Measurement& m)
{
    constexpr std::size_t fewest = 5;
    if (m.points.size() < fewest)
        throw CaseError(m.where,
                        fmt::format("{} points of a triaxial test up to its peak are too few: at least {}", m.points.size(), fewest));
    for (std::size_t k = 0; k < m.points.size(); ++k)
    {
        const auto& point = m.points[k];
        if (point.axialStrain < 0 || (k > 0 && !(point.axialStrain > m.points[k - 1].axialStrain)))
            throw CaseError(
                m.where,
                fmt::format("the axial strains are to grow from point to point, compression positive: {:.6g} is not more than {:.6g}",
                            point.axialStrain, k > 0 ? m.points[k - 1].axialStrain : 0));
        if (point.axialStrain == 0 && (point.q != 0 || point.volumeStrain != 0))
            throw CaseError(m.where, "without axial strain q and volumeStrain are 0: the test begins at isotropic stress");
    }
}

}

TriaxialFigures figuresOf(double pressure, const std::vector<TriaxialPoint>& points)
{
    // Secants at the first two strains above 0, extrapolated to 0; the slope at the peak is that of the last two points.
    auto first = points.begin();
    if (first->axialStrain == 0) ++first;
    const auto &a = *first, &b = *(first + 1), &last = points.back(), &before = *(points.end() - 2);
    const auto start = [&](double TriaxialPoint::*value)
    {
        const double one = a.*value / a.axialStrain, two = b.*value / b.axialStrain;
        return one + (one - two) * a.axialStrain / (b.axialStrain - a.axialStrain);
    };
    return {pressure, start(&TriaxialPoint::q), start(&TriaxialPoint::volumeStrain),
            (last.volumeStrain - before.volumeStrain) / (last.axialStrain - before.axialStrain), last.q};
}

Calibration calibrate(const Measurement& measured)
{
    auto m = measured;
    if (!m.points.empty())
    {
        // Points behind the peak, softening, are beyond the law.
        m.points.erase(std::ranges::max_element(m.points, {}, &TriaxialPoint::q) + 1, m.points.end());
        checkPoints(m);
        m.figures = figuresOf(m.figures.pressure, m.points);
    }
    const auto& f = m.figures;
    if (!(f.initialStiffness > 0 && f.peak > 0))
        impossible(m, fmt::format("the initial stiffness, {:.6g} Pa, and the peak, {:.6g} Pa, are to be positive", f.initialStiffness,
                                  f.peak));
    Calibration found{constantsOf(m, f), {}, {}};
    if (!m.points.empty())
    {
        fit(m, found.law);
        if (const auto r = residualsOf(found.law, m))
        {
            found.misfitStress = r->stress;
            found.misfitVolume = r->volume;
        }
    }
    const auto& law = found.law;
    const auto constants = fmt::format("c1 {:.6g}, c2 {:.6g}, c3 {:.6g}, c4 {:.6g}", law.c1, law.c2, law.c3, law.c4);
    if (!law.K0())
        impossible(
            m,
            fmt::format(
                "{} would do, which have no earth pressure at rest between 0 and 1. Of a peak of {:.4g} Pa at {:.4g} Pa, stiffness {:.4g} "
                "Pa and slopes {:.4g} and {:.4g} look at the slopes first: less contraction at the start, less dilation at the peak",
                constants, f.peak, f.pressure, f.initialStiffness, f.initialVolumeSlope, f.peakVolumeSlope));
    // The peak is a solution; whether the path leads there is another question.
    if (m.points.empty())
    {
        constexpr double enough = 0.5, nearly = 0.01;
        Measurement far = m;
        far.points = {{enough, f.peak, 1}};
        const auto r = residualsOf(law, far);
        if (!r || std::abs(r->values[0]) > nearly)
            impossible(m, fmt::format("{} have this peak as a limit state, and {}", constants,
                                      r ? fmt::format("the test ends {:+.3g} % off it", 100 * r->values[0]) : "the test ends before it"));
    }
    return found;
}

}
