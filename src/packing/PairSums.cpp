#include "PairSums.hpp"

namespace sph
{

template<int dim>
void numberDensity(const Kernel<dim>& kernel, const NeighbourTable& table, const Points& p, const std::vector<double>& w,
                   std::vector<double>& sigma)
{
    const long n = long(table.size());
    sigma.resize(n);
    const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data(), *factor = w.data();
    std::visit(
        [&](const auto& k)
        {
            const double own = k.W(0);
#pragma omp parallel for schedule(static)
            for (long i = 0; i < n; ++i)
            {
                const auto neighbours = table.of(i);
                const int* index = neighbours.data();
                const long count = long(neighbours.size());
                const double xi = x[i], yi = y[i], zi = z[i];
                double sum = own;
#pragma omp simd reduction(+ : sum)
                for (long m = 0; m < count; ++m)
                {
                    const int j = index[m];
                    const double dx = xi - x[j], dy = yi - y[j], dz = dim == 3 ? zi - z[j] : 0;
                    sum += factor[j]*k.W(std::sqrt(dx*dx + dy*dy + dz*dz));
                }
                sigma[i] = sum;
            }
        },
        kernel.choice());
}

template<int dim>
void pressureGradient(const Kernel<dim>& kernel, const NeighbourTable& table, const Points& p, const std::vector<double>& w,
                      const std::vector<double>& P, double V0, Points& f)
{
    const long n = long(table.size());
    f.resize(n);
    const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data(), *factor = w.data(), *pressure = P.data();
    std::visit(
        [&](const auto& k)
        {
#pragma omp parallel for schedule(static)
            for (long i = 0; i < n; ++i)
            {
                const auto neighbours = table.of(i);
                const int* index = neighbours.data();
                const long count = long(neighbours.size());
                const double xi = x[i], yi = y[i], zi = z[i], Pi = pressure[i];
                double fx = 0, fy = 0, fz = 0;
#pragma omp simd reduction(+ : fx, fy, fz)
                for (long m = 0; m < count; ++m)
                {
                    const int j = index[m];
                    const double dx = xi - x[j], dy = yi - y[j], dz = dim == 3 ? zi - z[j] : 0;
                    const double a = factor[j]*(Pi + pressure[j])*k.dWdrOverR(std::sqrt(dx*dx + dy*dy + dz*dz));
                    fx += a*dx;
                    fy += a*dy;
                    fz += a*dz;
                }
                f.x[i] = V0*fx;
                f.y[i] = V0*fy;
                f.z[i] = V0*fz;
            }
        },
        kernel.choice());
}

template void numberDensity<2>(const Kernel<2>&, const NeighbourTable&, const Points&, const std::vector<double>&,
                               std::vector<double>&);
template void numberDensity<3>(const Kernel<3>&, const NeighbourTable&, const Points&, const std::vector<double>&,
                               std::vector<double>&);
template void pressureGradient<2>(const Kernel<2>&, const NeighbourTable&, const Points&, const std::vector<double>&,
                                  const std::vector<double>&, double, Points&);
template void pressureGradient<3>(const Kernel<3>&, const NeighbourTable&, const Points&, const std::vector<double>&,
                                  const std::vector<double>&, double, Points&);

}
