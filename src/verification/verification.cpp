#include "verification/verification.hpp"
#include "sampling/Formulas.hpp"
#include "sampling/Measurement.hpp"
#include "verification/CapAngle.hpp"
#include "verification/CapillaryRise.hpp"
#include "verification/ColumnGrowth.hpp"
#include "verification/ContactAngle.hpp"
#include "verification/Couette.hpp"
#include "verification/DragFactor.hpp"
#include "verification/DrainingFilm.hpp"
#include "verification/DropOscillation.hpp"
#include "verification/EarthPressure.hpp"
#include "verification/Hydrostatic.hpp"
#include "verification/InterfaceGrowth.hpp"
#include "verification/LaplaceJump.hpp"
#include "verification/LiquidBridge.hpp"
#include "verification/LiquidLens.hpp"
#include "verification/PlanePoiseuille.hpp"
#include "verification/Ritter.hpp"
#include "verification/RotatingSquarePatch.hpp"
#include "verification/SuspensionChannel.hpp"
#include "verification/TaylorGreen.hpp"
#include "verification/TwoLayerPoiseuille.hpp"
#include "verification/WallDropTime.hpp"

namespace sph
{

namespace
{

struct All
{
    AddedFormula planePoiseuille{velocityFormula<PlanePoiseuille>("planePoiseuille")};
    AddedFormula twoLayerPoiseuille{velocityFormula<TwoLayerPoiseuille>("twoLayerPoiseuille")};
    AddedFormula couette{velocityFormula<Couette>("couette")};
    AddedFormula taylorGreen{velocityFormula<TaylorGreen>("taylorGreen", {"rho"})};
    AddedFormula taylorGreenPressure{scalarFormula<TaylorGreen, &TaylorGreen::pressure>("taylorGreen", "p")};
    AddedFormula hydrostatic{scalarFormula<Hydrostatic, &Hydrostatic::pressure>("hydrostatic", "p")};
    AddedFormula ritter{velocityFormula<Ritter>("ritter", {"rho", "up"})};
    AddedFormula ritterPressure{scalarFormula<Ritter, &Ritter::pressure>("ritter", "p")};
    AddedFormula suspensionChannel{
        scalarFormula<SuspensionChannel, &SuspensionChannel::value>("suspensionChannel", "phi", {"mu", "pressureGradient"})};
    AddedFormula suspensionVelocity{velocityFormula<SuspensionChannel>("suspensionChannel")};
    AddedFormula rotatingSquarePatch{scalarFormula<RotatingSquarePatch, &RotatingSquarePatch::pressure>("rotatingSquarePatch", "p")};

    AddedMeasure laplaceJump{measureType<LaplaceJump>("laplaceJump")};
    AddedMeasure contactAngle{measureType<ContactAngle>("contactAngle")};
    AddedMeasure capAngle{measureType<CapAngle>("capAngle")};
    AddedMeasure drainingFilm{measureType<DrainingFilm>("drainingFilm")};
    AddedMeasure dragFactor{measureType<DragFactor>("dragFactor")};
    AddedMeasure dropPeriod{measureType<DropPeriod>("dropPeriod")};
    AddedMeasure dropDecay{measureType<DropDecay>("dropDecay")};
    AddedMeasure interfaceGrowth{measureType<InterfaceGrowth>("interfaceGrowth")};
    AddedMeasure columnGrowth{measureType<ColumnGrowth>("columnGrowth")};
    AddedMeasure capillaryRise{measureType<CapillaryRise>("capillaryRise")};
    AddedMeasure bridgeNeck{measureType<BridgeNeck>("bridgeNeck")};
    AddedMeasure bridgePressure{measureType<BridgePressure>("bridgePressure")};
    AddedMeasure bridgeForce{measureType<BridgeForce>("bridgeForce")};
    AddedMeasure lensAngle{measureType<LensAngle>("lensAngle")};
    AddedMeasure lensRadius{measureType<LensRadius>("lensRadius")};
    AddedMeasure earthPressure{measureType<EarthPressure>("earthPressure")};
    AddedMeasure overburden{measureType<Overburden>("overburden")};
    AddedMeasure wallDropTime{measureType<WallDropTime>("wallDropTime")};
};

}

void addVerification() { static const All all; }

}
