#include "sampling/ExpressionReference.hpp"
#include "dictionary/positionExpression.hpp"
#include <fmt/format.h>

namespace sph
{

namespace entry
{
static const Text value{"value", required, "of $x $y $z [m] and $t [s]; vector(.., .., ..) for vectors as a whole"};
}

EntryList expressionReferenceEntries() { return {entry::value}; }

ExactField readExpressionReference(const Dictionary& d)
{
    const auto text = entry::value(d);
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
        if (entry::value.given(d)) entry::value.error(d, e.what());
        return {};
    }
    return [exact, where = entry::value.where(d)](const Vector<3>& x, double t)
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
