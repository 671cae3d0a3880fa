/// Mistakes in dictionaries: each ends with exit code 1 and the place in the file, before a particle is moved.
#include "refusal.hpp"

namespace sph::test::dictionariesTest
{
namespace
{

TEST(Dictionaries, MissingEntry)
{
    Damaged c;
    c.replace("constant/phaseProperties", "rho 1000; ", "");
    c.isRefused("sphFoamLike", {"constant/phaseProperties:2", "\"rho\""});
}

TEST(Dictionaries, MisspeltEntry)
{
    Damaged c;
    c.replace("system/sphSchemes", "wallVelocity", "wallVelocty");
    c.isRefused("sphFoamLike", {"system/sphSchemes:2", "\"wallVelocty\"", "wallVelocity"});
}

TEST(Dictionaries, WrongDimensions)
{
    Damaged c;
    c.replace("constant/phaseProperties", "rho 1000", "rho [0 2 -1 0 0 0 0] 1000");
    c.isRefused("sphFoamLike", {"constant/phaseProperties:2", "rho", "[0 2 -1 0 0 0 0]", "[1 -3 0 0 0 0 0]"});
}

TEST(Dictionaries, UnknownModel)
{
    Damaged c;
    c.replace("system/sphSchemes", "secondOrder", "secondOrdr");
    c.isRefused("sphFoamLike", {"system/sphSchemes:2", "\"secondOrdr\"", "Did you mean \"secondOrder\"?", "reflected"});
}

TEST(Dictionaries, UnknownKernel)
{
    Damaged c;
    c.replace("system/sphSchemes", "wendlandC2", "wendland2");
    c.isRefused("sphFoamLike", {"system/sphSchemes:1", "\"wendland2\"", "Did you mean \"wendlandC2\"?"});
}

TEST(Dictionaries, UnknownFunctionObject)
{
    Damaged c;
    c.write("system/controlDict", c.read("system/controlDict") + "functions { look { type eror; } }\n");
    c.isRefused("sphFoamLike", {"system/controlDict:3", "\"eror\""});
}

TEST(Dictionaries, MissingFile)
{
    for (const char* file : {"constant/phaseProperties", "system/sphSchemes", "system/controlDict"})
    {
        Damaged c;
        std::filesystem::remove(c.folder() / file);
        c.isRefused("sphFoamLike", {file});
    }
}

// All mistakes of a case are told at once.
TEST(Dictionaries, SeveralMistakesAreToldTogether)
{
    Damaged c;
    c.replace("constant/phaseProperties", "rho 1000", "rho -1000");
    c.replace("system/sphSchemes", "secondOrder", "nonsense");
    c.replace("system/controlDict", "adjustableRunTime", "adjustible");
    c.isRefused("sphFoamLike", {"constant/phaseProperties:2", "system/sphSchemes:2", "system/controlDict:2", "3 errors"});
}

TEST(Dictionaries, UnclosedBrace)
{
    Damaged c;
    c.replace("constant/phaseProperties", "soundSpeed 15; }", "soundSpeed 15;");
    c.isRefused("sphFoamLike", {"constant/phaseProperties:"});
}

TEST(Dictionaries, NumbersThatAreNone)
{
    for (const char* number : {"nan", "inf", "1e999", "ten", "-5", "0"})
    {
        Damaged c;
        c.replace("constant/phaseProperties", "soundSpeed 15", std::string("soundSpeed ") + number);
        c.isRefused("sphFoamLike", {"constant/phaseProperties:2", "soundSpeed"});
    }
}

TEST(Dictionaries, SchemesThatDoNotGoTogether)
{
    Damaged c;
    c.replace("system/sphSchemes", "integration", "surfaceTension curvature; densityDiffusion 0.1; pressureGradient monaghan; integration");
    c.isRefused("sphFoamLike", {"system/sphSchemes:2: secondOrder needs", "system/sphSchemes:3", "gives no sigma", "density continuity"});
}

// Walls made for another geometry or another resolution are refused: the solver would run with walls where there are none.
TEST(Dictionaries, StaleWalls)
{
    Damaged moved;
    moved.replace("constant/geometry", "point (0 1 0)", "point (0 1.1 0)");
    for (const std::string program : {"sphFoamLike", "sphPostProcess"})
        moved.isRefused(program, {"constant/walls", "does not belong to the present constant/geometry", "meshToGhost"});
    Damaged refined;
    refined.replace("system/sphSchemes", "spacing 0.05", "spacing 0.025");
    refined.isRefused("sphFoamLike", {"constant/walls", "meshToGhost"});
    Damaged without;
    std::filesystem::remove(without.folder() / "constant/walls");
    without.isRefused("sphFoamLike", {"constant/walls: is missing: run meshToGhost"});
}

// A period shorter than the support would need a particle's second image, and one shorter than two supports makes a particle
// its neighbour's neighbour twice. A spacing of many periods would repeat walls without end.
TEST(Dictionaries, PeriodShorterThanTheSupport)
{
    for (const char* spacing : {"0.3", "4", "1e3", "1e300"})
    {
        SCOPED_TRACE(spacing);
        Damaged c;
        c.replace("system/sphSchemes", "spacing 0.05", std::string("spacing ") + spacing);
        for (const char* application : {"packParticles", "meshToGhost", "sphFoamLike"})
            c.isRefused(application,
                        {"system/sphSchemes:1: ", spacing[1] == '.' ? "periodic length 1 m along x is less than the kernel support"
                                                                    : "larger than the domain, 1 m along x"});
    }
}

// What makes more particles than can be counted is refused by the one check of all programs, before anything is made of it.
TEST(Dictionaries, SpacingTooSmallForTheDomain)
{
    for (const char* spacing : {"1e-5", "1e-30", "1e-320"})
    {
        SCOPED_TRACE(spacing);
        Damaged c;
        c.replace("system/sphSchemes", "spacing 0.05", std::string("spacing ") + spacing);
        for (const char* application : {"packParticles", "meshToGhost", "sphFoamLike"})
            c.isRefused(application, {"system/sphSchemes:1: spacing ", "particles in the domain; at most 1e+09 are possible"});
    }
}

// Without a spacing nothing else can be made of the case: it is asked for first.
TEST(Dictionaries, NoReadableSpacing)
{
    for (const char* mistake : {"", "spacing;", "spacing ten;", "spacing 0;", "spacing -1;", "spacing [kg] 0.05;", "spcing 0.05;"})
    {
        SCOPED_TRACE(mistake);
        Damaged c;
        c.replace("constant/walls", "max (1 1 ", "max (1e-3 1 "); // 1 m for want of a spacing would be a thousand periods
        c.replace("system/sphSchemes", "spacing 0.05;", mistake);
        for (const char* application : {"packParticles", "meshToGhost", "sphFoamLike", "sphPostProcess", "reconstructSurface"})
            c.isRefused(application, {"system/sphSchemes:1: ", "spacing"});
    }
}

// In 2-D nothing moves along z: what a vector gives there is a mistake, wherever it stands.
TEST(Dictionaries, ZComponentsIn2D)
{
    struct Place
    {
        std::string file, from, to;
        std::vector<std::string> refusedBy, words;
    };
    const std::vector<Place> places{
        {"constant/g",
         "(1 0 0)",
         "(0 0 -9.81)",
         {"packParticles", "sphFoamLike"},
         {"constant/g:1: in 2-D the z component of \"value\"", "-9.81"}},
        {"constant/phaseProperties",
         "phases (water);",
         "phases (water); bodyForce (1 0 2);",
         {"sphFoamLike"},
         {"constant/phaseProperties:1: in 2-D", "\"bodyForce\""}},
        {"constant/walls", "top { velocity (0 0 0);", "top { velocity (0 0 1);", {"sphFoamLike"}, {"constant/walls:", "\"velocity\""}},
        {"constant/geometry",
         "normal (0 -1 0);",
         "normal (0 -1 0); velocity (0 0 1);",
         {"packParticles", "meshToGhost"},
         {"constant/geometry:5: in 2-D", "\"velocity\""}},
        {"system/packParticlesDict",
         "type taylorGreen; U 1; L 1;",
         "type uniform; value (1 0 1);",
         {"packParticles"},
         {"system/packParticlesDict: in 2-D", " found 1 at ("}},
        {"system/packParticlesDict",
         "phase water;",
         "phase water; U (0 0 1);",
         {"packParticles"},
         {"system/packParticlesDict: in 2-D", " found 1 at ("}}};
    for (const auto& place : places)
        for (const auto& application : place.refusedBy)
        {
            SCOPED_TRACE(place.file + " " + application);
            Damaged c;
            c.replace(place.file, place.from, place.to);
            c.isRefused(application, place.words);
        }
}

}
}
