#include "case/FoamHeader.hpp"
#include "base/OutputFile.hpp"
#include "base/words.hpp"
#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <set>

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

namespace
{

/// The number after `key=` in "LSB;label=32;scalar=64".
int bitsOf(FoamScanner& in, const std::string& arch, const std::string& key, int fallback)
{
    const auto at = arch.find(key + "=");
    if (at == std::string::npos) return fallback;
    const auto bits = arch.substr(at + key.size() + 1, 2);
    if (bits != "32" && bits != "64") in.fail(fmt::format("arch \"{}\": {} must be 32 or 64", arch, key));
    return bits == "32" ? 32 : 64;
}

void readArch(FoamScanner& in, const std::string& arch, FoamHeader& header)
{
    if (arch.find("MSB") != std::string::npos) in.fail(fmt::format("arch \"{}\": big-endian data is not supported", arch));
    header.labelBits = bitsOf(in, arch, "label", 32);
    header.scalarBits = bitsOf(in, arch, "scalar", 64);
}

}

FoamHeader readFoamHeader(FoamScanner& in)
{
    if (in.peek() == '\0' || in.word() != "FoamFile" || !in.take('{')) in.fail("no FoamFile header");
    FoamHeader header;
    bool hasFormat = false;
    std::set<std::string> given;
    while (!in.take('}'))
    {
        if (in.atEnd()) in.fail("the FoamFile header does not end");
        const auto key = in.word();
        const auto value = in.word();
        const int line = in.line();
        if (key.empty() || value.empty() || !in.take(';'))
            throw ScanError(line, fmt::format("FoamFile header: expected \"keyword value;\", found \"{} {}\"", key, value));
        if (!given.insert(key).second) throw ScanError(line, fmt::format("FoamFile header: \"{}\" is given twice", key));
        if (key == "format")
        {
            static const std::vector<std::string> known{"ascii", "binary"};
            if (std::find(known.begin(), known.end(), value) == known.end())
                throw ScanError(line, fmt::format("format \"{}\" is unknown. {}", value, suggestion(value, "formats", known)));
            hasFormat = true;
            header.binary = value == "binary";
        }
        if (key == "class")
        {
            header.className = value;
            header.classLine = line;
        }
        if (key == "arch") readArch(in, value, header);
    }
    if (!hasFormat) in.fail("the FoamFile header has no \"format\"");
    if (header.className.empty()) in.fail("the FoamFile header has no \"class\"");
    return header;
}

std::string finalName(const std::filesystem::path& timeFolder)
{
    const auto name = timeFolder.has_filename() ? timeFolder.filename() : timeFolder.parent_path().filename();
    return name.extension() == partialSuffix ? name.stem().string() : name.string();
}

}
