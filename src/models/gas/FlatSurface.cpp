#include "models/gas/FlatSurface.hpp"
#include "kernels/overLattice.hpp"
#include "kernels/overPlane.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <vector>

namespace sph
{

namespace
{
/// A row of a half lattice: its depth in spacings, and what its particles have of the sums of the bulk.
struct Row
{
    double z, g, s;
};

using Normal = std::array<int, 3>;

/// Rows of the half lattice n.x < depth, for a particle at the origin.
template<int dim> std::vector<Row> rowsBelow(const Normal& normal, const Kernel<dim>& kernel, double dx)
{
    const double length = std::sqrt(double(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2])), row = 1 / length;
    const int reach = int(kernel.support() / dx) + 1, deep = dim == 3 ? reach : 0;
    const double W_0 = sumOverLattice(kernel, dx, [&](double r) { return kernel.W(r); });
    std::vector<Row> rows;
    for (double z = 0.5 * row; z < kernel.support() / dx; z += row)
    {
        double W = 0;
        std::array<double, 3> g{};
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j)
                for (int k = -deep; k <= deep; ++k)
                {
                    if ((i * normal[0] + j * normal[1] + k * normal[2]) / length > z) continue;
                    const double r = dx * std::sqrt(double(i * i + j * j + k * k)), slope = -kernel.dWdrOverR(r);
                    W += kernel.W(r);
                    g[0] += slope * dx * i;
                    g[1] += slope * dx * j;
                    g[2] += slope * dx * k;
                }
        rows.push_back({z, std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]), W / W_0});
    }
    return rows;
}

/// Coefficients q_k of least squares of sum_k q_k f_k = y over the rows; `of(row)` gives f and y, both times the row's weight.
template<std::size_t n> std::array<double, n> fit(const std::vector<Row>& rows, const auto& of)
{
    Eigen::MatrixXd A(rows.size(), n);
    Eigen::VectorXd y(rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r)
    {
        const auto [f, value] = of(rows[r]);
        for (std::size_t k = 0; k < n; ++k) A(Eigen::Index(r), Eigen::Index(k)) = f[k];
        y(Eigen::Index(r)) = value;
    }
    const Eigen::VectorXd q = A.colPivHouseholderQr().solve(y);
    std::array<double, n> result;
    std::copy(q.begin(), q.end(), result.begin());
    return result;
}

template<int dim> FlatSurface flatSurface(const Kernel<dim>& kernel, double dx)
{
    FlatSurface surface;
    surface.support = kernel.support();
    surface.normalisation = std::pow(dx, dim) * momentOnLattice(kernel, dx);
    surface.slope = integralOverPlane(kernel) / std::pow(dx, dim);
    std::vector<Row> rows;
    for (const Normal& normal :
         dim == 3 ? std::array<Normal, 3>{{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}}} : std::array<Normal, 3>{{{1, 0, 0}, {1, 1, 0}, {2, 1, 0}}})
        for (const auto& row : rowsBelow(normal, kernel, dx)) rows.push_back(row);
    const auto share = [&](const Row& row) { return surface.share(row.g); };
    surface.density = fit<3>(rows,
                             [&](const Row& row)
                             {
                                 const double t = share(row);
                                 return std::pair(std::array{t, t * t, t * t * t}, 1 - row.s);
                             });
    surface.depth = fit<4>(rows,
                           [&](const Row& row)
                           {
                               const double weight = std::sqrt(share(row)), q = 1 - weight, f = weight * std::sqrt(q);
                               return std::pair(std::array{f, f * q, f * q * q, f * q * q * q}, weight * row.z * dx / surface.support);
                           });
    for (const auto& row : rows)
    {
        const double t = share(row);
        surface.densityMisfit = std::max(surface.densityMisfit, std::abs(1 - row.s - surface.lackOfDensity(t)));
        if (t > 0.01) surface.depthMisfit = std::max(surface.depthMisfit, std::abs(row.z - surface.depthAt(t) / dx));
    }
    return surface;
}
}

FlatSurface FlatSurface::of(const std::string& kernel, int dimension, double H, double spacing)
{
    return dimension == 2 ? flatSurface(Kernel<2>(kernel, H), spacing) : flatSurface(Kernel<3>(kernel, H), spacing);
}

}
