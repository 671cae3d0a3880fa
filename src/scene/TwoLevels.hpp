/// Steps from two levels of the past: Verlet's scheme as SPH codes have it, eq. (19) of Peng, Wu & Yu (2014), for steps of any length.
///
///   q^(n+1) = q^(n-1) + (dt_0 + dt) dq/dt^n,    dt_0 [s] the step from n-1 to n, dt that from n to n+1
///
/// Of second order where steps change their length smoothly; a sudden change leaves (dt^2 - dt_0^2)/2 d^2q/dt^2 between odd and even steps, once. The first step, and each `every`-th, is the
/// re-coupling step q^n + dt dq/dt^n, dt_0 = 0.
///
/// Nothing but re-coupling damps what alternates: odd and even steps hang together by rates alone. A field that decays by a rate lambda makes it grow by
///
///   r = lambda dt + sqrt(1 + (lambda dt)^2)
///
/// a step, and a re-coupling step leaves lambda dt/2 of it: stable where r^every lambda dt/2 < 1. Verified by test/unit/integrators (Step).
#pragma once
#include "scene/RunningModel.hpp"
#include "scene/State.hpp"
#include <cmath>
#include <utility>

namespace sph
{

/// Name of the field of q^n - q^(n-1), which is state: what models change at the end of a step so changes both levels alike.
inline std::string incrementOf(const StateField& q) { return q.name + "Increment"; }

class TwoLevels
{
    int every_, since_ = 0;
    double last_ = 0;

public:
    explicit TwoLevels(int every) : every_(every) {}

    /// dt_0 of a step that is about to be made; 0 of a re-coupling one.
    double next(double deltaT)
    {
        const bool recouples = last_ == 0 || since_ + 1 >= every_;
        since_ = recouples ? 0 : since_ + 1;
        return std::exchange(last_, deltaT) * !recouples;
    }
    /// The largest lambda dt with r^every lambda dt/2 < 1/2.
    double stableDecay() const
    {
        double low = 0, high = 1;
        for (int bisections = 0; bisections < 50; ++bisections)
        {
            const double y = 0.5 * (low + high);
            (every_ * std::asinh(y) + std::log(y) < 0 ? low : high) = y;
        }
        return low;
    }
    void save(Numbers& numbers) const
    {
        numbers["levelsDeltaT"] = last_;
        numbers["stepsSinceRecoupling"] = since_;
    }
    void restore(const Numbers& numbers)
    {
        if (const auto last = numbers.find("levelsDeltaT"), since = numbers.find("stepsSinceRecoupling");
            last != numbers.end() && since != numbers.end())
        {
            last_ = last->second;
            since_ = int(since->second);
        }
    }
};

}
