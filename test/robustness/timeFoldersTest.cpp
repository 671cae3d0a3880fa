/// Time folders damaged at random before the solver restarts from them: it says what is wrong or goes on to its end, never anything else.
#include "case/Cloud.hpp"
#include "fuzz/Mutator.hpp"
#include "refusal.hpp"

namespace sph::test::timeFoldersTest
{
namespace
{

// The readers alone take thousands of such folders in test/robustness/fuzz; here the whole program takes a few.
TEST(Fuzz, RestartsFromDamagedTimeFolders)
{
    const auto ascii = firstWriteOf(channelCase(), "ascii");
    const std::vector<const TestCase*> good{&goodChannel(), ascii.get()};
    std::vector<std::string> names, texts;
    for (const auto& [name, text] : ascii->files("0.02"))
    {
        names.push_back(name);
        texts.push_back(text);
    }
    fuzz(30,
         [&](Mutator& mutator)
         {
             const Damaged c(*good[mutator.below(2)]);
             const auto name = mutator.oneOf(names), file = "0.02/" + name;
             switch (mutator.below(8))
             {
             case 0:
                 std::filesystem::remove(c.folder() / file);
                 break;
             case 1:
                 c.write(file, c.read("0.02/" + mutator.oneOf(names)));
                 break;
             case 2:
                 if (c.has("0/" + name)) c.write(file, c.read("0/" + name));
                 break;
             default:
                 c.write(file, mutator.of(c.read(file), texts));
             }
             const auto before = c.files("0.02");
             const auto outcome = c.run("sphFoamLike", "", 1, 10);
             EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << file << outcome.err;
             EXPECT_EQ(outcome.code == 1, outcome.err.find("--> FATAL ERROR") != std::string::npos) << outcome.err;
             EXPECT_EQ(outcome.err.find("stopped unexpectedly"), std::string::npos) << outcome.err;
             EXPECT_EQ(difference(before, c.files("0.02")), "");
             EXPECT_EQ(outcome.code == 0, c.has("0.04")) << file;
             if (outcome.code == 1) return;
             Diagnostics diagnostics;
             readCloud(c.folder(), "0.04", "sph", diagnostics);
             EXPECT_TRUE(diagnostics.ok()) << file;
         });
}

}
}
