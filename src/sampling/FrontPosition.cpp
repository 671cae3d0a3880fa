#include "FrontPosition.hpp"
#include "SampledField.hpp"
#include "sharedEntries.hpp"
#include <algorithm>
#include <limits>

namespace sph
{

namespace entry
{
const SubDictionary table{"table", required, "positions over time"};
}

FrontPosition::FrontPosition(const Dictionary& d, const std::vector<std::string>& phases, const std::filesystem::path& caseFolder)
    : phase_(readPhase(d, entry::phase, phases)), direction_(entry::direction(d)), origin_(entry::origin(d)),
      table_(entry::table(d), caseFolder, CsvReference::Over::time)
{}

EntryList FrontPosition::entries()
{
    return {entry::phase, entry::direction, entry::origin, {entry::table, CsvReference::entries(CsvReference::Over::time)}};
}

Measurement FrontPosition::operator()(const ParticleView& view) const
{
    Measurement result;
    double foremost = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < view.n; ++i)
    {
        if (phaseOf(view, i) != phase_) continue;
        foremost = std::max(foremost, dot(position(view, i) - origin_, direction_));
        ++result.particles;
    }
    result.value = foremost + view.spacing / 2;
    result.reference = table_.at(view.time, 0).value_or(std::numeric_limits<double>::quiet_NaN());
    return result;
}

}
