/// Cases of a few hundred to a few thousand particles, as texts.
#pragma once
#include "TestCase.hpp"

namespace sph::test
{

/// Ten write times are at multiples of 0.02 s.
inline const std::string controls = "application sphFoamLike; startFrom latestTime; startTime 0; stopAt endTime; endTime 0.08;\n"
                                    "adjustTimeStep yes; writeControl adjustableRunTime; writeInterval 0.02; writeFormat binary;\n";

/// Channel between planes, driven across, with particles off their lattice and in motion, so that lists are rebuilt between
/// write times.
inline Files channelCase()
{
    return {
        {"system/controlDict", controls},
        {"system/sphSchemes",
         "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\nwallVelocity secondOrder;\nintegration { scheme "
         "predictorCorrector; }\n"},
        {"system/packParticlesDict",
         "lattice cubic; jitter 0.1; velocity { type taylorGreen; U 1; L 1; }\nfill ( { region all; phase water; } );\n"},
        {"constant/geometry", "dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x); }\nwalls\n{\n    bottom { type "
                              "plane; point (0 0 0); normal (0 1 "
                              "0); }\n    top { type plane; point (0 1 0); normal (0 -1 0); }\n}\n"},
        {"constant/phaseProperties", "phases (water);\nwater { rho 1000; mu 10; soundSpeed 15; }\n"},
        {"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (1 0 0);\n"},
    };
}

/// The channel heated from below and cooled from above by a given flux, under gravity that acts on buoyancy as much as on motion.
inline Files convectionCase()
{
    auto files = channelCase();
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -1 0);\n";
    files["constant/thermophysicalProperties"] =
        "kappa 20; Cp 2; initial \"310 - 10*$y + sin(6*$x)\";\nequationOfState { type Boussinesq; beta "
        "0.1; T0 305; }\nwalls { bottom { T 310; } top { q -200; } }\n";
    return files;
}

/// A drop on the floor of a channel, with gas above: interface stress, contact angles of both walls, gravity.
inline Files dropCase()
{
    auto files = channelCase();
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 3; kernel wendlandC2; }\nintegration { scheme predictorCorrector; }\n";
    files["system/packParticlesDict"] =
        "lattice cubic; jitter 0.1;\nfill\n(\n    { region all; phase gas; }\n    { region sphere; centre (0.5 0 0); radius "
        "0.4; phase liquid; U (1 0 0); }\n);\n";
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x); }\nwalls\n{\n    bottom { type plane; point (0 0 0); "
        "normal (0 "
        "1 0); contactAngle 60; }\n    top { type plane; point (0 1 0); normal (0 -1 0); contactAngle 120; }\n}\n";
    files["constant/phaseProperties"] =
        "phases (liquid gas);\nliquid { rho 1; mu 0.05; soundSpeed 20; }\ngas { rho 0.5; mu 0.05; soundSpeed 20; exponent "
        "1.4; }\nsigma ( (liquid gas) 1 );\n";
    return files;
}

/// A liquid without its gas: a drop on the floor, and one in flight across the sides, which ends at its own momentum alone.
inline Files dropsAloneCase()
{
    auto files = dropCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 3; kernel wendlandC2; }\ngas none;\nintegration { scheme predictorCorrector; }\n";
    files["system/packParticlesDict"] =
        "lattice cubic; jitter 0.1;\nfill\n(\n    { region sphere; centre (0.5 0 0); radius 0.35; phase liquid; U (1 0 0); }\n"
        "    { region sphere; centre (0 0.6 0); radius 0.2; phase liquid; U (-1 0 0); }\n    { region sphere; centre (1 0.6 0); radius 0.2; phase "
        "liquid; U (-1 0 0); }\n);\n";
    files["constant/phaseProperties"] = "phases (liquid);\nliquid { rho 1; mu 0.05; soundSpeed 20; sigma 1; }\n";
    return files;
}

/// The channel full of powder in a binder, which migrates as far as it is sheared, from a disordered start.
inline Files suspensionCase()
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.6; kernel quinticSpline; }\nshifting 2;\nintegration { scheme semiImplicit; }\n";
    files["constant/phaseProperties"] = "phases (feedstock);\nfeedstock { rho 1000; mu 10; soundSpeed 15; }\n";
    auto& packing = files["system/packParticlesDict"];
    packing.replace(packing.find("phase water"), 11, "phase feedstock");
    files["constant/transportProperties"] =
        "suspension\n{\n    phi 0.4;\n    phiMax 0.68;\n    exponent 1.82;\n    Dc 0.4;\n    Deta 0.62;\n    radius 0.05;\n    a "
        "radius;\n}\n";
    return files;
}

