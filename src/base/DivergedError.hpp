/// The exception of a run that has lost its solution.
#pragma once
#include "base/CaseError.hpp"

namespace sph
{

/// A run has lost its solution: every file could be read, yet the numbers have run away. Its message begins with `mark`, by which
/// programs that run others tell a scheme beyond its stability from a mistake in a file.
class DivergedError : public CaseError
{
public:
    static constexpr const char* mark = "the solution has diverged: ";
    explicit DivergedError(const std::string& what) : CaseError(mark + what) {}
};

}
