/// A case that has run well to its first write time, then is damaged: the application must refuse it in words that help, and
/// leave what is on disk as it was.
#pragma once
#include "smallCases.hpp"
#include <gtest/gtest.h>
#include <memory>

namespace sph::test
{

/// A case of smallCases, packed, with walls, run to 0.02 and written in `format`.
inline std::unique_ptr<const TestCase> firstWriteOf(Files files, const std::string& format)
{
    auto& control = files["system/controlDict"];
    control.replace(control.find("0.08"), 4, "0.02");
    control.replace(control.find("binary"), 6, format);
    auto c = std::make_unique<TestCase>(files);
    c->runWell("packParticles");
    c->runWell("meshToGhost");
    c->runWell("sphFoamLike");
    c->replace("system/controlDict", "endTime 0.02", "endTime 0.04");
    return c;
}

/// The same in binary, made once.
inline const TestCase& goodChannel()
{
    static const auto made = firstWriteOf(channelCase(), "binary");
    return *made;
}

class Damaged : public TestCase
{
public:
    explicit Damaged(const TestCase& good = goodChannel()) : TestCase(Files{})
    {
        for (const auto& entry : std::filesystem::directory_iterator(good.folder())) copyFrom(good, entry.path().filename().string());
    }

    /// Exit code 1, every word in the message, time folders as they were and no new ones, no half-written ones.
    void isRefused(const std::string& application, const std::vector<std::string>& words, const std::string& arguments = "",
                   int seconds = 20) const
    {
        const auto before = timeFolders();
        const auto outcome = run(application, arguments, 1, seconds);
        EXPECT_EQ(outcome.code, 1) << outcome.err
                                   << outcome.out.substr(outcome.out.size() - std::min<std::size_t>(outcome.out.size(), 1500));
        EXPECT_NE(outcome.err.find("--> FATAL ERROR"), std::string::npos);
        for (const auto& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << "no \"" << word << "\" in:\n" << outcome.err;
        EXPECT_EQ(difference(before, timeFolders()), "");
    }

private:
    Files timeFolders() const
    {
        Files all;
        for (const auto& entry : std::filesystem::directory_iterator(folder()))
        {
            const auto name = entry.path().filename().string();
            if (name[0] < '0' || name[0] > '9') continue;
            for (const auto& [file, text] : files(name)) all[name + "/" + file] = text;
        }
        return all;
    }
};

}
