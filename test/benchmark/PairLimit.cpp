#include "PairLimit.hpp"
#include <cmath>

namespace sph
{

template<class Real> void PairLimitOf<Real>::evaluate()
{
    const std::size_t n = x.size();
    ax.resize(n);
    ay.resize(n);
    az.resize(n);
    rate.resize(n);
    const Real k = Real(-5 * 21 / (16 * M_PI)) / (h * h * h * h * h), inverse = 1 / h, nu(0.01), half(0.5), none(0),
               softening = Real(0.01) * h * h;
    const Real *px = x.data(), *py = y.data(), *pz = z.data(), *pu = u.data(), *pv = v.data(), *pw = w.data(), *pp = p.data(),
               *pr = rho.data();
    for (std::size_t i = 0; i < n; ++i)
    {
        const Real xi = px[i], yi = py[i], zi = pz[i], ui = pu[i], vi = pv[i], wi = pw[i], pi = pp[i], ri = pr[i];
        Real sx = 0, sy = 0, sz = 0, sr = 0;
        const int* l = list.data() + begin[i];
        const int m = begin[i + 1] - begin[i];
#pragma omp simd reduction(+ : sx, sy, sz, sr)
        for (int t = 0; t < m; ++t)
        {
            const int j = l[t];
            const Real dx = xi - px[j], dy = yi - py[j], dz = zi - pz[j], r2 = dx * dx + dy * dy + dz * dz;
            const Real b = std::fmax(none, 1 - half * inverse * std::sqrt(r2)), f = k * b * b * b;
            const Real du = ui - pu[j], dv = vi - pv[j], dw = wi - pw[j];
            const Real pressure = -(pi + pp[j]) * f, viscous = nu * f * 4 / (ri + pr[j]) * (r2 / (r2 + softening));
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

template struct PairLimitOf<double>;
template struct PairLimitOf<float>;

PairLimitOf<float> inSinglePrecision(const PairLimit& limit)
{
    const auto rounded = [](const std::vector<double>& a) { return std::vector<float>(a.begin(), a.end()); };
    PairLimitOf<float> single;
    single.x = rounded(limit.x), single.y = rounded(limit.y), single.z = rounded(limit.z);
    single.u = rounded(limit.u), single.v = rounded(limit.v), single.w = rounded(limit.w);
    single.rho = rounded(limit.rho), single.p = rounded(limit.p);
    single.begin = limit.begin, single.list = limit.list;
    single.h = float(limit.h);
    return single;
}

}
