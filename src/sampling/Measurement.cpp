#include "sampling/Measurement.hpp"
#include <algorithm>

namespace sph
{

namespace
{
std::vector<MeasureType>& measureTypes()
{
    static std::vector<MeasureType> all;
    return all;
}
}

AddedMeasure::AddedMeasure(const MeasureType& type) { measureTypes().push_back(type); }

Cases measures()
{
    Cases all;
    for (const auto& m : measureTypes()) all.push_back({m.name, m.entries()});
    return all;
}

std::vector<std::string> measureNames()
{
    std::vector<std::string> names;
    for (const auto& m : measureTypes()) names.push_back(m.name);
    return names;
}

Measure readMeasure(const std::string& name, const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases,
                    const std::filesystem::path& caseFolder)
{
    for (const auto& m : measureTypes())
        if (m.name == name) return m.read(d, geometry, phases, caseFolder);
    return {};
}

std::size_t readPhase(const Dictionary& d, const Word& phase, const std::vector<std::string>& phases)
{
    if (phases.empty()) return 0;
    const auto name = phase.among(d, phases, phases.front());
    return std::size_t(std::max<long>(0, std::find(phases.begin(), phases.end(), name) - phases.begin())) % phases.size();
}

}
