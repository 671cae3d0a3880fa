#include "packing/InitialVelocity.hpp"
#include "dictionary/positionExpression.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

namespace entry
{
const VectorParameter velocityValue{"value", units::mPerS, required, "velocity"},
    omega{"omega", units::none / units::s, required, "rate of rotation"},
    origin{"origin", units::m, Vector<3>{}, "point that coordinates count from"};
const Scalar U{"U", units::mPerS, required, "largest velocity"}, L{"L", units::m, required, positive, "period of the vortices"},
    height{"height", units::m, required, positive, "from origin to the other plate"};
const Direction direction{"direction", Vector<3>{1, 0, 0}, "along the flow"},
    velocityNormal{"normal", Vector<3>{0, 1, 0}, "across the flow"};
const Text expression{"U", required, "velocity [m/s], \"vector(sin(2*pi()*$x), 0, 0)\"; $x, $y, $z are the position [m]"};

/// The types of velocity, with what each needs.
static const Cases& velocities()
{
    static const Cases all{{"uniform", {velocityValue}},
                           {{"taylorGreen", "u = U sin(kx) cos(ky), v = -U cos(kx) sin(ky), k = 2 pi/L"}, {U, L}},
                           {{"rotation", "omega x (x - origin)"}, {omega, origin}},
                           {{"couette", "from 0 at the origin to U at the height"}, {U, height, direction, velocityNormal, origin}},
                           {{"poiseuille", "4 U s (1 - s), s the height above the origin in heights"},
                            {U, height, direction, velocityNormal, origin}},
                           {"expression", {expression}}};
    return all;
}
static const Choice& type()
{
    static const Choice choice{"type", wordsOf(velocities()), required, "of the velocity"};
    return choice;
}
}

namespace
{
/// u(s) along `direction`, s being the height above `origin` along `normal` in units of `height`.
VelocityField sheared(const Dictionary& dict, double (*profile)(double s))
{
    const double U = entry::U(dict), height = entry::height(dict);
    const auto direction = entry::direction(dict), normal = entry::velocityNormal(dict), origin = entry::origin(dict);
    return [=](const Vector<3>& x) { return U * profile(dot(x - origin, normal) / height) * direction; };
}

VelocityField byExpression(const Dictionary& dict)
{
    const auto text = entry::expression(dict);
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
        if (entry::expression.given(dict)) entry::expression.error(dict, e.what());
        return [](const Vector<3>&) { return Vector<3>{}; };
    }
    return valueAt;
}
}

EntryList velocityEntries() { return {{entry::type(), entry::velocities()}}; }

VelocityField readVelocity(const Dictionary& dict)
{
    const auto type = entry::type()(dict);
    if (type == "taylorGreen")
    {
        const double U = entry::U(dict), k = 2 * std::numbers::pi / entry::L(dict);
        return [=](const Vector<3>& x) {
            return Vector<3>{U * std::sin(k * x.x) * std::cos(k * x.y), -U * std::cos(k * x.x) * std::sin(k * x.y), 0};
        };
    }
    if (type == "rotation")
    {
        const auto omega = entry::omega(dict), origin = entry::origin(dict);
        return [=](const Vector<3>& x) { return cross(omega, x - origin); };
    }
    if (type == "couette") return sheared(dict, [](double s) { return s; });
    if (type == "poiseuille") return sheared(dict, [](double s) { return 4 * s * (1 - s); });
    if (type == "expression") return byExpression(dict);
    const auto value = entry::velocityValue(dict);
    return [=](const Vector<3>&) { return value; };
}

}
