#include "FoamHeader.hpp"
#include "OutputFile.hpp"
#include <bit>
#include <fmt/format.h>

namespace sph
{

static_assert(std::endian::native == std::endian::little, "binary files are written as the machine holds them, and say LSB");

std::string foamHeader(WriteFormat format, const std::string& className, const std::string& location, const std::string& object)
{
    const bool binary = format == WriteFormat::binary;
    return fmt::format("FoamFile\n{{\n"
                       "    version     2.0;\n"
                       "    format      {};\n"
                       "{}"
                       "    class       {};\n"
                       "    location    \"{}\";\n"
                       "    object      {};\n"
                       "}}\n\n",
                       binary ? "binary" : "ascii", binary ? "    arch        \"LSB;label=32;scalar=64\";\n" : "", className, location,
                       object);
}

std::string finalName(const std::filesystem::path& timeFolder)
{
    const auto name = timeFolder.has_filename() ? timeFolder.filename() : timeFolder.parent_path().filename();
    return name.extension() == partialSuffix ? name.stem().string() : name.string();
}

}
