#include "dictionary/ExpressionProgram.hpp"

namespace sph
{

ExpressionValue evaluate(const std::string& text, const std::function<ExpressionValue(const std::string&)>& lookUp)
{
    std::vector<ExpressionProgram::Values> values;
    const auto kindOf = [&](const std::string& name)
    {
        const auto value = lookUp(name);
        values.push_back({{}, value.vector.value_or(Vector<3>{value.scalar, 0, 0})});
        return value.vector ? ExpressionProgram::Kind::vector : ExpressionProgram::Kind::number;
    };
    return ExpressionProgram(text, kindOf).single(values);
}

}
