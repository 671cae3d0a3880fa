#include "decomposition/placeOfRank.hpp"
#include "base/words.hpp"
#include "decomposition/processorFolders.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <sstream>

namespace sph
{

namespace
{
/// Number of ranks that have each time.
std::map<std::string, int> countOfTimes(const Ranks& all, const std::vector<std::string>& own)
{
    std::string text = fmt::format("{}", fmt::join(own, " "));
    std::vector<std::size_t> lengths(std::size_t(all.count()));
    const std::size_t length = text.size();
    all.gatherAll(std::as_bytes(std::span(&length, 1)), std::as_writable_bytes(std::span(lengths)));
    const std::size_t longest = *std::ranges::max_element(lengths) + 1;
    text.resize(longest, ' ');
    std::string texts(longest * lengths.size(), ' ');
    all.gatherAll(std::as_bytes(std::span(text)), std::as_writable_bytes(std::span(texts)));
    std::map<std::string, int> counts;
    std::istringstream names(texts);
    for (std::string name; names >> name;) ++counts[name];
    return counts;
}
}

RunTime::Place placeOfRank(const Case& theCase, const Ranks* all)
{
    const int folders = countProcessorFolders(theCase.folder()), ranks = all ? all->count() : 1, rank = all ? all->rank() : 0;
    if (folders == 0) return {};
    if (folders != ranks)
        throw CaseError(
            fmt::format("number of processor directories = {} is not equal to the number of processors = {}. decomposeParticles -force "
                        "divides the case anew; without the directories, ranks share its time folders",
                        folders, ranks));
    readPortion(theCase, rank, folders);
    RunTime::Place place{processorFolder(rank), theCase.times(processorFolder(rank))};
    if (!all) return place;
    std::vector<std::string> ofSome;
    for (const auto& [time, count] : countOfTimes(*all, place.times))
    {
        if (count == ranks) continue;
        ofSome.push_back(time);
        std::erase(place.times, time);
    }
    if (place.times.empty())
        throw CaseError(fmt::format("no time is in all of the {} processor directories; some have {}", folders, list(ofSome)));
    if (!ofSome.empty())
        theCase.diagnostics().warning({"processor*", 0},
                                      fmt::format("times {} are not in all of the {} directories and do not count", list(ofSome), folders));
    return place;
}

}
