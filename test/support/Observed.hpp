/// A function object by itself, with particles made by hand.
#pragma once
#include "Particles.hpp"
#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"
#include <gtest/gtest.h>
#include <memory>

namespace sph
{

/// One function object in a case of its own.
template<class Object> struct Observed
{
    TemporaryCase folder;
    Case theCase{folder.folder()};
    RunTime time{theCase};

    std::string mistakesIn(const Particles& particles, const std::string& text)
    {
        made(particles, text);
        return errorsOf(theCase.diagnostics());
    }
    std::unique_ptr<Object> made(const Particles& particles, const std::string& text)
    {
        const auto d = Dictionary::parse(text, "system/controlDict", theCase.sharedDiagnostics());
        auto object = std::make_unique<Object>(d, FunctionContext{"own", particles.geometry, particles.phases, outputOf(time)});
        d.reportUnused();
        return object;
    }
    std::vector<std::vector<std::string>> rowsOf(const Particles& particles, const std::string& text)
    {
        const auto object = made(particles, text);
        EXPECT_EQ(errorsOf(theCase.diagnostics()), "");
        object->execute(particles.view());
        return folder.rows("postProcessing/own/0/" + Object::table().file);
    }
    std::string refusalOf(const Particles& particles, const std::string& text)
    {
        const auto object = made(particles, text);
        EXPECT_EQ(errorsOf(theCase.diagnostics()), "");
        try
        {
            object->execute(particles.view());
        }
        catch (const CaseError& error)
        {
            return error.what();
        }
        return "";
    }
};

}
