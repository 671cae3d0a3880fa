#include "readDecomposition.hpp"
#include "Parameter.hpp"
#include "Ranks.hpp"
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Count numberOfSubdomains{"numberOfSubdomains", byScene("as many as mpirun has started"), atLeast(1), "ranks"};
const Choice method{"method",
                    {{"rcb", "boxes: the longest side is cut in two, and so are both parts, until there is one for each"}},
                    "rcb",
                    "how space is cut"};
const Scalar maxImbalance{"maxImbalance", units::none, Settings{}.maxImbalance, atLeast(1),
                          "processor time of the busiest rank over their mean from which on space is cut anew"};
}

EntryList decompositionEntries() { return {entry::numberOfSubdomains, entry::method, entry::maxImbalance}; }

void readDecomposition(const Case& theCase, Settings& settings)
{
    if (!ranks() || !theCase.has(decompositionDictionary)) return;
    const auto dict = theCase.dictionary(decompositionDictionary);
    const int count = ranks()->count();
    if (const int asked = entry::numberOfSubdomains(dict, count); asked != count)
        entry::numberOfSubdomains.error(dict, fmt::format("says {} ranks, and the run was started with {}", asked, count));
    entry::method(dict);
    settings.maxImbalance = entry::maxImbalance(dict);
    dict.reportUnused();
}

}
