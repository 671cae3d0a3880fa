#include "decomposition/readDecomposition.hpp"
#include "dictionary/Parameter.hpp"
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Count numberOfSubdomains{"numberOfSubdomains", byScene("as many as mpirun has started; needed by decomposeParticles"), atLeast(1),
                               "ranks, and folders processor0, processor1, .."};
/// Words in the order of Division.
const Choice method{
    "method",
    {{"rcb", "boxes: the longest side is cut in two, and so are both parts, until there is one for each"},
     {"rib", "the same across the longest axis of inertia: for bodies that lie askew"},
     {"hilbert", "pieces of a space-filling curve"}},
    "rcb",
    "how decomposeParticles divides particles between folders; ranks at work see each other through boxes, and cut space as by rcb "
    "whatever this says"};
const Scalar maxImbalance{
    "maxImbalance", units::none, Decomposition{}.maxImbalance, atLeast(1),
    "processor time that the busiest rank has lately taken over their mean: beyond it space is cut anew once the others have "
    "waited for longer than a cut takes; decomposeParticles divides evenly"};
}

EntryList decompositionEntries() { return {entry::numberOfSubdomains, entry::method, entry::maxImbalance}; }

Decomposition readDecomposition(const Case& theCase, std::optional<int> ranks)
{
    Decomposition d;
    if (ranks && !theCase.has(decompositionDictionary)) return {.parts = *ranks};
    const auto dict = theCase.dictionary(decompositionDictionary);
    d.parts = ranks ? entry::numberOfSubdomains(dict, *ranks) : entry::numberOfSubdomains.needed(dict);
    if (ranks && d.parts != *ranks)
        entry::numberOfSubdomains.error(dict, fmt::format("says {} ranks, and the run was started with {}", d.parts, *ranks));
    d.method = Division(entry::method.index(dict));
    d.maxImbalance = entry::maxImbalance(dict);
    dict.reportUnused();
    return d;
}

}
