#include "InitialVelocity.hpp"
#include "positionExpression.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

namespace
{
Vector<3> unit(const Dictionary& dict, const std::string& key, const Vector<3>& fallback)
{
    const auto v = dict.get<Vector<3>>(key, fallback);
    if (mag(v) > 0) return v/mag(v);
    dict.error(key, key + " has no length, and so no direction");
    return fallback;
}

/// u(s) along `direction`, s being the height above `origin` along `normal` in units of `height`.
VelocityField sheared(const Dictionary& dict, double (*profile)(double s))
{
    const double U = dict.get("U", units::mPerS), height = dict.getPositive("height", units::m);
    const auto direction = unit(dict, "direction", {1, 0, 0}), normal = unit(dict, "normal", {0, 1, 0});
    const auto origin = dict.get<Vector<3>>("origin", {});
    return [=](const Vector<3>& x) { return U*profile(dot(x - origin, normal)/height)*direction; };
}

VelocityField byExpression(const Dictionary& dict)
{
    const auto text = dict.get<std::string>("U");
    const auto valueAt = [text](const Vector<3>& x)
    {
        const auto value = evaluateAt(text, x);
        if (!value.vector) throw ExpressionError("the expression gives a number, not a velocity: vector(.., .., ..)");
        return *value.vector;
    };
    try
    {
        valueAt({});
    }
    catch (const ExpressionError& e)
    {
        if (dict.found("U")) dict.error("U", e.what());
        return [](const Vector<3>&) { return Vector<3>{}; };
    }
    return valueAt;
}
}

const std::vector<std::string>& velocityNames()
{
    static const std::vector<std::string> names{"uniform", "taylorGreen", "rotation", "couette", "poiseuille", "expression"};
    return names;
}

VelocityField readVelocity(const Dictionary& dict)
{
    const auto type = dict.choose("type", velocityNames());
    if (type == "taylorGreen")
    {
        const double U = dict.get("U", units::mPerS), k = 2*std::numbers::pi/dict.getPositive("L", units::m);
        return [=](const Vector<3>& x) {
            return Vector<3>{U*std::sin(k*x.x)*std::cos(k*x.y), -U*std::cos(k*x.x)*std::sin(k*x.y), 0};
        };
    }
    if (type == "rotation")
    {
        const auto omega = dict.get<Vector<3>>("omega"), origin = dict.get<Vector<3>>("origin", {});
        return [=](const Vector<3>& x) { return cross(omega, x - origin); };
    }
    if (type == "couette") return sheared(dict, [](double s) { return s; });
    if (type == "poiseuille") return sheared(dict, [](double s) { return 4*s*(1 - s); });
    if (type == "expression") return byExpression(dict);
    const auto value = dict.get<Vector<3>>("value");
    return [=](const Vector<3>&) { return value; };
}

}
