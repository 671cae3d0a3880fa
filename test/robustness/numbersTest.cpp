/// Numbers that are none, infinite or absurd, at every entry that is a number: refused with file and line where they mean nothing, and never a
/// crash, a hang or a run that pretends to have gone well.
#include "refusal.hpp"
#include <fmt/format.h>

namespace sph::test::numbersTest
{
namespace
{

struct Entry
{
    std::string file, text, key; ///< `text` is the entry with its value
    int line;
};

const std::vector<Entry> entries{{"constant/phaseProperties", "rho 1000", "rho", 2},
                                 {"constant/phaseProperties", "mu 10", "mu", 2},
                                 {"constant/phaseProperties", "soundSpeed 15", "soundSpeed", 2},
                                 {"constant/g", "value (1 0 0)", "value", 1},
                                 {"system/sphSchemes", "spacing 0.05", "spacing", 1},
                                 {"system/sphSchemes", "support 2.6", "support", 1},
                                 {"system/controlDict", "endTime 0.04", "endTime", 1},
                                 {"system/controlDict", "writeInterval 0.02", "writeInterval", 2}};

void put(const Damaged& c, const Entry& entry, const std::string& number)
{
    const auto value = entry.text.substr(entry.key.size() + 1);
    c.replace(entry.file, entry.text, entry.key + (value[0] == '(' ? " (" + number + " 0 0)" : " " + number));
}

TEST(Numbers, NotANumberAndInfinite)
{
    for (const auto& entry : entries)
        for (const char* number : {"nan", "-inf", "1e999", "1e"})
        {
            SCOPED_TRACE(entry.key + " " + number);
            Damaged c;
            put(c, entry, number);
            c.isRefused("sphFoamLike", {fmt::format("{}:{}", entry.file, entry.line)});
        }
}

// Numbers that a computer can hold and no fluid can have: an error, or a result without anything that is not finite.
TEST(Numbers, Huge)
{
    for (const auto& entry : entries)
        for (const char* number : {"1e300", "-1e300", "1e-300", "0"})
        {
            if (entry.key == "endTime" && number[0] == '1' && std::string(number).find('-') == std::string::npos)
                continue; // an honest wish to run for ever
            SCOPED_TRACE(entry.key + " " + number);
            Damaged c;
            put(c, entry, number);
            const auto outcome = c.run("sphFoamLike");
            EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << outcome.err;
            EXPECT_EQ(outcome.code == 1, outcome.err.find("--> FATAL ERROR") != std::string::npos) << outcome.err;
            EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
        }
}

TEST(Numbers, HugeInFieldsOfARestart)
{
    static const auto inText = firstWriteOf(channelCase(), "ascii");
    for (const char* field : {"U", "positions"})
        for (const char* number : {"1e300", "-1e20"})
        {
            SCOPED_TRACE(std::string(field) + " " + number);
            Damaged c(*inText);
            const auto file = std::string("0.02/lagrangian/sph/") + field;
            auto text = c.read(file);
            const auto at = text.find("\n(\n") + 3;
            text.replace(at, text.find('\n', at) - at, fmt::format("({} 0.5 0){}", number, std::string(field) == "positions" ? " 0" : ""));
            c.write(file, text);
            c.isRefused("sphFoamLike", {});
        }
}

}
}
