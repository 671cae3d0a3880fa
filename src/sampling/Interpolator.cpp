#include "sampling/Interpolator.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/planesOfSymmetry.hpp"
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

/// Images of the particles within H of a plane of symmetry; those in several planes are mirrored in each.
void addMirrored(std::vector<Vector<3>>& x, std::vector<std::size_t>& source, const Shape& plane, double H)
{
    const auto n = x.size();
    for (std::size_t i = 0; i < n; ++i)
        if (const auto foot = plane.foot(x[i]); foot.distance > 0 && foot.distance < H)
        {
            x.push_back(mirrorImage(x[i], foot));
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

Interpolator::Interpolator(const ParticleView& view, Mirrored mirrored) : kernel_(kernelOf(view)), H_(view.support), volume_(view.volume)
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

    if (view.geometry && mirrored == Mirrored::atSymmetryPlanes)
        for (const auto* plane : planesOfSymmetry(*view.geometry)) addMirrored(x_, source_, *plane, H_);

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
    forEachNear(point,
                [&](std::size_t j, const Vector<3>& d, double W)
                {
                    if (admits && !admits(j, d)) return;
                    result.particle.push_back(j);
                    result.weight.push_back(volume_[j] * W);
                    result.coverage += result.weight.back();
                    offset.push_back(d / H_);
                });
    if (!(result.coverage > 0)) return {};
    for (auto& w : result.weight) w /= result.coverage;
    if (form == Interpolation::linear)
    {
        if (kernel_.index() == 0) makeLinear<2>(result.weight, offset);
        else makeLinear<3>(result.weight, offset);
    }
    return result;
}

Interpolator::Sums Interpolator::sums(const Vector<3>& point, const double* values) const
{
    Sums sums;
    forEachNear(point,
                [&](std::size_t j, const Vector<3>&, double W)
                {
                    sums.coverage += volume_[j] * W;
                    sums.ofValues += volume_[j] * W * values[j];
                });
    return sums;
}

Vector<3> Interpolator::gradient(const Vector<3>& point, double here, const double* values) const
{
    Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    const auto slope = [this](double r) { return std::visit([r](const auto& kernel) { return kernel.dWdrOverR(r); }, kernel_); };
    forEachNear(point,
                [&](std::size_t j, const Vector<3>& d, double)
                {
                    const Eigen::Vector3d offset(d.x, d.y, d.z);
                    const double weight = -volume_[j] * slope(mag(d));
                    M += weight * offset * offset.transpose();
                    b += weight * (values[j] - here) * offset;
                });
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(M);
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        if (const double lambda = eigen.eigenvalues()(k); lambda > leastEigenvalueRatio * eigen.eigenvalues()(2))
            result += eigen.eigenvectors().col(k).dot(b) / lambda * eigen.eigenvectors().col(k);
    return {result(0), result(1), result(2)};
}

std::vector<Interpolator::Range> Interpolator::rangesOfCells(const double* values) const
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Range> ranges(cellStart_.size() - 1, {infinity, -infinity});
    for (std::size_t cell = 0; cell < ranges.size(); ++cell)
        for (auto i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i)
        {
            const double value = values[source_[i]];
            ranges[cell] = {std::min(ranges[cell].low, value), std::max(ranges[cell].high, value)};
        }
    return ranges;
}

Interpolator::Range Interpolator::range(const Vector<3>& point, const std::vector<Range>& ofCells) const
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Range all{infinity, -infinity};
    forEachRow(wrapped(point),
               [&](std::size_t from, std::size_t to)
               {
                   for (auto cell = from; cell < to; ++cell)
                       all = {std::min(all.low, ofCells[cell].low), std::max(all.high, ofCells[cell].high)};
               });
    return all;
}

}
