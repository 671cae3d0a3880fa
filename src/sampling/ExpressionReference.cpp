#include "ExpressionReference.hpp"
#include "positionExpression.hpp"
#include <fmt/format.h>

namespace sph
{

ExactField readExpressionReference(const Dictionary& d)
{
    const auto text = d.get<std::string>("value");
    const auto exact = [text](const Vector<3>& x, double t)
    {
        const auto value = evaluateAt(text, x, t);
        return value.vector.value_or(Vector<3>{value.scalar, 0, 0});
    };
    try
    {
        exact(anyPlace, 1);
    }
    catch (const ExpressionError& e)
    {
        if (d.found("value")) d.error("value", e.what());
        return {};
    }
    return [exact, where = d.where("value")](const Vector<3>& x, double t)
    {
        try
        {
            return exact(x, t);
        }
        catch (const ExpressionError& e)
        {
            throw CaseError(where, fmt::format("at ({:.6g} {:.6g} {:.6g}) and {:.6g} s {}", x.x, x.y, x.z, t, e.what()));
        }
    };
}

}