/// Sand that fills the lower half of a box with smooth sides and a rough floor, stirred.
inline Files soilCase()
{
    auto files = channelCase();
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\n";
    files["system/packParticlesDict"] =
        "lattice cubic; jitter 0.1; velocity { type taylorGreen; U 1; L 1; }\nfill ( { region box; min (0 0 "
        "0); max (1 0.5 0); phase sand; } );\n";
    files["constant/geometry"] = "dimension 2; domain { min (0 0 0); max (1 1 0); }\nwalls\n{\n    bottom { type plane; point (0 0 0); "
                                 "normal (0 1 0); }\n    left { type plane; point (0 0 0); normal (1 0 0); slip yes; }\n    right { type "
                                 "plane; point (1 0 0); normal (-1 0 0); slip yes; }\n}\n";
    files["constant/phaseProperties"] = "phases (sand);\nsand { rho 1850; stress constitutiveLaw; }\n";
    files["constant/soilProperties"] = "rho 1850;\nlaw wuBauer;\nwuBauerCoeffs { c1 -69.4; c2 -673.1; c3 -655.9; c4 699.6; }\n"
                                       "initialStress { type geostatic; surface 0.5; }\n";
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);\n";
    return files;
}

/// Soil that a wall under load pushes, and that is dug out beside it.
inline Files loadedSoilCase()
{
    auto files = soilCase();
    auto& geometry = files["constant/geometry"];
    geometry.replace(geometry.find("normal (-1 0 0); slip yes;"), 26,
                     "normal (-1 0 0); slip yes; load { force \"1e5*$t\"; direction (-1 0 0); mass 100; damping 10; }");
    files["constant/soilProperties"] += "excavation { where \"$x > 0.7 && $y > 0.5 - 5*$t\"; }\n";
    return files;
}

/// A suspension that comes into a channel through an inlet and leaves it through an outlet.
inline Files openCase()
{
    auto files = suspensionCase();
    files["constant/geometry"] =
        "dimension 2; domain { min (-0.2 0 0); max (1.2 1 0); }\nwalls\n{\n    bottom { type plane; point (0 0 0); normal "
        "(0 1 0); }\n    top { type plane; point (0 1 0); normal (0 -1 0); }\n}\n";
    files["constant/openings"] =
        "gate\n{\n    type inlet;\n    point (0 0 0);\n    normal (1 0 0);\n    velocity 3;\n    pressure 3e4;\n    profile developed;\n    phi "
        "0.45;\n}\nvent\n{\n    type outlet;\n    point (1 0 0);\n    normal (-1 0 0);\n    pressure 100;\n}\n";
    return files;
}

/// An empty channel, closed at its end, that fills through an inlet: three particles stand in its plane at the start.
inline Files fillingCase()
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\nshifting 2; shiftingAtSurface tangential;\nintegration { scheme "
        "semiImplicit; }\n";
    files["system/packParticlesDict"] = "lattice cubic; fill ( { region box; min (-0.1 0.5 0); max (0.05 0.55 0); phase water; } );\n";
    files["constant/geometry"] =
        "dimension 2; domain { min (-0.2 0 0); max (1 1 0); }\nwalls\n{\n    bottom { type plane; point (0 0 0); normal "
        "(0 1 0); }\n    top { type plane; point (0 1 0); normal (0 -1 0); }\n    end { type plane; point (1 0 0); normal (-1 0 0); }\n}\n";
    files["constant/openings"] = "gate { type inlet; point (0 0 0); normal (1 0 0); velocity 3; }\n";
    return files;
}

/// The same case with walls of particles in layers.
inline Files inLayers(Files files)
{
    auto& schemes = files["system/sphSchemes"];
    if (const auto at = schemes.find("wallVelocity secondOrder;"); at != std::string::npos) schemes.replace(at, 25, "");
    schemes += "walls layers;\n";
    return files;
}

/// Two layers of the same viscosity that come in through one inlet and leave together.
inline Files layersCase()
{
    auto files = openCase();
    files.erase("constant/transportProperties");
    files.erase("constant/g");
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel quinticSpline; }\nintegration { scheme semiImplicit; }\n";
    files["system/packParticlesDict"] =
        "lattice cubic; fill ( { region all; phase water; } { region box; min (-9 0.5 0); max (9 9 0); phase gas; } );\n";
    files["constant/phaseProperties"] =
        "phases (water gas); water { rho 100; mu 10; soundSpeed 15; } gas { rho 10; mu 10; soundSpeed 50; }\n";
    files["constant/openings"] =
        "gate\n{\n    type inlet;\n    point (0 0 0);\n    normal (1 0 0);\n    velocity 0.5;\n    profile developed;\n    phase water;\n    layers\n    "
        "(\n        { phase gas; min (-9 0.5 0); max (9 9 0); }\n    );\n}\nvent\n{\n    type outlet;\n    point (1 0 0);\n    normal (-1 0 0);\n    "
        "pressure 0;\n    backflow gas;\n}\n";
    return files;
}

