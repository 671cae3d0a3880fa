#include "models/tension/readTensions.hpp"
#include "base/words.hpp"
#include "models/tension/sigmaEntry.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

std::vector<double> readSurfaceTension(const Dictionary& dict, const Coefficients& c)
{
    if (entry::sigma.given(dict))
        entry::sigma.error(
            dict, "is between phases, and the gas is left out (`gas none;` of system/sphSchemes): give the liquid's own dictionary sigma");
    return {c.phases.size() == 1 ? entry::sigmaOfSurface(dict.subDict(c.phases[0])) : 0.0};
}

std::vector<double> readTensions(const Dictionary& dict, const Coefficients& c)
{
    const std::size_t n = c.phases.size();
    std::vector<double> gamma(n * n, 0.0);
    const auto before = dict.diagnostics().errors();
    const auto pairs = entry::sigma(dict);
    std::vector<bool> given(n * n, false);
    for (const auto& [first, second, value] : pairs)
    {
        const auto a = std::find(c.phases.begin(), c.phases.end(), first), b = std::find(c.phases.begin(), c.phases.end(), second);
        for (const auto& [found, word] : {std::pair(a, first), std::pair(b, second)})
            if (found == c.phases.end())
                entry::sigma.error(dict, fmt::format("phase \"{}\" is unknown. {}", word, suggestion(word, "phases", c.phases)));
        if (a == c.phases.end() || b == c.phases.end()) continue;
        const auto k = std::size_t(a - c.phases.begin()), l = std::size_t(b - c.phases.begin());
        gamma[k * n + l] = gamma[l * n + k] = value;
        given[k * n + l] = given[l * n + k] = true;
    }
    if (pairs.empty() || dict.diagnostics().errors() > before) return gamma;
    std::vector<std::string> missing;
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t l = k + 1; l < n; ++l)
            if (!given[k * n + l]) missing.push_back(fmt::format("({} {})", c.phases[k], c.phases[l]));
    if (!missing.empty())
        entry::sigma.error(dict,
                           fmt::format("sigma of {} is missing: each pair of phases has a surface tension, 0 for none", list(missing)));
    return gamma;
}

}
