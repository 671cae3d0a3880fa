#include "packing/InitialPressure.hpp"
#include "dictionary/positionExpression.hpp"

namespace sph
{

PressureField readPressure(const Dictionary& dict)
{
    const auto text = entry::pressure(dict, "");
    const auto pressure = [text](const Vector<3>& x)
    {
        const auto value = evaluateAt(text, x);
        if (value.vector) throw ExpressionError("the expression gives a vector, not a pressure");
        return value.scalar;
    };
    try
    {
        pressure({});
    }
    catch (const ExpressionError& e)
    {
        entry::pressure.error(dict, e.what());
        return [](const Vector<3>&) { return 0.0; };
    }
    return pressure;
}

}
