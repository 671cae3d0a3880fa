#include "models/scalarTransport/carriedScalar.hpp"
#include "base/CaseError.hpp"
#include "dictionary/positionExpression.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
std::string readExpression(const Dictionary& d, const std::string& key)
{
    // A scalar without `initial` starts from 0 in a single phase; with several phases each must have an entry.
    const auto text = key == "initial" ? d.get(key, "0") : d.get<std::string>(key);
    if (text.empty()) return "0"; // an error that the dictionary has reported
    try
    {
        if (evaluateAt(text, anyPlace).vector) d.error(key, "the expression gives a vector, not a number");
    }
    catch (const ExpressionError& e)
    {
        d.error(key, e.what());
        return "0";
    }
    return text;
}
}

std::vector<std::string> readInitial(const Dictionary& d, const std::vector<std::string>& phases)
{
    return ofPhases<std::string>(d, "initial", phases, readExpression);
}

Evolving carriedScalar(const StateField& value, const StateField& rate, const std::vector<std::string>& initial, const std::string& file)
{
    Evolving c{value, rate};
    c.ofMaterial = true;
    const std::string name = value.name;
    c.missing = [=](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i) try
            {
                const Vector<3> x{loading.cloud.x[i], loading.cloud.y[i], loading.cloud.z[i]};
                loading.values[0][i] = evaluateAt(initial[loading.phaseOf(i)], x).scalar;
            }
            catch (const ExpressionError& e)
            {
                throw CaseError({file, 0}, fmt::format("`initial` of {}, {}: {}", name, loading.cloud.particle(i), e.what()));
            }
    };
    c.check = [name](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i)
            if (!std::isfinite(loading.values[0][i]))
                throw CaseError(fmt::format("{} has {} {}", loading.cloud.particle(i), name, loading.values[0][i]));
    };
    c.inlet = [name](const Dictionary& d, std::size_t) { return d.get(name, units::none); };
    return c;
}

}
