#include "sampling/Interpolator.hpp"
#include "sampling/SampledField.hpp"
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace sph
{

namespace
{

std::variant<Kernel<2>, Kernel<3>> kernelOf(const ParticleView& view)
{
    if (view.dimension == 2) return Kernel<2>(view.kernel, view.support);
    return Kernel<3>(view.kernel, view.support);
}

/// Positions with the copies that lie within H of the periodic domain, [low - H, high + H]: several on each side where the period
/// is shorter than H.
void addCopies(std::vector<Vector<3>>& x, std::vector<std::size_t>& source, double Vector<3>::*component, double low, double high, double H)
{
    const double period = high - low;
    const int shifts = int(std::ceil(H / period)) + 1;
    const auto n = x.size();
    for (std::size_t i = 0; i < n; ++i)
        for (int k = -shifts; k <= shifts; ++k)
        {
            auto copy = x[i];
            copy.*component += k * period;
            if (k == 0 || copy.*component < low - H || copy.*component > high + H) continue;
            x.push_back(copy);
            source.push_back(source[i]);
        }
}

constexpr std::array<double Vector<3>::*, 3> components3{&Vector<3>::x, &Vector<3>::y, &Vector<3>::z};

/// Least ratio of the moment matrix's eigenvalues for the linear form. In the interior it is 0.05-0.1, at a plane wall 0.02, in a
/// right-angled corner 0.01 (support of three spacings).
constexpr double leastEigenvalueRatio = 2e-3;

template<int dim> void makeLinear(std::vector<double>& w, const std::vector<Vector<3>>& offset)
{
    using Matrix = Eigen::Matrix<double, dim + 1, dim + 1>;
    using Column = Eigen::Matrix<double, dim + 1, 1>;
    const auto basis = [](const Vector<3>& d)
    {
        Column b;
        if constexpr (dim == 2) b << 1, d.x, d.y;
        else b << 1, d.x, d.y, d.z;
        return b;
    };
    Matrix M = Matrix::Zero();
    for (std::size_t k = 0; k < w.size(); ++k)
    {
        const Column b = basis(offset[k]);
        M += w[k] * b * b.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(M);
    if (!(eigen.eigenvalues()(0) > leastEigenvalueRatio * eigen.eigenvalues()(dim))) return;

    const Column a = eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal() * eigen.eigenvectors().row(0).transpose();
    for (std::size_t k = 0; k < w.size(); ++k) w[k] *= a.dot(basis(offset[k]));
}

}

double PointWeights::operator()(const double* values) const
{
    if (empty()) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    if (values)
        for (std::size_t k = 0; k < particle.size(); ++k) sum += weight[k] * values[particle[k]];
    return sum;
}

Interpolator::Interpolator(const ParticleView& view) : kernel_(kernelOf(view)), H_(view.support), volume_(view.volume)
{
    for (std::size_t i = 0; i < view.n; ++i)
        if (const auto x = position(view, i); std::isfinite(x.x + x.y + x.z))
        {
            x_.push_back(x);
            source_.push_back(i);
        }
    if (view.geometry)
        for (int k = 0; k < view.dimension; ++k)
            if (const auto c = components3[k]; view.geometry->periodic[k])
            {
                low_.*c = view.geometry->low.*c;
                period_.*c = view.geometry->high.*c - low_.*c;
                for (auto& x : x_) x.*c -= period_.*c * std::floor((x.*c - low_.*c) / period_.*c);
                addCopies(x_, source_, c, low_.*c, low_.*c + period_.*c, H_);
            }

    if (x_.empty())
    {
        cellStart_.assign(2, 0);
        return;
    }
    origin_ = x_.front();
    auto top = origin_;
    for (const auto& x : x_)
        for (const auto c : components3)
        {
            origin_.*c = std::min(origin_.*c, x.*c);
            top.*c = std::max(top.*c, x.*c);
        }
    // A particle that has escaped far away must not make the table of cells large.
    const long most = 2 + long(2 * std::pow(double(x_.size()), 1.0 / view.dimension));
    for (int k = 0; k < 3; ++k)
    {
        const auto c = components3[k];
        const double extent = top.*c - origin_.*c;
        cells_[k] = long(std::clamp(std::floor(extent / H_), 1.0, double(most)));
        cellSize_.*c = std::max(extent / double(cells_[k]), H_);
    }

    const auto cellNumber = [&](const Vector<3>& x)
    {
        const auto c = cellOf(x);
        return std::size_t((c[2] * cells_[1] + c[1]) * cells_[0] + c[0]);
    };
    cellStart_.assign(std::size_t(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    for (const auto& x : x_) ++cellStart_[cellNumber(x) + 1];
    for (std::size_t c = 1; c < cellStart_.size(); ++c) cellStart_[c] += cellStart_[c - 1];
    auto next = cellStart_;
    auto x = x_;
    auto source = source_;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        const auto to = next[cellNumber(x[i])]++;
        x_[to] = x[i];
        source_[to] = source[i];
    }
}

std::array<long, 3> Interpolator::cellOf(const Vector<3>& x) const
{
    std::array<long, 3> cell;
    for (int k = 0; k < 3; ++k)
    {
        const auto c = components3[k];
        cell[k] = long(std::clamp((x.*c - origin_.*c) / cellSize_.*c, 0.0, double(cells_[k] - 1)));
    }
    return cell;
}

Vector<3> Interpolator::wrapped(Vector<3> x) const
{
    for (const auto c : components3)
        if (period_.*c > 0) x.*c -= period_.*c * std::floor((x.*c - low_.*c) / period_.*c);
    return x;
}

PointWeights Interpolator::weights(const Vector<3>& point, Interpolation form, const Admits& admits) const
{
    PointWeights result;
    std::vector<Vector<3>> offset;
    const auto centre = wrapped(point);
    if (!std::isfinite(centre.x + centre.y + centre.z)) return {}; // it lies in no cell
    const Vector<3> reach{H_, H_, H_};
    const auto first = cellOf(centre - reach), last = cellOf(centre + reach);
    for (long cz = first[2]; cz <= last[2]; ++cz)
        for (long cy = first[1]; cy <= last[1]; ++cy)
        {
            const auto row = std::size_t((cz * cells_[1] + cy) * cells_[0]);
            for (auto i = cellStart_[row + std::size_t(first[0])]; i < cellStart_[row + std::size_t(last[0]) + 1]; ++i)
            {
                const auto d = x_[i] - centre;
                const double r2 = dot(d, d);
                if (r2 >= H_ * H_ || (admits && !admits(source_[i], d))) continue;
                const double W = std::visit([&](const auto& kernel) { return kernel.W(std::sqrt(r2)); }, kernel_);
                result.particle.push_back(source_[i]);
                result.weight.push_back(volume_[source_[i]] * W);
                result.coverage += result.weight.back();
                offset.push_back(d / H_);
            }
        }
    if (!(result.coverage > 0)) return {};
    for (auto& w : result.weight) w /= result.coverage;
    if (form == Interpolation::linear)
    {
        if (kernel_.index() == 0) makeLinear<2>(result.weight, offset);
        else makeLinear<3>(result.weight, offset);
    }
    return result;
}

}
