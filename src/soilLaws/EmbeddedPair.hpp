/// Embedded pairs of explicit Runge-Kutta formulas, whose last stage is the first of the next step (FSAL), and the integration by them with control of
/// the error.
///
///   k_s = f(t + c_s h, y + h sum_j a_sj k_j),   y(t + h) = the argument of the last stage,   error = h sum_s e_s k_s
///
///   dormandPrince    order 5, error by order 4, 7 stages: Dormand & Prince (1980)
///   bogackiShampine  order 3, error by order 2, 4 stages: Bogacki & Shampine (1989)
///
/// Verified by test/unit/soilLaws (orders on an equation with a known solution).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

namespace sph
{

struct EmbeddedPair
{
    const char *name, *meaning;
    int stages, order;
    double firstStrain; ///< largest |strain| of the first substep; a good start wastes fewest stages on hypoplastic soil
    std::array<double, 7> c;
    std::array<std::array<double, 6>, 7> a;
    std::array<double, 7> e;
};

inline constexpr EmbeddedPair dormandPrince{"dormandPrince",
                                            "5(4)",
                                            7,
                                            5,
                                            4e-3,
                                            {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1},
                                            {{{},
                                              {1. / 5},
                                              {3. / 40, 9. / 40},
                                              {44. / 45, -56. / 15, 32. / 9},
                                              {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
                                              {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
                                              {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}}},
                                            {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40}};

inline constexpr EmbeddedPair bogackiShampine{"bogackiShampine",
                                              "3(2), cheaper where errors of 1e-4 will do",
                                              4,
                                              3,
                                              2e-3,
                                              {0, 1. / 2, 3. / 4, 1},
                                              {{{}, {1. / 2}, {0, 3. / 4}, {2. / 9, 1. / 3, 4. / 9}}},
                                              {-5. / 72, 1. / 12, 1. / 9, -1. / 8}};

/// Number of substeps of an integration; not resolved: substeps became too short, or too many.
struct SubSteps
{
    int accepted = 0, rejected = 0;
    bool resolved = true;
};

/// Solves dy/dt = f(t, y) from t = 0 to 1. `error(e, y)` is the error e of a substep that ends at y over what is tolerated; above 1, or not a number, the substep is
/// repeated, shorter. One whose end `admits` denies is quartered. `settle(y)` may then change what has been accepted, and says whether it has; by
/// `ends(y)` nothing more is to come.
template<class State>
SubSteps integrate(const EmbeddedPair& pair, State& y, double firstStep, const auto& f, const auto& error, const auto& admits,
                   const auto& settle, const auto& ends)
{
    constexpr double shortest = 1e-14, safety = 0.9, mostGrowth = 5, leastGrowth = 0.2;
    SubSteps taken;
    constexpr int most = 100000; // soil strained by 0.1 takes some hundred
    double t = 0, h = std::min(1.0, firstStep);
    std::array<State, 7> k{f(0, y)};
    while (true)
    {
        if (h < shortest || taken.accepted + taken.rejected >= most)
        {
            taken.resolved = false;
            break;
        }
        const bool last = h >= 1 - t;
        if (last) h = 1 - t;
        auto end = y;
        for (int s = 1; s < pair.stages; ++s)
        {
            end = y;
            for (int j = 0; j < s; ++j)
                if (pair.a[s][j] != 0) end += h * pair.a[s][j] * k[j];
            k[s] = f(t + pair.c[s] * h, end);
        }
        State e = h * pair.e[0] * k[0];
        for (int s = 1; s < pair.stages; ++s) e += h * pair.e[s] * k[s];
        const double err = error(e, end);
        const bool admitted = admits(end);
        const auto growth = [&] { return safety * std::pow(err, -1.0 / pair.order); };
        if (admitted && err <= 1)
        {
            ++taken.accepted;
            y = end;
            const bool changed = settle(y);
            if (last || ends(y)) break; // most steps are one substep: nothing is prepared for another
            t += h;
            k[0] = changed ? f(t, y) : k[pair.stages - 1];
            h *= std::fmin(mostGrowth, growth());
            continue;
        }
        ++taken.rejected;
        h *= admitted ? std::fmax(leastGrowth, growth()) : 0.25; // fmax: growth is not a number where the error is not
    }
    return taken;
}

}
