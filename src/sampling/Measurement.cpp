#include "sampling/Measurement.hpp"
#include "sampling/CapillaryRise.hpp"
#include "sampling/ColumnGrowth.hpp"
#include "sampling/ContactAngle.hpp"
#include "sampling/DragFactor.hpp"
#include "sampling/DropOscillation.hpp"
#include "sampling/EarthPressure.hpp"
#include "sampling/FrontPosition.hpp"
#include "sampling/InterfaceGrowth.hpp"
#include "sampling/LaplaceJump.hpp"
#include "sampling/LiquidBridge.hpp"
#include "sampling/LiquidLens.hpp"
#include "sampling/MigrationBalance.hpp"
#include "sampling/ModelNumber.hpp"
#include "sampling/VortexDecay.hpp"
#include "sampling/WallDropTime.hpp"
#include <algorithm>
#include <concepts>
#include <memory>

namespace sph
{

namespace
{

struct Entry
{
    std::string name;
    Measure (*read)(const Dictionary&, const Geometry&, const std::vector<std::string>&, const std::filesystem::path&);
    EntryList (*entries)();
};

template<class M>
Measure measure(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases, const std::filesystem::path& folder)
{
    std::shared_ptr<M> made;
    if constexpr (std::constructible_from<M, const Dictionary&, const std::vector<std::string>&, const std::filesystem::path&>)
        made = std::make_shared<M>(d, phases, folder);
    else made = std::make_shared<M>(d, geometry, phases);
    return {[made](const ParticleView& view) { return (*made)(view); },
            [made]() -> std::vector<std::vector<double>*>
            {
                if constexpr (requires { made->lists(); }) return made->lists();
                else return {};
            }};
}

const std::vector<Entry>& catalogue()
{
    static const std::vector<Entry> all{
        {"laplaceJump", measure<LaplaceJump>, LaplaceJump::entries},
        {"contactAngle", measure<ContactAngle>, ContactAngle::entries},
        {"dragFactor", measure<DragFactor>, DragFactor::entries},
        {"vortexDecay", measure<VortexDecay>, VortexDecay::entries},
        {"frontPosition", measure<FrontPosition>, FrontPosition::entries},
        {"dropPeriod", measure<DropPeriod>, DropPeriod::entries},
        {"dropDecay", measure<DropDecay>, DropDecay::entries},
        {"interfaceGrowth", measure<InterfaceGrowth>, InterfaceGrowth::entries},
        {"columnGrowth", measure<ColumnGrowth>, ColumnGrowth::entries},
        {"capillaryRise", measure<CapillaryRise>, CapillaryRise::entries},
        {"bridgeNeck", measure<BridgeNeck>, BridgeNeck::entries},
        {"bridgePressure", measure<BridgePressure>, BridgePressure::entries},
        {"lensAngle", measure<LensAngle>, LensAngle::entries},
        {"lensRadius", measure<LensRadius>, LensRadius::entries},
        {"migrationBalance", measure<MigrationBalance>, MigrationBalance::entries},
        {"earthPressure", measure<EarthPressure>, EarthPressure::entries},
        {"overburden", measure<Overburden>, Overburden::entries},
        {"modelNumber", measure<ModelNumber>, ModelNumber::entries},
        {"wallDropTime", measure<WallDropTime>, WallDropTime::entries},
    };
    return all;
}

}

Cases measures()
{
    Cases all;
    for (const auto& m : catalogue()) all.push_back({m.name, m.entries()});
    return all;
}

std::vector<std::string> measureNames()
{
    std::vector<std::string> names;
    for (const auto& m : catalogue()) names.push_back(m.name);
    return names;
}

Measure readMeasure(const std::string& name, const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases,
                    const std::filesystem::path& caseFolder)
{
    for (const auto& m : catalogue())
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
