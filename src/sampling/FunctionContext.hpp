/// Context that every function object gets when it is made. Geometry, and what `output` refers to, must outlive it.
#pragma once
#include "case/OutputTable.hpp"
#include "sampling/FunctionObject.hpp"

namespace sph
{

struct FunctionContext
{
    std::string name; ///< the object's own, also of its folder below postProcessing/
    const Geometry& geometry;
    const std::vector<std::string>& phases; ///< only while the object is made
    OutputPlace output;

    /// postProcessing/<name>/<startTime>/<file>, whose folder is made. Asked for at the first row, so that a run that writes
    /// nothing leaves no files.
    std::filesystem::path file(const std::string& file) const;
    /// postProcessing/<name>/<current time>/<file>, whose folder is made.
    std::filesystem::path fileOfTime(const std::string& file) const;
};

}
