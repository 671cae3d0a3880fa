/// A number that varies with time alone, an expression of `$t` [s].
#pragma once
#include "dictionary/Expression.hpp"
#include <cmath>

namespace sph
{

/// Its value at t; `what` it is to be, "a height", stands in the message. Throws ExpressionError where the text is no such expression.
inline double numberAt(const std::string& text, double t, const std::string& what)
{
    const auto value = evaluate(text,
                                [t](const std::string& name) -> ExpressionValue
                                {
                                    if (name == "t") return {t};
                                    throw ExpressionError("$" + name + " is unknown here. Known: $t");
                                });
    if (value.vector || !std::isfinite(value.scalar)) throw ExpressionError("the result is not " + what);
    return value.scalar;
}

}
