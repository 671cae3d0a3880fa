#include "sampling/Formulas.hpp"
#include "base/words.hpp"
#include <fmt/format.h>

namespace sph
{

namespace
{
std::vector<Formula>& registered()
{
    static std::vector<Formula> all;
    return all;
}
}

AddedFormula::AddedFormula(const Formula& formula) { registered().push_back(formula); }
const std::vector<Formula>& allFormulas() { return registered(); }

Cases formulas()
{
    Cases all;
    for (const auto& f : registered())
        if (!all.empty() && all.back().first.word == f.name) all.back().first.meaning += " and " + f.field;
        else all.push_back({{f.name, "gives " + f.field}, f.entries()});
    return all;
}

ExactField readFormula(const std::string& name, const Dictionary& dictionary, const std::string& field)
{
    std::vector<std::string> fields;
    for (const auto& f : registered())
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
