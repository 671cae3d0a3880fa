/// Gravity that varies with time:
///
///   g(t) = g_0 + a(t)
///
/// a [m/s^2] an expression of `$t` [s]: less the acceleration of a vessel that is shaken, in whose frame the scene is computed. A step has g(t + dt/2), which is of
/// second order; what is measured and written at its end has that of the end. Verified by test/unit/solver/shakingTest.
#pragma once
#include "base/CaseError.hpp"
#include "dictionary/positionExpression.hpp"
#include "geometry/components.hpp"
#include "scene/Particles.hpp"
#include <cctype>
#include <fmt/format.h>
#include <string>

namespace sph
{

/// g(t) [m/s^2]; g_0 where `a` is empty. Throws CaseError where the expression has no value at that time.
inline Vector<3> gravityAt(const Vector<3>& g_0, const std::string& a, double t)
{
    if (a.empty()) return g_0;
    try
    {
        if (const auto value = evaluateAt(a, anyPlace, t).vector) return g_0 + *value;
        throw ExpressionError("the result is a number, not a vector");
    }
    catch (const ExpressionError& e)
    {
        throw CaseError({"constant/g", 0}, fmt::format("\"shaking\" at {:.6g} s: {}", t, e.what()));
    }
}

template<int dim> class Shaking final : public RunningModel<dim>
{
    Vector<3> g_0_, g_;
    std::string a_;

    static std::string nameOf(int k) { return std::string("gravity") + char(std::toupper(coordinateNames[k])); }
    /// A stage that sets gravity to its value at a share of the step.
    Stage<dim> shake(const char* name, const char* equation, double share)
    {
        return {name, equation,
                [this, share](Particles<dim>& p, const Substep& s) { p.setGravity(g_ = gravityAt(g_0_, a_, s.time + share * s.deltaT)); }};
    }

public:
    Shaking(Particles<dim>& particles, const Numbers& restored, const Vector<3>& g_0, const std::string& a) : g_0_(g_0), a_(a)
    {
        g_ = gravityAt(g_0_, a_, 0);
        for (int k = 0; k < 3; ++k)
            if (const auto found = restored.find(nameOf(k)); found != restored.end()) g_.*component(k) = found->second;
        particles.setGravity(g_);
    }
    std::vector<Stage<dim>> stages(JoinPoint place) override
    {
        if (place == JoinPoint::beforeDrift) return {shake("shake", "g = g_0 + a(t + dt/2)", 0.5)};
        if (place == JoinPoint::atEnd) return {shake("shake on", "g = g_0 + a(t + dt)", 1)};
        return {};
    }
    void save(Numbers& numbers) const override
    {
        for (int k = 0; k < 3; ++k) numbers[nameOf(k)] = g_.*component(k);
    }
};

}
