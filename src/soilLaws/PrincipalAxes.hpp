/// Principal values and axes of a symmetric tensor, S = Q diag(s) Q^T with s_1 >= s_2 >= s_3 and the axes as columns of Q, by Jacobi's
/// rotations (Golub & Van Loan, Matrix Computations, section 8.5): to rounding also where principal values are equal, where formulas in
/// closed form lose half of the digits. Plane strain takes one rotation.
///
/// Verified by test/unit/soilLaws (random tensors, equal values).
#pragma once
#include "base/StressTensor.hpp"
#include <array>
#include <limits>

namespace sph
{

struct PrincipalAxes
{
    std::array<double, 3> values{}; ///< the largest first
    Tensor<3> axes{};               ///< columns
};

namespace detail
{
using Square3 = std::array<std::array<double, 3>, 3>;

/// Turns axes p and q so that S_pq is 0.
inline void rotateAway(Square3& S, Square3& Q, std::size_t p, std::size_t q)
{
    if (S[p][q] == 0) return;
    const double theta = (S[q][q] - S[p][p]) / (2 * S[p][q]);
    const double t = std::copysign(1 / (std::abs(theta) + std::hypot(theta, 1)), theta), c = 1 / std::sqrt(t * t + 1), s = t * c;
    const std::size_t r = 3 - p - q;
    const double pr = S[p][r], qr = S[q][r];
    S[p][p] -= t * S[p][q];
    S[q][q] += t * S[p][q];
    S[p][q] = S[q][p] = 0;
    S[p][r] = S[r][p] = c * pr - s * qr;
    S[q][r] = S[r][q] = s * pr + c * qr;
    for (auto& row : Q)
    {
        const double a = row[p], b = row[q];
        row[p] = c * a - s * b;
        row[q] = s * a + c * b;
    }
}
}

inline PrincipalAxes principalAxes(SymmTensor<3> a)
{
    detail::Square3 S{{{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}}}, Q{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr int sweeps = 12; // it takes three to five
    for (int k = 0; k < sweeps; ++k)
    {
        const double aside = std::abs(S[0][1]) + std::abs(S[0][2]) + std::abs(S[1][2]),
                     along = std::abs(S[0][0]) + std::abs(S[1][1]) + std::abs(S[2][2]);
        if (!(aside > std::numeric_limits<double>::epsilon() * 1e-2 * along)) break;
        detail::rotateAway(S, Q, 0, 1);
        detail::rotateAway(S, Q, 0, 2);
        detail::rotateAway(S, Q, 1, 2);
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return S[i][i] > S[j][j]; });
    const auto [i, j, k] = order;
    return {{S[i][i], S[j][j], S[k][k]}, {Q[0][i], Q[0][j], Q[0][k], Q[1][i], Q[1][j], Q[1][k], Q[2][i], Q[2][j], Q[2][k]}};
}

/// diag(s) in axes that are the columns of Q.
constexpr SymmTensor<3> inAxes(const std::array<double, 3>& s, Tensor<3> Q) { return rotated(SymmTensor<3>{s[0], 0, 0, s[1], 0, s[2]}, Q); }

}
