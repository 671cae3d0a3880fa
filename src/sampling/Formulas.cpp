#include "sampling/Formulas.hpp"
#include "base/words.hpp"
#include "sampling/Couette.hpp"
#include "sampling/Hydrostatic.hpp"
#include "sampling/PlanePoiseuille.hpp"
#include "sampling/Ritter.hpp"
#include "sampling/RotatingSquarePatch.hpp"
#include "sampling/SuspensionChannel.hpp"
#include "sampling/TaylorGreen.hpp"
#include "sampling/TwoLayerPoiseuille.hpp"
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
    std::vector<std::string> idle = {}; ///< keywords that another field of the formula alone needs
};

template<class Solution> Formula velocity(const std::string& name, const std::vector<std::string>& idle = {})
{
    return {name, "U",
            [](const Dictionary& dictionary) -> ExactField
            { return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return solution.velocity(x, t); }; },
            Solution::entries, idle};
}

template<class Solution> Formula pressure(const std::string& name)
{
    return {name, "p",
            [](const Dictionary& dictionary) -> ExactField {
                return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return Vector<3>{solution.pressure(x, t), 0, 0}; };
            },
            Solution::entries};
}

template<class Solution> Formula phi(const std::string& name, const std::vector<std::string>& idle = {})
{
    return {name, "phi",
            [](const Dictionary& dictionary) -> ExactField {
                return [solution = Solution(dictionary)](const Vector<3>& x, double t) { return Vector<3>{solution.value(x, t), 0, 0}; };
            },
            Solution::entries, idle};
}

const std::vector<Formula>& catalogue()
{
    static const std::vector<Formula> all{
        velocity<PlanePoiseuille>("planePoiseuille"),
        velocity<TwoLayerPoiseuille>("twoLayerPoiseuille"),
        velocity<Couette>("couette"),
        velocity<TaylorGreen>("taylorGreen", {"rho"}),
        pressure<TaylorGreen>("taylorGreen"),
        pressure<Hydrostatic>("hydrostatic"),
        velocity<Ritter>("ritter", {"rho", "up"}),
        pressure<Ritter>("ritter"),
        phi<SuspensionChannel>("suspensionChannel", {"mu", "pressureGradient"}),
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
        if (f.field == field)
        {
            for (const auto& entry : f.idle)
                if (dictionary.found(entry))
                    dictionary.error(entry,
                                     fmt::format("{} does nothing here: {} of {} does not need it; leave it out", entry, field, name));
            return f.read(dictionary);
        }
        fields.push_back(f.field);
    }
    dictionary.error("name", fmt::format("formula \"{}\" gives {}, not {}", name, list(fields), field));
    return {};
}

}
