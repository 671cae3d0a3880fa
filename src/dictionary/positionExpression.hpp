/// An expression of the position, `$x`, `$y`, `$z` [m], and of the time `$t` [s] where there is one.
#pragma once
#include "base/Vector.hpp"
#include "dictionary/Expression.hpp"

namespace sph
{

/// Throws ExpressionError where the text is no expression of these.
inline ExpressionValue evaluateAt(const std::string& text, const Vector<3>& x, std::optional<double> t = {})
{
    return evaluate(text,
                    [&](const std::string& name) -> ExpressionValue
                    {
                        if (name == "x") return {x.x};
                        if (name == "y") return {x.y};
                        if (name == "z") return {x.z};
                        if (name == "t" && t) return {*t};
                        throw ExpressionError("$" + name + " is unknown here. Known: $x, $y, $z" + (t ? ", $t" : ""));
                    });
}

/// Position at which an expression is tried before it is needed: nothing that users write is singular there, as it may be at the origin.
inline constexpr Vector<3> anyPlace{3.819e-4, 2.764e-4, 4.472e-4};

}
