/// Arithmetic in dictionaries: the text of `#eval "..."` and `#eval{ ... }`.
#pragma once
#include "base/Vector.hpp"
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace sph
{

struct ExpressionError : std::runtime_error
{
    using runtime_error::runtime_error;
};

struct ExpressionValue
{
    double scalar = 0;
    /// Set where the value is a vector.
    std::optional<Vector<3>> vector = {};
};

/// The value of `text`: numbers, `$macro` and `${macro}` (looked up by name), + - * / % ^ with the usual precedence, ^ to the
/// right and before a minus sign, comparisons and && || ! (1 or 0), condition ? a : b, and functions; a misspelt function is
/// answered with their list. Throws ExpressionError: what is wrong, and where in the text.
ExpressionValue evaluate(const std::string& text, const std::function<ExpressionValue(const std::string&)>& lookUp);

}
