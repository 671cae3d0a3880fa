#include "sampling/ModeFit.hpp"
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph
{

namespace
{

Eigen::Map<const Eigen::VectorXd> asVector(std::span<const double> a) { return {a.data(), Eigen::Index(a.size())}; }

}

std::optional<std::complex<double>> fitOscillation(std::span<const double> t, std::span<const double> a, std::complex<double> start)
{
    const auto n = Eigen::Index(t.size());
    if (n < 6 || t.back() - t.front() < std::numbers::pi / start.imag()) return {};
    auto s = start;
    for (int iteration = 0; iteration < 100; ++iteration)
    {
        // The waves at this s, the amplitudes that fit best, and the slopes in Re s and Im s for these.
        Eigen::MatrixXd waves(n, 3), all(n, 5);
        for (Eigen::Index k = 0; k < n; ++k)
        {
            const auto wave = std::exp(s * (t[std::size_t(k)] - t.front()));
            waves.row(k) << wave.real(), wave.imag(), 1;
        }
        const Eigen::VectorXd amplitudes = waves.colPivHouseholderQr().solve(asVector(a));
        all.leftCols(3) = waves;
        for (Eigen::Index k = 0; k < n; ++k)
        {
            const double since = t[std::size_t(k)] - t.front();
            all(k, 3) = since * (amplitudes(0) * waves(k, 0) + amplitudes(1) * waves(k, 1));
            all(k, 4) = since * (amplitudes(1) * waves(k, 0) - amplitudes(0) * waves(k, 1));
        }
        const Eigen::VectorXd step = all.colPivHouseholderQr().solve(asVector(a) - waves * amplitudes);
        const std::complex<double> change(step(3), step(4));
        // No leap to another root.
        s += change * std::min(1.0, 0.3 * std::abs(s) / (std::abs(change) + 1e-300));
        if (!(s.imag() > start.imag() / 3 && s.imag() < 3 * start.imag())) return {};
        if (std::abs(change) < 1e-10 * std::abs(s)) return s;
    }
    return {};
}

std::optional<double> fitGrowth(std::span<const double> t, std::span<const double> a, double start)
{
    const auto n = Eigen::Index(t.size());
    if (n < 4 || t.back() - t.front() < 1 / start) return {};
    const auto misfit = [&](double s)
    {
        Eigen::MatrixXd waves(n, 2);
        for (Eigen::Index k = 0; k < n; ++k)
            waves.row(k) << std::exp(s * (t[std::size_t(k)] - t.back())), std::exp(-s * (t[std::size_t(k)] - t.front()));
        const Eigen::VectorXd amplitudes = waves.colPivHouseholderQr().solve(asVector(a));
        return (asVector(a) - waves * amplitudes).squaredNorm();
    };
    // Golden section.
    constexpr double golden = std::numbers::phi - 1;
    double low = 0.1 * start, high = 4 * start;
    double left = high - golden * (high - low), right = low + golden * (high - low);
    double atLeft = misfit(left), atRight = misfit(right);
    if (std::isnan(atLeft)) return atLeft; // of samples that are, which no comparison would find
    while (high - low > 1e-8 * start)
        if (atLeft < atRight)
        {
            high = right;
            right = left;
            atRight = atLeft;
            left = high - golden * (high - low);
            atLeft = misfit(left);
        }
        else
        {
            low = left;
            left = right;
            atLeft = atRight;
            right = low + golden * (high - low);
            atRight = misfit(right);
        }
    return (low + high) / 2;
}

}
