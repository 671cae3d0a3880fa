#include "sampling/SphereFit.hpp"
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

namespace sph
{

namespace
{

/// Fits are made relative to it, so that small drops far from the origin lose no digits.
Vector<3> meanOf(std::span<const Vector<3>> points)
{
    Vector<3> mean;
    for (const auto& x : points) mean += x / double(points.size());
    return mean;
}

double rootOfWeight(std::span<const double> weights, Eigen::Index k) { return weights.empty() ? 1 : std::sqrt(weights[std::size_t(k)]); }

}

SphereFit fitSphere(std::span<const Vector<3>> points, int dimension, std::span<const double> weights)
{
    const auto n = Eigen::Index(points.size());
    if (n < dimension + 1) return {};
    const auto mean = meanOf(points);
    Eigen::MatrixXd A(n, dimension + 1);
    Eigen::VectorXd b(n);
    const auto fill = [&](Eigen::Index row, const Vector<3>& a, double last, double right)
    {
        const double w = rootOfWeight(weights, row);
        A(row, 0) = w * a.x;
        A(row, 1) = w * a.y;
        if (dimension == 3) A(row, 2) = w * a.z;
        A(row, dimension) = w * last;
        b(row) = w * right;
    };
    const auto spatial = [&](const Eigen::VectorXd& v) { return Vector<3>{v(0), v(1), dimension == 3 ? v(2) : 0}; };

    for (Eigen::Index k = 0; k < n; ++k)
    {
        const auto x = points[std::size_t(k)] - mean;
        fill(k, 2 * x, 1, dot(x, x));
    }
    const Eigen::VectorXd start = A.colPivHouseholderQr().solve(b);
    auto centre = spatial(start);
    double R = std::sqrt(start(dimension) + dot(centre, centre));
    if (!(R > 0) || !std::isfinite(R)) return {};

    for (int iteration = 0; iteration < 50; ++iteration)
    {
        for (Eigen::Index k = 0; k < n; ++k)
        {
            const auto d = points[std::size_t(k)] - mean - centre;
            const double r = mag(d);
            fill(k, r > 0 ? d / r : Vector<3>{}, 1, r - R);
        }
        const Eigen::VectorXd step = A.colPivHouseholderQr().solve(b);
        centre += spatial(step);
        R += step(dimension);
        if (step.norm() < 1e-12 * R) break;
    }
    if (!(R > 0) || !std::isfinite(R)) return {};
    return {centre + mean, R};
}

EllipsoidFit fitEllipsoid(std::span<const Vector<3>> points, int dimension, std::span<const double> weights)
{
    const auto n = Eigen::Index(points.size()), d = Eigen::Index(dimension);
    const auto ofShape = d * (d + 1) / 2 - 1, unknowns = ofShape + d + 1; // A without its trace, b, c
    if (n < unknowns) return {};
    const auto mean = meanOf(points);
    double size = 0;
    for (const auto& x : points) size = std::max(size, mag(x - mean));
    if (!(size > 0) || !std::isfinite(size)) return {};

    Eigen::MatrixXd M(n, unknowns);
    Eigen::VectorXd right(n);
    for (Eigen::Index k = 0; k < n; ++k)
    {
        const auto x = (points[std::size_t(k)] - mean) / size;
        const std::array<double, 3> q{x.x, x.y, x.z};
        Eigen::Index column = 0;
        for (std::size_t i = 0; i + 1 < std::size_t(d); ++i) M(k, column++) = sqr(q[i]) - sqr(q[std::size_t(d) - 1]);
        for (std::size_t i = 0; i < std::size_t(d); ++i)
            for (std::size_t j = i + 1; j < std::size_t(d); ++j) M(k, column++) = 2 * q[i] * q[j];
        for (std::size_t i = 0; i < std::size_t(d); ++i) M(k, column++) = q[i];
        M(k, column) = 1;
        right(k) = -dot(x, x);
        const double w = rootOfWeight(weights, k);
        M.row(k) *= w;
        right(k) *= w;
    }
    const Eigen::VectorXd found = M.colPivHouseholderQr().solve(right);
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(d, d);
    Eigen::Index column = 0;
    for (Eigen::Index i = 0; i + 1 < d; ++i, ++column)
    {
        A(i, i) += found(column);
        A(d - 1, d - 1) -= found(column);
    }
    for (Eigen::Index i = 0; i < d; ++i)
        for (Eigen::Index j = i + 1; j < d; ++j) A(i, j) = A(j, i) = found(column++);
    const Eigen::VectorXd b = found.segment(column, d);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(A); // least eigenvalue first, which the longest axis has
    if (!(eigen.eigenvalues()(0) > 0)) return {};
    const Eigen::VectorXd centre = -0.5 * A.llt().solve(b);
    const double level = centre.dot(A * centre) - found(column + d);
    if (!(level > 0)) return {};
    const auto spatial = [&](const auto& v) { return size * Vector<3>{v(0), v(1), d == 3 ? v(2) : 0}; };
    return {mean + spatial(centre), spatial(Eigen::VectorXd((level * eigen.eigenvalues().cwiseInverse()).cwiseSqrt()))};
}

}
