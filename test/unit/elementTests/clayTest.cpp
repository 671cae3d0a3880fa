/// Element tests of modified Cam Clay and of Mohr and Coulomb's soil: closed forms where there are some, else tables of an independent integrator of order
/// 8; to six digits at tight tolerance, and within 1e-4 by rows of 1e-2 at the default one.
#include "Largest.hpp"
#include "base/OutputFile.hpp"
#include "elementRows.hpp"
#include <fmt/format.h>

using namespace sph;
using namespace sph::test;

namespace
{

constexpr double M = 0.888, lambda = 0.161, kappa = 0.062, sixDigits = 1e-6;
const std::string londonClay =
    "rho 1900; law modifiedCamClay; modifiedCamClayCoeffs { M 0.888; lambda 0.161; kappa 0.062; nu 0.3; } floorPressure 1;";

std::string clayAt(double e, double OCR) { return fmt::format("pressure 1e5; voidRatio {}; OCR {};", e, OCR); }

// Loading beyond p_c, unloading and reloading: e by the lines of lambda and kappa, whatever the steps.
TEST(CamClay, isotropicLines)
{
    for (const std::string points : {"1", "20"})
    {
        const auto rows =
            rowsOf("type isotropic;" + clayAt(1, 2) + "meanPressure (4e5 1e5 8e5); points " + points + ";", tightly, londonClay);
        const auto e = [&](double p) { return at(rows, p).variables[0]; };
        const double atFour = 1 - kappa * std::log(2) - lambda * std::log(2);
        EXPECT_NEAR(e(4e5), atFour, 1e-9);
        EXPECT_NEAR(e(1e5), atFour + kappa * std::log(4), 1e-9);
        EXPECT_NEAR(e(8e5), atFour - lambda * std::log(2), 1e-8);
        EXPECT_LT(relative(rows.back().variables[1], 8e5), 1e-8);
    }
}

// Clay that yields from the start: p/p_1 = [(M^2 + eta_1^2)/(M^2 + eta^2)]^(1 - kappa/lambda) along the whole path, and its end, q = M p = M p_1 2^-(1 - kappa/lambda).
TEST(CamClay, undrainedPathInClosedForm)
{
    const double share = 1 - kappa / lambda;
    for (const std::string type : {"triaxialCompression", "triaxialExtension"})
    {
        const auto rows = rowsOf("type " + type + "; drainage undrained;" + clayAt(1, 1) + "strain (1); points 100;", tightly, londonClay);
        Largest error;
        for (const auto& row : rows)
        {
            const double p = -trace(row.stress) / 3, eta = deviatorStress(row.stress) / p;
            error(relative(p, 1e5 * std::pow(M * M / (M * M + eta * eta), share)));
        }
        EXPECT_LT(error.value(), sixDigits) << type;
        EXPECT_LT(relative(deviatorStress(rows.back().stress), M * 1e5 * std::pow(0.5, share)), sixDigits);
        EXPECT_NEAR(rows.back().variables[0], 1, 1e-14);
    }
}

// The critical state is where a drained test ends, from either side: q = M p, p = p_c/2, on the line of slope 3 of the stress path, and e on the critical line of its own p_c.
TEST(CamClay, criticalState)
{
    for (const double OCR : {1., 8.})
    {
        const auto end = rowsOf("type triaxialCompression;" + clayAt(0.9, OCR) + "strain (3); points 1;", tightly, londonClay).back();
        const double p = -trace(end.stress) / 3;
        EXPECT_LT(relative(p, 1e5 / (1 - M / 3)), 2e-6);
        EXPECT_LT(relative(deviatorStress(end.stress), M * p), 2e-6);
        EXPECT_LT(relative(end.variables[1], 2 * p), 1e-5);
        const double e = 0.9 - kappa * std::log(OCR) - lambda * std::log(p / (OCR * 1e5)) - (lambda - kappa) * std::log(2);
        EXPECT_NEAR(end.variables[0], e, 1e-5);
    }
}

// Rows of triaxial and oedometer tables; by rows of 1e-2 with the default tolerance where `more` says nothing else.
double clayError(const std::string& kind, const std::string& more)
{
    const auto t = table("clay/triaxial", kind + ",");
    const std::string type = kind == "oedometer"         ? "type oedometer; K 0.7;"
                             : kind == "triaxialDrained" ? "type triaxialCompression;"
                                                         : "type triaxialCompression; drainage undrained;";
    const std::string path = kind == "oedometer" ? "strain (0.02 0.05 0.1 0.08 0.12 0.2);" : "strain (0.01 0.02 0.05 0.1 0.2);";
    const std::size_t rows = kind == "oedometer" ? 6 : 5;
    Largest error;
    for (std::size_t first = 0; first < t.at("e0").size(); first += rows)
    {
        const auto got = rowsOf(type + clayAt(t.at("e0")[first], t.at("OCR")[first]) + path + (more.empty() ? "points 5;" : "points 1;"),
                                more, londonClay);
        for (std::size_t k = 0; k < rows; ++k)
        {
            const auto& row = got.at((k + 1) * (more.empty() ? 5 : 1));
            const std::size_t i = first + k;
            EXPECT_NEAR(-row.strain.zz, t.at("strain")[i], 1e-9);
            error(relative(-row.stress.zz, t.at("sz_Pa")[i]));
            error(relative(-row.stress.xx, t.at("sx_Pa")[i]));
            error(row.variables[0] - t.at("e")[i]);
            error(relative(row.variables[1], t.at("pc_Pa")[i]));
            error(-trace(row.strain) - t.at("volume_strain")[i]);
        }
    }
    return error.value();
}

TEST(CamClay, drainedUndrainedAndOedometer)
{
    for (const std::string kind : {"triaxialDrained", "triaxialUndrained", "oedometer"})
    {
        EXPECT_LT(clayError(kind, tightly), sixDigits) << kind;
        EXPECT_LT(clayError(kind, ""), 1e-4) << kind;
    }
}

TEST(CamClay, simpleShear)
{
    for (const std::string kind : {"stress", "volume"})
        for (const bool tight : {true, false})
        {
            const auto t = table("clay/shear", kind + ",");
            Largest error;
            for (std::size_t i = 0; i < t.at("gamma").size(); i += 5)
            {
                const auto rows = rowsOf((kind == "stress" ? "type simpleShear; K 0.7;" : "type constantVolumeShear; K 0.7;") +
                                             clayAt(t.at("e0")[i], t.at("OCR")[i]) +
                                             (tight ? "gamma (0.01 0.02 0.05 0.1 0.2); points 1;" : "gamma (0.2); points 20;"),
                                         tight ? tightly : "", londonClay);
                for (std::size_t k = i; k < i + 5; ++k)
                {
                    const auto& row = at(rows, t.at("gamma")[k]);
                    for (const auto& [mine, its] : {std::pair{-row.stress.xx, "sx_Pa"},
                                                    {-row.stress.yy, "sy_Pa"},
                                                    {-row.stress.zz, "sz_Pa"},
                                                    {row.stress.xz, "sxz_Pa"}})
                        error(relative(mine, t.at(its)[k]));
                    error(row.variables[0] - t.at("e")[k]);
                    error(row.strain.zz - t.at("ezz")[k]);
                }
            }
            EXPECT_LT(error.value(), tight ? sixDigits : 1e-4) << kind;
        }
}

// A path that crosses the yield surface to and fro by stress, in the same rows coarse and tight: 6 digits and 1e-4 of one another.
TEST(CamClay, constantShearModulus)
{
    const std::string law =
        "rho 1900; law modifiedCamClay; modifiedCamClayCoeffs { criticalFrictionAngle 23; lambda 0.161; kappa 0.062; shearModulus 3e6; }";
    const auto rows = rowsOf("type triaxialCompression; drainage undrained;" + clayAt(1, 2) + "strain (0.001); points 1;", "", law);
    EXPECT_LT(relative(deviatorStress(rows.back().stress), 3 * 3e6 * 1e-3), 1e-9); // within the yield surface
}

TEST(CamClay, thatCannotBe)
{
    const auto refused = [](const std::string& test, const std::string& words, const std::string& law = londonClay)
    { EXPECT_NE(refusal(test, law).find(words), std::string::npos) << refusal(test, law); };
    refused("type oedometer; pressure 1e5; strain (0.01); voidRatio 0.9; preconsolidationPressure 5e4;",
            "preconsolidation pressure 50000 Pa is below the stress: possible at p = 100000 Pa and q = 0 Pa are 100000 Pa and more");
    refused("type oedometer; pressure 1e5; strain (0.01); voidRatio 0.9;", "\"preconsolidationPressure\" is missing");
    refused("type oedometer; pressure 1e5; strain (0.01); OCR 2;", "\"voidRatio\" is missing");
    refused("type oedometer; pressure 1e5; strain (0.01); voidRatio 0.9; OCR 0.5;", "OCR");
    refused("type oedometer; pressure 1e5; strain (0.01); voidRatio 0.9; OCR 2; preconsolidationPressure 2e5;", "the past is said twice");
    refused("type triaxialCompression; pressure 1e5; voidRatio 0.9; OCR 1; deviatorStress (2e5);", "no strain rate gives");
    const auto coeffs = [](const std::string& text) { return "rho 1900; law modifiedCamClay; modifiedCamClayCoeffs { " + text + " }"; };
    const std::string good = "type oedometer; pressure 1e5; voidRatio 0.9; OCR 1; strain (0.01);";
    refused(good, "kappa 0.2 is not below lambda 0.1", coeffs("M 1; lambda 0.1; kappa 0.2; nu 0.3;"));
    refused(good, "the critical state is said twice", coeffs("M 1; criticalFrictionAngle 20; lambda 0.1; kappa 0.02; nu 0.3;"));
    refused(good, "the shear stiffness is said twice", coeffs("M 1; lambda 0.1; kappa 0.02; nu 0.3; shearModulus 1e6;"));
    refused(good, "\"nu\" is missing", coeffs("M 1; lambda 0.1; kappa 0.02;"));
}

std::string coulomb(double phi, double psi, double c, const std::string& more = "")
{
    return fmt::format(
        "rho 1900; law mohrCoulomb; mohrCoulombCoeffs {{ E 5e6; nu 0.2; frictionAngle {}; dilatancyAngle {}; cohesion {}; {} }}", phi, psi,
        c, more);
}
const std::string softening = "softening { plasticShearStrain (0.05 0.2); cohesion (7e3 2e3); frictionAngle (20 13); }";
double flowValue(double phi) { return (1 + std::sin(phi * std::numbers::pi / 180)) / (1 - std::sin(phi * std::numbers::pi / 180)); }

// Both edges and the face: strength in triaxial compression and extension and in plane strain, and the dilatancy there.
TEST(MohrCoulombTests, strength)
{
    const double p = 1e5;
    for (const double phi : {0., 20., 41.})
        for (const double psi : {0., 10., phi})
            for (const double c : {0., 7e3})
            {
                if (psi > phi || (phi == 0 && c == 0)) continue;
                SCOPED_TRACE(fmt::format("phi {} psi {} c {}", phi, psi, c));
                const double N = flowValue(phi), root = std::sqrt(N), sine = std::sin(psi * std::numbers::pi / 180);
                for (const auto& more : {tightly, std::string()})
                {
                    const double bound = more.empty() ? 1e-4 : sixDigits;
                    const auto run = [&](const std::string& type)
                    { return rowsOf("type " + type + "; pressure 1e5; strain (0.2 0.21); points 1;", more, coulomb(phi, psi, c)); };
                    const auto compressed = run("triaxialCompression");
                    EXPECT_LT(relative(compressed[2].stress.zz, -N * p - 2 * c * root), bound);
                    const auto flow =
                        compressed[2].strain - compressed[1].strain; // per axial strain the volume grows by 2 sin(psi)/(1 - sin(psi))
                    EXPECT_NEAR(trace(flow) / -flow.zz, 2 * sine / (1 - sine), bound);
                    EXPECT_NEAR(run("triaxialExtension")[2].stress.zz, (-p + 2 * c * root) / N, bound * p);
                    const auto plane = run("biaxial");
                    EXPECT_LT(relative(plane[2].stress.zz, -N * p - 2 * c * root), bound);
                    const auto shear = plane[2].strain - plane[1].strain;
                    EXPECT_NEAR((shear.xx + shear.zz) / (shear.xx - shear.zz), sine, bound);
                }
            }
}

// Without drainage and dilatancy p' stays, and q = 6 (p sin(phi) + c cos(phi))/(3 - sin(phi)); pulled apart the stress stays at the apex, or at the cut-off.
TEST(MohrCoulombTests, undrainedAndApart)
{
    const double degree = std::numbers::pi / 180, s = std::sin(20 * degree), q = 6 * (1e5 * s + 7e3 * std::cos(20 * degree)) / (3 - s);
    const auto undrained =
        rowsOf("type triaxialCompression; drainage undrained; pressure 1e5; strain (0.1); points 1;", tightly, coulomb(20, 0, 7e3)).back();
    EXPECT_LT(relative(deviatorStress(undrained.stress), q), sixDigits);
    const auto apex = rowsOf("type isotropic; pressure 1e4; strain (-0.1); points 3;", "", coulomb(20, 0, 7e3)).back();
    EXPECT_LT(norm(apex.stress - 7e3 / std::tan(20 * degree) * identity(apex.stress)), 1e-6);
    const auto cut =
        rowsOf("type isotropic; pressure 1e4; strain (-0.1); points 3;", "", coulomb(20, 0, 7e3, "tensileStrength 2e3;")).back();
    EXPECT_LT(norm(cut.stress - 2e3 * identity(cut.stress)), 1e-6);
    // Uniaxial tension with the sides free of strain: the cut-off alone along z.
    const auto pulled =
        rowsOf("type oedometer; pressure 1e4; strain (-0.01); points 3;", "", coulomb(20, 0, 7e3, "tensileStrength 2e3;")).back();
    EXPECT_LT(relative(pulled.stress.zz, 2e3), 1e-9);
}

// Softening in triaxial compression: kappa is 2/sqrt(3) (3 - sin(psi))/2/(1 - sin(psi)) of the plastic axial strain, and the axial strain q/E + that; the bounds
// as those above, by rows of 1e-2.
TEST(MohrCoulombTests, softeningInClosedForm)
{
    const double E = 5e6, p = 1e5;
    for (const bool tight : {true, false})
        for (const auto& [kappaAt, c, phi] :
             {std::tuple{0.05, 7e3, 20.}, {0.1, 7e3 - 5e3 / 3, 20 - 7. / 3}, {0.2, 2e3, 13.}, {0.25, 2e3, 13.}})
        {
            const double N = flowValue(phi), q = (N - 1) * p + 2 * c * std::sqrt(N), plastic = kappaAt * std::sqrt(3.) / 3,
                         strain = q / E + plastic;
            const auto row = rowsOf(fmt::format("type triaxialCompression; pressure 1e5; strain ({:.16g}); points {};", strain,
                                                tight ? 1 : int(std::ceil(strain / 1e-2))),
                                    tight ? tightly : "", coulomb(20, 0, 7e3, softening))
                                 .back();
            EXPECT_NEAR(row.variables[0], kappaAt, tight ? 1e-7 : 1e-4) << kappaAt;
            EXPECT_LT(relative(row.stress.xx - row.stress.zz, q), tight ? sixDigits : 1e-4) << kappaAt;
        }
}

// Turning axes: simple shear at constant stress and volume, perfect, dilatant and softening.
TEST(MohrCoulombTests, simpleShear)
{
    for (const std::string kind : {"stress", "volume"})
        for (const std::string soil : {"0,perfect", "10,perfect", "0,soft"})
            for (const bool tight : {true, false})
            {
                const auto t = table("clay/mohrCoulombShear", kind + "," + soil);
                const auto last = shortestText(t.at("gamma").back());
                const auto rows = rowsOf((kind == "stress" ? "type simpleShear;" : "type constantVolumeShear;") +
                                             std::string("pressure 1e5; K 0.6; gamma (") + last + "); points " +
                                             std::to_string(int(std::lround(t.at("gamma").back() / 1e-2))) + ";",
                                         tight ? tightly : "",
                                         coulomb(20, soil.starts_with("10") ? 10 : 0, 7e3, soil.ends_with("soft") ? softening : ""));
                Largest error;
                for (std::size_t k = 0; k < t.at("gamma").size(); ++k)
                {
                    const auto& row = at(rows, t.at("gamma")[k]);
                    for (const auto& [mine, its] : {std::pair{-row.stress.xx, "sx_Pa"},
                                                    {-row.stress.yy, "sy_Pa"},
                                                    {-row.stress.zz, "sz_Pa"},
                                                    {row.stress.xz, "sxz_Pa"}})
                        error((mine - t.at(its)[k]) / 1e5);
                    error(row.strain.zz - t.at("ezz")[k]);
                    if (soil.ends_with("soft")) error(row.variables[0] - t.at("kappa")[k]);
                }
                EXPECT_LT(error.value(), tight ? sixDigits : 1e-4) << kind << " " << soil;
            }
}

TEST(MohrCoulombTests, thatCannotBe)
{
    const std::string good = "type oedometer; pressure 1e5; strain (0.01);";
    const auto refused = [&](const std::string& law, const std::string& words)
    { EXPECT_NE(refusal(good, law).find(words), std::string::npos) << refusal(good, law); };
    refused(coulomb(20, 30, 0), "dilatancyAngle 30 is above frictionAngle 20");
    refused(coulomb(0, 0, 0), "no strength");
    refused(coulomb(20, 0, 1e3, "tensileStrength 3e3;"), "3000 Pa is above the apex, c cot(phi) = 2747.48 Pa");
    refused(coulomb(20, 0, 1e3, "bulkModulus 1e7;"), "the elasticity is said twice");
    refused(coulomb(20, 0, 1e3, "softening { plasticShearStrain (0 0.1); cohesion (1e3); }"), "1 values for 2 of plasticShearStrain");
    refused(coulomb(20, 0, 1e3, "softening { plasticShearStrain (0.1 0); }"), "is to grow from row to row");
    refused(coulomb(20, 0, 1e3, "softening { plasticShearStrain (); }"), "the table is empty");
    refused(coulomb(20, 0, 1e3, "softening { plasticShearStrain (0 0.1); dilatancyAngle (5 30); }"),
            "row 2: dilatancyAngle 30 is above frictionAngle 20");
    EXPECT_NE(refusal("type oedometer; stress (-1e4 0 0 -1e4 0 -9e5); strain (0.01);", coulomb(20, 0, 0))
                  .find("a stress within the soil's strength"),
              std::string::npos);
}

/// What the calibration of a case finds.
Fit fitOf(const Files& files)
{
    const TestCase folder(files);
    const Case c(folder.folder());
    const auto plan = readFit(c, readSoil(c.dictionary(soilProperties), "within").law);
    const auto start = startOf(c, plan.constants);
    c.diagnostics().throwIfAny();
    return fitConstants(plan, start,
                        [&](const std::vector<double>& values)
                        {
                            const Case other(folder.folder());
                            const auto soil = readSoilWith(other, plan.constants, values);
                            const auto with = readFit(other, soil.law).tests;
                            other.diagnostics().throwIfAny();
                            return std::pair(soil, with);
                        });
}

/// The tutorial's calibration with other values of the law, constants and tests.
Fit fitted(const std::string& coeffs, const std::string& constants, const std::vector<std::string>& tests,
           const std::string& law = "modifiedCamClay")
{
    const std::map<std::string, std::string> all{
        {"drained1", "type triaxialCompression; pressure 1e5; voidRatio 1.1; OCR 1;"},
        {"undrained8", "type triaxialCompression; drainage undrained; pressure 1e5; voidRatio 0.8; OCR 8;"},
        {"oedometer2", "type oedometer; pressure 1e5; K 0.7; voidRatio 1; OCR 2;"},
    };
    Files files{{soilProperties, "rho 1900;\nlaw " + law + ";\n" + law + "Coeffs { " + coeffs + " }\n"}};
    std::string text = "calibration\n{\n    constants { " + constants + " }\n    tests\n    {\n";
    for (const auto& name : tests)
    {
        const auto known = all.find(name);
        text += known == all.end() ? name + "\n" : name + " { " + known->second + " file \"" + name + ".csv\"; }\n";
        std::ifstream in(std::string(SPH_GEOMECHANICS) + "/clay/reference/" + name + ".csv");
        if (known != all.end()) files[name + ".csv"] = std::string(std::istreambuf_iterator<char>(in), {});
    }
    files[elementTestDictionary] = text + "    }\n}\n";
    return fitOf(files);
}

std::string fitRefusal(const std::string& coeffs, const std::string& constants, const std::vector<std::string>& tests,
                       const std::string& law = "modifiedCamClay")
{
    try
    {
        fitted(coeffs, constants, tests, law);
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "nothing: constants were found";
}

const std::string far = "M 1.2; lambda 0.25; kappa 0.03; nu 0.1;", four = "M (0.5 1.5); lambda (0.05 0.4); kappa (0.01 0.1); nu (0 0.45);";

// Three tests with scatter of 1 % give the constants back that they were computed with: within twice the confidence, which is what scatter of one draw leaves, and
// that is a few per cent.
TEST(FitOfConstants, fromSeveralTestsAtOnce)
{
    const auto fit = fitted(far, four, {"drained1", "undrained8", "oedometer2"});
    const double exact[]{M, lambda, kappa, 0.3};
    for (std::size_t k = 0; k < 4; ++k)
    {
        const auto& found = fit.constants[k];
        EXPECT_LT(std::abs(found.value - exact[k]), 2 * found.halfWidth) << k;
        EXPECT_LT(found.halfWidth, 0.15 * exact[k]) << k;
        EXPECT_GT(found.standardError, 0) << k;
        EXPECT_FALSE(found.onBound);
    }
    for (const auto& test : fit.misfits)
        for (const double misfit : test) EXPECT_LT(misfit, 0.02);
}

// A constant that the tests do not know is refused with the test that is missing; one outside of its bounds stays on them, and this is said.
TEST(FitOfConstants, whatCannotBeFound)
{
    const auto says = [](const std::string& message, const std::string& words)
    { EXPECT_NE(message.find(words), std::string::npos) << message; };
    EXPECT_TRUE(fitted(far, "M (1.1 1.5); lambda (0.05 0.4);", {"drained1"}).constants[0].onBound);
    says(fitRefusal("E 5e6; nu 0.2; frictionAngle 20; cohesion 7e3; tensileStrength 1e3;", "tensileStrength (1 1e4);",
                    {"a { type triaxialCompression; pressure 1e5; file \"a.csv\"; }"}, "mohrCoulomb"),
         "a.csv");
    says(fitRefusal(far, "M (0.5 1.5); lambda (0.05 0.4); kappa (0.01 0.1); mu (0 1);", {"drained1"}), "have no mu");
    says(fitRefusal(far, "M (0.5 1.1);", {"drained1"}), "M 1.2 is not between 0.5 and 1.1");
    says(fitRefusal(far, "M (1.5 0.5);", {"drained1"}), "system/elementTestDict:3: M needs its least and its largest value");
    says(fitRefusal(far, "", {"drained1"}), "no constant is sought");
    says(fitRefusal(far, "M (0.5 1.5);", {}), "there are no tests");
}

// Friction and cohesion are one in tests at one lateral pressure, and the cut-off does nothing there.
TEST(FitOfConstants, frictionNeedsTwoPressures)
{
    const std::string soil = coulomb(25, 0, 1e4);
    const auto curve = [&](double pressure)
    {
        std::string text = "strain,deviatorStress,volumeStrain\n";
        for (const auto& row :
             rowsOf("type triaxialCompression; pressure " + shortestText(pressure) + "; strain (0.1); points 10;", tightly, soil))
            text += fmt::format("{},{},{}\n", -row.strain.zz, row.stress.xx - row.stress.zz, -trace(row.strain));
        return text;
    };
    const auto of = [&](const std::string& constants, const std::vector<double>& pressures)
    {
        Files files{{soilProperties, coulomb(20, 0, 5e3, "tensileStrength 100;")}};
        std::string tests;
        for (const double p : pressures)
        {
            const auto name = "p" + shortestText(p);
            files[name + ".csv"] = curve(p);
            tests += name + " { type triaxialCompression; pressure " + shortestText(p) + "; file \"" + name + ".csv\"; }\n";
        }
        files[elementTestDictionary] = "calibration { constants { " + constants + " } tests { " + tests + " } }";
        return fitOf(files);
    };
    const auto both = of("frictionAngle (15 40); cohesion (1e3 5e4);", {1e5, 2e5});
    EXPECT_NEAR(both.constants[0].value, 25, 1e-3);
    EXPECT_NEAR(both.constants[1].value, 1e4, 2);
    const auto refused = [&](const std::string& constants, const std::string& words)
    {
        try
        {
            of(constants, {1e5});
            ADD_FAILURE() << constants;
        }
        catch (const CaseError& e)
        {
            EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
        }
    };
    refused("frictionAngle (15 40); cohesion (1e3 5e4);",
            "do not tell them apart. A test is missing: frictionAngle by triaxial tests to failure at two lateral pressures");
    refused(
        "tensileStrength (50 200);",
        "tensileStrength cannot be found: none of the tests depends on it. A test is missing: tensileStrength by a test that pulls the soil apart");
}

}
