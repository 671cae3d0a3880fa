#include "Parsed.hpp"
#include "dictionary/addDefaults.hpp"

using namespace sph;

// What the file says stays, sub-dictionaries merge, and defaults that nobody reads are no mistakes.
TEST(DictionaryDefaults, fillWhatIsMissing)
{
    Parsed file("a 1; inner { b 2; }"), defaults("a 10; c 30; inner { b 20; d 40; e 50; } other { f 60; }");
    addDefaults(file.dict, defaults.dict);
    EXPECT_EQ(file.dict.get<double>("a"), 1);
    EXPECT_EQ(file.dict.get<double>("c"), 30);
    EXPECT_EQ(file.dict.subDict("inner").get<double>("b"), 2);
    EXPECT_EQ(file.dict.subDict("inner").get<double>("d"), 40);
    file.dict.reportUnused();
    EXPECT_EQ(file.errors(), "");
}
