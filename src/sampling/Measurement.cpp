#include "Measurement.hpp"
#include "CapillaryRise.hpp"
#include "ColumnGrowth.hpp"
#include "ContactAngle.hpp"
#include "DragFactor.hpp"
#include "DropOscillation.hpp"
#include "FrontPosition.hpp"
#include "InterfaceGrowth.hpp"
#include "LaplaceJump.hpp"
#include "LiquidBridge.hpp"
#include "MigrationBalance.hpp"
#include "VortexDecay.hpp"
#include "WallDropTime.hpp"
#include <algorithm>
#include <concepts>

namespace sph
{

namespace
{

struct Entry
{
    std::string name;
    Measure (*read)(const Dictionary&, const Geometry&, const std::vector<std::string>&, const std::filesystem::path&);
};

template<class M>
Measure measure(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases, const std::filesystem::path& folder)
{
    if constexpr (std::constructible_from<M, const Dictionary&, const std::vector<std::string>&, const std::filesystem::path&>)
        return M(d, phases, folder);
    else
        return M(d, geometry, phases);
}

const std::vector<Entry>& catalogue()
{
    static const std::vector<Entry> measures{
        {"laplaceJump", measure<LaplaceJump>},
        {"contactAngle", measure<ContactAngle>},
        {"dragFactor", measure<DragFactor>},
        {"vortexDecay", measure<VortexDecay>},
        {"frontPosition", measure<FrontPosition>},
        {"dropPeriod", measure<DropPeriod>},
        {"dropDecay", measure<DropDecay>},
        {"interfaceGrowth", measure<InterfaceGrowth>},
        {"columnGrowth", measure<ColumnGrowth>},
        {"capillaryRise", measure<CapillaryRise>},
        {"bridgeNeck", measure<BridgeNeck>},
        {"bridgePressure", measure<BridgePressure>},
        {"migrationBalance", measure<MigrationBalance>},
        {"wallDropTime", measure<WallDropTime>},
    };
    return measures;
}

}

std::vector<std::string> measureNames()
{
    std::vector<std::string> names;
    for (const auto& m : catalogue()) names.push_back(m.name);
    return names;
}

Measure readMeasure(const std::string& name, const Dictionary& d, const Geometry& geometry,
                    const std::vector<std::string>& phases, const std::filesystem::path& caseFolder)
{
    for (const auto& m : catalogue())
        if (m.name == name) return m.read(d, geometry, phases, caseFolder);
    return {};
}

std::size_t readPhase(const Dictionary& d, const std::string& key, const std::vector<std::string>& phases)
{
    if (phases.empty()) return 0;
    const auto name = d.choose(key, phases, phases.front());
    return std::size_t(std::max<long>(0, std::find(phases.begin(), phases.end(), name) - phases.begin())) % phases.size();
}

}
