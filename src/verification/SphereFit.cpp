#include "verification/SphereFit.hpp"
#include <Eigen/QR>

namespace sph
{

SphereFit fitSphere(std::span<const Vector<3>> points, int dimension)
{
    const auto n = Eigen::Index(points.size());
    if (n < dimension + 1) return {};
    // Relative to their mean, so that small drops far from the origin lose no digits.
    Vector<3> mean;
    for (const auto& x : points) mean += x / double(n);
    Eigen::MatrixXd A(n, dimension + 1);
    Eigen::VectorXd b(n);
    const auto fill = [&](Eigen::Index row, const Vector<3>& a, double last, double right)
    {
        A(row, 0) = a.x;
        A(row, 1) = a.y;
        if (dimension == 3) A(row, 2) = a.z;
        A(row, dimension) = last;
        b(row) = right;
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

}
