#include "sampling/FrontPosition.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/sharedEntries.hpp"
#include <limits>

namespace sph
{

namespace entry
{
const SubDictionary table{"table", required, "positions over time"};
}

FrontPosition::FrontPosition(const Dictionary& d, const std::vector<std::string>& phases, const std::filesystem::path& caseFolder)
    : phase_(readPhase(d, entry::phase, phases)),
      direction_(entry::direction(d)),
      origin_(entry::origin(d)),
      table_(entry::table(d), caseFolder, CsvReference::Over::time)
{}

EntryList FrontPosition::entries()
{
    return {entry::phase, entry::direction, entry::origin, {entry::table, CsvReference::entries(CsvReference::Over::time)}};
}

Measurement FrontPosition::operator()(const ParticleView& view) const
{
    Measurement result;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto isInPhase = [&](std::size_t i) { return phaseOf(view, i) == phase_; };
    const double foremost =
        most(view.n, [&](std::size_t i) { return isInPhase(i) ? dot(position(view, i) - origin_, direction_) : -infinity; });
    result.particles = count(view.n, isInPhase);
    result.value = foremost + view.spacing / 2;
    result.reference = table_.at(view.time, 0).value_or(std::numeric_limits<double>::quiet_NaN());
    return result;
}

}
