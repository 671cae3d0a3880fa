#include "FrontPosition.hpp"
#include "SampledField.hpp"
#include "readDirection.hpp"
#include <algorithm>
#include <limits>

namespace sph
{

FrontPosition::FrontPosition(const Dictionary& d, const std::vector<std::string>& phases, const std::filesystem::path& caseFolder)
    : phase_(readPhase(d, "phase", phases)),
      direction_(readDirection(d, "direction", {1, 0, 0})),
      origin_(d.get("origin", Vector<3>{})),
      table_(d.subDict("table"), caseFolder, CsvReference::Over::time)
{
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
