#include "ExpressionReference.hpp"
#include "positionExpression.hpp"

namespace sph
{

ExactField readExpressionReference(const Dictionary& d)
{
    const auto text = d.get<std::string>("value");
    const ExactField exact = [text](const Vector<3>& x, double t)
    {
        const auto value = evaluateAt(text, x, t);
        return value.vector.value_or(Vector<3>{value.scalar, 0, 0});
    };
    try
    {
        exact({}, 0);
    }
    catch (const ExpressionError& e)
    {
        if (d.found("value")) d.error("value", e.what());
        return {};
    }
    return exact;
}

}
