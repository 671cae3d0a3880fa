#include "Formulas.hpp"
#include "Couette.hpp"
#include "Hydrostatic.hpp"
#include "PlanePoiseuille.hpp"
#include "Ritter.hpp"
#include "RotatingSquarePatch.hpp"
#include "SuspensionChannel.hpp"
#include "TaylorGreen.hpp"
#include "TwoLayerPoiseuille.hpp"
#include "words.hpp"
#include <fmt/format.h>

namespace sph
{

namespace
{

struct Formula
{
    std::string name, field;
    ExactField (*read)(const Dictionary&);
};

template<class Solution> ExactField velocity(const Dictionary& dictionary)
{
    return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return solution.velocity(x, t); };
}

template<class Solution> ExactField pressure(const Dictionary& dictionary)
{
    return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return Vector<3>{solution.pressure(x, t), 0, 0}; };
}

template<class Solution> ExactField scalar(const Dictionary& dictionary)
{
    return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return Vector<3>{solution.value(x, t), 0, 0}; };
}

const std::vector<Formula>& catalogue()
{
    static const std::vector<Formula> formulas{
        {"planePoiseuille", "U", velocity<PlanePoiseuille>},
        {"twoLayerPoiseuille", "U", velocity<TwoLayerPoiseuille>},
        {"couette", "U", velocity<Couette>},
        {"taylorGreen", "U", velocity<TaylorGreen>},
        {"taylorGreen", "p", pressure<TaylorGreen>},
        {"hydrostatic", "p", pressure<Hydrostatic>},
        {"ritter", "U", velocity<Ritter>},
        {"ritter", "p", pressure<Ritter>},
        {"suspensionChannel", "phi", scalar<SuspensionChannel>},
        {"suspensionChannel", "U", velocity<SuspensionChannel>},
        {"rotatingSquarePatch", "p", pressure<RotatingSquarePatch>},
    };
    return formulas;
}

}

std::vector<std::string> formulaNames()
{
    std::vector<std::string> names;
    for (const auto& f : catalogue())
        if (names.empty() || names.back() != f.name) names.push_back(f.name);
    return names;
}

ExactField readFormula(const std::string& name, const Dictionary& dictionary, const std::string& field)
{
    std::vector<std::string> fields;
    for (const auto& f : catalogue())
    {
        if (f.name != name) continue;
        if (f.field == field) return f.read(dictionary);
        fields.push_back(f.field);
    }
    dictionary.error("name", fmt::format("formula \"{}\" gives {}, not {}", name, list(fields), field));
    return {};
}

}
