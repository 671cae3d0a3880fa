/// The `FoamFile { ... }` block at the head of every file that OpenFOAM and ParaView are to read.
#pragma once
#include "case/Cloud.hpp"
#include "case/FoamScanner.hpp"
#include <string>

namespace sph
{

/// Text of a header, with `arch "LSB;label=32;scalar=64"` in a binary file. ParaView shows a cloud field under the name of `object`.
std::string foamHeader(WriteFormat, const std::string& className, const std::string& location, const std::string& object);

struct FoamHeader
{
    std::string className;
    int classLine = 0;
    bool binary = false;
    int labelBits = 32, scalarBits = 64;
};
/// Throws ScanError where it is not whole, has no `format` or `class`, or its `arch` is not one that can be read.
FoamHeader readFoamHeader(FoamScanner&);

/// Name of a time folder once it is whole: without the ".partial" that it carries while it is written.
std::string finalName(const std::filesystem::path& timeFolder);

}
