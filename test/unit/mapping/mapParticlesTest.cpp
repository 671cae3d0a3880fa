/// mapParticles from its command line to the folder that it writes: what goes on runs, and what does not fit is told with file and line.
#include "case/Cloud.hpp"
#include "smallCases.hpp"
#include <gtest/gtest.h>
#include <memory>
#include <numeric>

namespace sph::test
{
namespace
{

/// A case run to its end; made once.
const TestCase& ranTo(double endTime, const Files& files, std::unique_ptr<TestCase>& made)
{
    if (made) return *made;
    made = std::make_unique<TestCase>(files);
    made->replace("system/controlDict", "endTime 0.08", "endTime " + std::to_string(endTime));
    for (const char* program : {"packParticles", "meshToGhost", "sphFoamLike"}) made->runWell(program);
    return *made;
}
const TestCase& drop()
{
    static std::unique_ptr<TestCase> made;
    return ranTo(0.02, dropCase(), made);
}

/// The same scene with other particles, packed.
struct Target : TestCase
{
    explicit Target(Files files, const std::string& spacing = "0.035") : TestCase(finer(std::move(files), spacing))
    {
        for (const char* program : {"packParticles", "meshToGhost"}) runWell(program);
    }
    static Files finer(Files files, const std::string& spacing)
    {
        auto& schemes = files["system/sphSchemes"];
        schemes.replace(schemes.find("spacing 0.05"), 12, "spacing " + spacing);
        return files;
    }
    Outcome map(const TestCase& source, const std::string& arguments = "") const
    {
        return run("mapParticles", "'" + source.folder().string() + "' " + arguments);
    }
    /// That it fails, and says each of these.
    void refuses(const TestCase& source, const std::string& arguments, const std::vector<std::string>& texts) const
    {
        const auto before = files("0");
        const auto outcome = map(source, arguments);
        EXPECT_EQ(outcome.code, 1) << outcome.out;
        for (const auto& text : texts) EXPECT_NE(outcome.err.find(text), std::string::npos) << text << "\n" << outcome.err;
        EXPECT_EQ(difference(before, files("0")), "");
    }
};

Cloud read(const TestCase& c, const std::string& time)
{
    Diagnostics diagnostics;
    auto cloud = readCloud(c.folder(), time, "sph", diagnostics);
    diagnostics.throwIfAny();
    return cloud;
}

double mean(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size()); }

/// Sums of m and m U_x of a phase.
std::pair<double, double> sums(const Cloud& cloud, int phase)
{
    std::pair<double, double> sum;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (cloud.fields.at("phase").component[0][i] == phase)
        {
            const double m = cloud.fields.at("m").component[0][i];
            sum.first += m;
            sum.second += m * cloud.fields.at("U").component[0][i];
        }
    return sum;
}

}

// A drop that slides on the floor of a channel, 20 to 28.6 spacings across: mass of the liquid to half a particle, momentum to round-off; densities at
// rest; and a run goes on from there.
TEST(MapParticles, aFinerCaseGoesOn)
{
    const Target target(dropCase());
    const auto packed = read(target, "0");
    const auto outcome = target.map(drop());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* text : {"time 0.02", "liquid", "source", "interpolated", "momentum corrected", "Written to 0/lagrangian/sph", "End"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
    const auto source = read(drop(), "0.02"), mapped = read(target, "0");
    ASSERT_EQ(mapped.size(), packed.size());
    EXPECT_EQ(mapped.x, packed.x);
    const auto [mass, momentum] = sums(mapped, 0);
    const auto [massBefore, momentumBefore] = sums(source, 0);
    const double particle = *std::ranges::max_element(mapped.fields.at("m").component[0]);
    EXPECT_LE(std::fabs(mass - massBefore), 0.5 * particle * (1 + 1e-9));
    EXPECT_NEAR(momentum, momentumBefore, 1e-12);
    for (std::size_t i = 0; i < mapped.size(); ++i)
        EXPECT_EQ(mapped.fields.at("rho").component[0][i], mapped.fields.at("phase").component[0][i] == 0 ? 1 : 0.5);

    target.replace("system/controlDict", "endTime 0.08", "endTime 0.02");
    target.runWell("sphFoamLike");
    target.refuses(drop(), "", {"0.02/uniform", "is of a run"});
}

// Temperatures of a convecting channel, and the stress of settling sand: what each scene has beside U goes with it, and what follows from it does not.
TEST(MapParticles, fieldsOfTheSceneGoWithIt)
{
    static std::unique_ptr<TestCase> heated, settled;
    const auto& channel = ranTo(0.02, convectionCase(), heated);
    const Target finer(convectionCase());
    auto outcome = finer.map(channel, "-sourceTime 0.020");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Interpolated beside U: T\n"), std::string::npos) << outcome.out;
    const auto T = read(finer, "0").fields.at("T").component[0], before = read(channel, "0.02").fields.at("T").component[0];
    EXPECT_NEAR(mean(T), mean(before), 0.01);
    EXPECT_GE(*std::ranges::min_element(T), *std::ranges::min_element(before));

    const auto& sand = ranTo(0.002, soilCase(), settled);
    auto files = soilCase();
    auto& packing = files["system/packParticlesDict"];
    packing.replace(packing.find("region box; min (0 0 0); max (1 0.5 0);"), 39, "region all;");
    const Target whole(files);
    outcome = whole.map(sand);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Interpolated beside U: rho sigma\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("places left empty"), std::string::npos) << outcome.out;
    const auto cloud = read(whole, "0");
    EXPECT_LT(*std::ranges::max_element(cloud.y), 0.56);
    const auto &is = cloud.fields.at("sigma").component, was = read(sand, "0.002").fields.at("sigma").component;
    for (const std::size_t c : {0, 3}) EXPECT_NEAR(mean(is[c]), mean(was[c]), 0.02 * std::fabs(mean(was[3])));
    whole.replace("system/controlDict", "endTime 0.08", "endTime 0.0005");
    whole.runWell("sphFoamLike");
}

