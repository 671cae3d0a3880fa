#include "PairLimit.hpp"
#include <cmath>

namespace sph
{

void PairLimit::evaluate()
{
    const std::size_t n = x.size();
    ax.resize(n);
    ay.resize(n);
    az.resize(n);
    rate.resize(n);
    const double k = -5 * 21 / (16 * M_PI) / (h * h * h * h * h), inverse = 1 / h, nu = 0.01;
    const double *px = x.data(), *py = y.data(), *pz = z.data(), *pu = u.data(), *pv = v.data(), *pw = w.data(), *pp = p.data(),
                 *pr = rho.data();
    for (std::size_t i = 0; i < n; ++i)
    {
        const double xi = px[i], yi = py[i], zi = pz[i], ui = pu[i], vi = pv[i], wi = pw[i], pi = pp[i], ri = pr[i];
        double sx = 0, sy = 0, sz = 0, sr = 0;
        const int* l = list.data() + begin[i];
        const int m = begin[i + 1] - begin[i];
#pragma omp simd reduction(+ : sx, sy, sz, sr)
        for (int t = 0; t < m; ++t)
        {
            const int j = l[t];
            const double dx = xi - px[j], dy = yi - py[j], dz = zi - pz[j], r2 = dx * dx + dy * dy + dz * dz;
            const double b = std::fmax(0.0, 1 - 0.5 * inverse * std::sqrt(r2)), f = k * b * b * b;
            const double du = ui - pu[j], dv = vi - pv[j], dw = wi - pw[j];
            const double pressure = -(pi + pp[j]) * f, viscous = nu * f * 4 / (ri + pr[j]) * (r2 / (r2 + 0.01 * h * h));
            sx += pressure * dx + viscous * du;
            sy += pressure * dy + viscous * dv;
            sz += pressure * dz + viscous * dw;
            sr += (du * dx + dv * dy + dw * dz) * f;
        }
        ax[i] = sx;
        ay[i] = sy;
        az[i] = sz;
        rate[i] = sr;
    }
}

}
