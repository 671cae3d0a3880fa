#include "verification/NormalMode.hpp"
#include <Eigen/LU>

namespace sph
{

Complex mismatch(const std::array<AtInterface, 2>& first, const std::array<AtInterface, 2>& second, double K, Complex s)
{
    Eigen::Matrix4cd M;
    for (int k = 0; k < 4; ++k)
    {
        const auto& a = k < 2 ? first[std::size_t(k)] : second[std::size_t(k - 2)];
        const double sign = k < 2 ? 1 : -1;
        const Complex answer = k < 2 ? K / s * a.normalVelocity : 0.0;
        M.col(k) << sign * a.normalVelocity, sign * a.tangentialVelocity, sign * a.shearStress, sign * a.normalStress + answer;
    }
    // Rows of different units: their size is no part of the answer.
    for (int row = 0; row < 4; ++row) M.row(row) /= M.row(row).cwiseAbs().maxCoeff();
    return M.determinant();
}

Complex rateNear(Complex start, const std::function<Complex(Complex)>& f)
{
    Complex a = start, b = 1.001 * start, fa = f(a), fb = f(b);
    for (int iteration = 0; iteration < 100 && fb != fa && std::abs(b - a) > 1e-13 * std::abs(b); ++iteration)
    {
        const Complex next = b - fb * (b - a) / (fb - fa);
        a = b;
        fa = fb;
        b = next;
        fb = f(b);
    }
    return b;
}

}
