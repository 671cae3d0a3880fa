#include "geometry/fluidFraction.hpp"
#include "geometry/components.hpp"
#include <cmath>

namespace sph
{

double fluidFraction(const Geometry& g, int n)
{
    const double ratio = g.dimension == 3 ? 1.22074408460575947536 : 1.32471795724474602596;
    double inFluid = 0;
    for (int i = 1; i <= n; ++i)
    {
        Vector<3> x;
        double step = 1;
        for (int k = 0; k < g.dimension; ++k)
        {
            step /= ratio;
            const double u = 0.5 + i * step;
            x.*component(k) = g.low.*component(k) + (u - std::floor(u)) * g.length(k);
        }
        inFluid += g.inFluid(x);
    }
    return inFluid / n;
}

}