/// Water drips into gas above an outlet; the plane it drips from is open to the gas.
inline Files dripCase()
{
    auto files = layersCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\nsurfaceTension curvature;\nintegration { scheme semiImplicit; }\n";
    files["system/packParticlesDict"] = "lattice cubic; allowEmpty yes; fill ( { region all; phase gas; } );\n";
    files["constant/geometry"] =
        "dimension 2; domain { min (0 -0.6 0); max (1 1.6 0); }\nwalls\n{\n    left { type plane; point (0 0 0); normal (1 0 "
        "0); contactAngle 90; }\n    right { type plane; point (1 0 0); normal (-1 0 0); contactAngle 90; }\n}\n";
    files["constant/phaseProperties"] =
        "phases (water gas); water { rho 100; mu 1; soundSpeed 10; } gas { rho 1; mu 0.1; soundSpeed 30; exponent 1.4; "
        "}\nsigma ( (water gas) 4 );\n";
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -1 0);\n";
    files["constant/openings"] =
        "drip\n{\n    type drip;\n    points ((0.5 1 0));\n    radius 0.15;\n    normal (0 -1 0);\n    flowRate 0.12;\n    phase water;\n}\nsky\n{\n    "
        "type outlet;\n    point (0 1 0);\n    normal (0 -1 0);\n    backflow gas;\n}\ndrain\n{\n    type outlet;\n    point (0 0 0);\n    normal (0 1 "
        "0);\n    backflow gas;\n}\n";
    return files;
}

/// A liquid without its gas drips into what is empty at the start, and leaves below.
inline Files dripAloneCase()
{
    auto files = dripCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\ngas none;\nintegration { scheme implicit; tolerance 1e-7; }\n";
    files["system/packParticlesDict"] = "lattice cubic; allowEmpty yes; fill ( { region all; phase none; } );\n";
    files["constant/phaseProperties"] = "phases (water); water { rho 100; mu 1; soundSpeed 80; sigma 4; }\n";
    files["constant/openings"] =
        "drip\n{\n    type drip;\n    points ((0.5 1 0));\n    radius 0.15;\n    normal (0 -1 0);\n    flowRate 2.4;\n    phase water;\n}\n"
        "drain\n{\n    type outlet;\n    point (0 0.4 0);\n    normal (0 1 0);\n}\n";
    files["system/controlDict"] += "functions { energies { type conservation; executeControl runTime; executeInterval 0.01; } }\n";
    return files;
}

/// A grain in a periodic box: curved wall, integrated density with diffusion, shifting.
inline Files grainCase()
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.6; kernel wendlandC4; }\ndensity continuity; densityDiffusion 0.1; shifting 2;\n"
        "integration { scheme predictorCorrector; }\n";
    files["constant/geometry"] = "dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x y); }\nwalls { grain { type "
                                 "sphere; centre (0.5 0.5 0); radius 0.25; fluid outside; } }\n";
    files["system/packParticlesDict"] = "lattice cubic; velocity { type taylorGreen; U 0.5; L 1; }\nrelax { steps 50; }\n";
    return files;
}

/// A column that falls in a closed box, with all that a free surface has.
inline Files columnCase()
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 3; kernel wendlandC2; }\nwallVelocity freeSlip; wallPressure detaching;\ndensity continuity; densityDiffusion "
        "0.1; densityDiffusionForm antuono;\nartificialViscosity 0.02; pressureGradient tensileControlled; shifting 2; shiftingAtSurface "
        "tangential;\nintegration { scheme leapfrog; }\n";
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (1 1 0); }\nwalls { tank { type box; min (0 0 0); max (1 1 0); fluid "
        "inside; } }\n";
    files["system/packParticlesDict"] = "lattice cubic; fill ( { region box; min (0 0 0); max (0.5 0.6 0); phase water; } );\npressure "
                                        "\"6000*(0.6 - $y)\";\n";
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; soundSpeed 40; }\n";
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);\n";
    return files;
}

/// Spheres on a bcc lattice in three dimensions.
inline Files bedCase()
{
    auto files = channelCase();
    files["system/controlDict"] = "application sphFoamLike; startFrom latestTime; startTime 0; stopAt endTime; endTime 0.04;\n"
                                  "adjustTimeStep yes; writeControl adjustableRunTime; writeInterval 0.01; writeFormat binary;\n";
    files["system/sphSchemes"] =
        "resolution { spacing 0.08; support 2.6; kernel wendlandC2; }\nintegration { scheme predictorCorrector; }\n";
    files["constant/geometry"] = "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x y z); }\nwalls { grains { type "
                                 "sphereBed; lattice bcc; radius "
                                 "0.35; period 1; } }\n";
    files["system/packParticlesDict"] = "lattice cubic; relax { steps 30; }\n";
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 1; soundSpeed 15; }\n";
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (200 50 0);\n";
    return files;
}

}
