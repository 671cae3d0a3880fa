/// A dictionary from text, and the messages that reading it left, for the tests of this folder.
#pragma once
#include "dictionary/Dictionary.hpp"
#include <gtest/gtest.h>

namespace sph
{

struct Parsed
{
    std::shared_ptr<Diagnostics> diagnostics = std::make_shared<Diagnostics>();
    Dictionary dict;

    explicit Parsed(const std::string& text, const std::string& file = "constant/d") : dict(Dictionary::parse(text, file, diagnostics)) {}

    /// All errors, as the user sees them; empty where there is none.
    std::string errors() const
    {
        try
        {
            diagnostics->throwIfAny();
        }
        catch (const CaseError& e)
        {
            return e.what();
        }
        return "";
    }
};

}
