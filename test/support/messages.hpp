/// What the user is told of mistakes.
#pragma once
#include "base/CaseError.hpp"
#include <string>

namespace sph
{

/// Message of the CaseError that the call throws; "" where it throws none.
std::string messageOf(const auto& call)
{
    try
    {
        call();
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

/// Whether a text holds a part, for EXPECT_PRED2.
inline bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// All errors that were recorded.
inline std::string messages(const Diagnostics& diagnostics)
{
    return messageOf([&] { diagnostics.throwIfAny(); });
}

}