// A packing with a pressure at the start has V in place of rho: p is then the source's.
TEST(MapParticles, aStartByPressureHasTheSourcesPressure)
{
    auto files = dropCase();
    files["system/packParticlesDict"] += "pressure \"0\";\n";
    const Target target(files);
    const auto outcome = target.map(drop());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Interpolated beside U: p\n"), std::string::npos) << outcome.out;
    EXPECT_FALSE(target.has("0/lagrangian/sph/rho"));
    const auto p = read(target, "0").fields.at("p").component[0], before = read(drop(), "0.02").fields.at("p").component[0];
    const double range = *std::ranges::max_element(before) - *std::ranges::min_element(before);
    EXPECT_NEAR(mean(p), mean(before), 0.05 * range);
    target.replace("system/controlDict", "endTime 0.08", "endTime 0.005");
    target.runWell("sphFoamLike");
}

// A suspension that flows through a channel: powder goes with it, buffer particles beyond the planes too, which count in no sum.
TEST(MapParticles, openBoundariesGoOn)
{
    static std::unique_ptr<TestCase> made;
    const auto& source = ranTo(0.02, openCase(), made);
    const Target target(openCase());
    const auto outcome = target.map(source);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Interpolated beside U: phi\n"), std::string::npos) << outcome.out;
    const auto phi = read(target, "0").fields.at("phi").component[0], before = read(source, "0.02").fields.at("phi").component[0];
    EXPECT_NEAR(mean(phi), mean(before), 0.005); // of buffers, whose powder is 0.45 and 0.4, one case has a layer more
    EXPECT_GE(*std::ranges::min_element(phi), *std::ranges::min_element(before) - 1e-14);
    target.replace("system/controlDict", "endTime 0.08", "endTime 0.001");
    target.runWell("sphFoamLike");
}

TEST(MapParticles, saysWhatDiffers)
{
    const auto changed = [](const std::string& file, const std::string& from, const std::string& to)
    {
        auto files = dropCase();
        auto& text = files[file];
        for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
        return files;
    };
    const Target same(dropCase());
    same.refuses(drop(), "-sourceTime 0.5", {"-sourceTime", "has no particles at time 0.5. There are: 0, 0.02"});
    same.refuses(drop(), "-sourceTime last", {"\"last\" is neither a time nor latestTime"});
    same.refuses(same, "", {"is the case itself"});
    EXPECT_EQ(same.run("mapParticles", "/nowhere").code, 1);
    EXPECT_EQ(same.run("mapParticles", "").code, 1);

    const TestCase unpacked(Files{});
    for (const char* folder : {"system", "constant"}) unpacked.copyFrom(same, folder);
    unpacked.write("0/note", "");
    const auto outcome = unpacked.run("mapParticles", "'" + drop().folder().string() + "'");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("has no particles: the time folder that a run starts from is packed first, by packParticles"),
              std::string::npos)
        << outcome.err;
    same.refuses(unpacked, "", {"source case " + unpacked.folder().string(), "No time folder"});

    auto phases = changed("constant/phaseProperties", "gas", "vapour");
    phases["system/packParticlesDict"] = changed("system/packParticlesDict", "gas", "vapour")["system/packParticlesDict"];
    Target(phases).refuses(drop(), "", {"constant/phaseProperties:1: the phases (liquid vapour) are not those of", "(liquid gas)"});
    Target(changed("constant/phaseProperties", "rho 0.5", "rho 0.4"))
        .refuses(drop(), "", {"constant/phaseProperties:3: gas has 0.4 kg/m^3 at rest, and 0.5 in"});
    Target(changed("constant/geometry", "max (1 1 0)", "max (1.4 1 0)"))
        .refuses(drop(), "", {"constant/geometry:1: the domain from (0 0 0) to (1.4 1 0) is not that of", "to (1 1 0)"});
    Target(changed("constant/geometry", "top", "lid"))
        .refuses(drop(), "", {"constant/geometry:2: the walls (bottom lid) are not those of", "(bottom top)"});
    Target(changed("constant/geometry", "point (0 1 0)", "point (0 0.8 0)"))
        .refuses(drop(), "",
                 {"constant/geometry: ", "lie in the solid of this case, the deepest at", "walls of the same names are not the same"});
}

}
