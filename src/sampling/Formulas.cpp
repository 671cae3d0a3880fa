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
    EntryList (*entries)();
};

template<class Solution> Formula velocity(const std::string& name)
{
    return {name, "U",
            [](const Dictionary& dictionary) -> ExactField
            { return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return solution.velocity(x, t); }; },
            Solution::entries};
}

template<class Solution> Formula pressure(const std::string& name)
{
    return {name, "p",
            [](const Dictionary& dictionary) -> ExactField {
                return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return Vector<3>{solution.pressure(x, t), 0, 0}; };
            },
            Solution::entries};
}

template<class Solution> Formula phi(const std::string& name)
{
    return {name, "phi",
            [](const Dictionary& dictionary) -> ExactField {
                return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return Vector<3>{solution.value(x, t), 0, 0}; };
            },
            Solution::entries};
}

const std::vector<Formula>& catalogue()
{
    static const std::vector<Formula> all{
        velocity<PlanePoiseuille>("planePoiseuille"),
        velocity<TwoLayerPoiseuille>("twoLayerPoiseuille"),
        velocity<Couette>("couette"),
        velocity<TaylorGreen>("taylorGreen"),
        pressure<TaylorGreen>("taylorGreen"),
        pressure<Hydrostatic>("hydrostatic"),
        velocity<Ritter>("ritter"),
        pressure<Ritter>("ritter"),
        phi<SuspensionChannel>("suspensionChannel"),
        velocity<SuspensionChannel>("suspensionChannel"),
        pressure<RotatingSquarePatch>("rotatingSquarePatch"),
    };
    return all;
}

}

Cases formulas()
{
    Cases all;
    for (const auto& f : catalogue())
        if (!all.empty() && all.back().first.word == f.name) all.back().first.meaning += " and " + f.field;
        else all.push_back({{f.name, "gives " + f.field}, f.entries()});
    return all;
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
