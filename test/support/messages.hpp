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

/// All errors that were recorded.
inline std::string messages(const Diagnostics& diagnostics)
{
    return messageOf([&] { diagnostics.throwIfAny(); });
}

}
