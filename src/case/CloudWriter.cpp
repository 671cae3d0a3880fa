#include "Cloud.hpp"
#include "FoamHeader.hpp"
#include "OutputFile.hpp"
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{

const char* classOf(FieldClass type)
{
    switch (type)
    {
    case FieldClass::label:
        return "labelField";
    case FieldClass::scalar:
        return "scalarField";
    case FieldClass::vector:
        return "vectorField";
    case FieldClass::symmTensor:
        return "symmTensorField";
    case FieldClass::tensor:
        return "tensorField";
    }
    return "";
}

double valueOf(const FieldView& field, int c, std::size_t i) { return field.component[c] ? field.component[c][i] : 0.0; }

/// Labels are 32-bit integers on disk.
std::int32_t labelOf(const FieldView& field, std::size_t i)
{
    using limits = std::numeric_limits<std::int32_t>;
    const double value = std::round(valueOf(field, 0, i));
    if (!(value >= limits::min() && value <= limits::max()))
        throw CaseError(fmt::format("field {}: {} of particle {} is not a label", field.name, value, i));
    return std::int32_t(value);
}

/// Bit by bit: 0 and -0 are different, so that a compact list too reads back to what was in memory.
bool isUniform(const FieldView& field, std::size_t n)
{
    for (const double* values : field.component)
        for (std::size_t i = 1; values && i < n; ++i)
            if (std::bit_cast<std::uint64_t>(values[i]) != std::bit_cast<std::uint64_t>(values[0])) return false;
    return true;
}

void writeTuple(OutputFile& file, const FieldView& field, std::size_t i, int precision)
{
    const int components = componentsOf(field.type);
    for (int c = 0; c < components; ++c)
    {
        file.write(c == 0 ? "(" : " ");
        file.write(valueOf(field, c, i), precision);
    }
    file.write(")");
}

void writeValue(OutputFile& file, const FieldView& field, std::size_t i, int precision)
{
    switch (field.type)
    {
    case FieldClass::label:
        return file.write(std::int64_t(labelOf(field, i)));
    case FieldClass::scalar:
        return file.write(valueOf(field, 0, i), precision);
    default:
        return writeTuple(file, field, i, precision);
    }
}

void writeBinary(OutputFile& file, const FieldView& field, std::size_t i)
{
    if (field.type == FieldClass::label)
    {
        const auto label = labelOf(field, i);
        return file.writeBytes(&label, sizeof label);
    }
    double value[9];
    const int components = componentsOf(field.type);
    for (int c = 0; c < components; ++c) value[c] = valueOf(field, c, i);
    file.writeBytes(value, std::size_t(components) * sizeof(double));
}

/// OpenFOAM writes an empty binary list without its parentheses and ParaView wants them: both read an empty ascii list.
WriteFormat formatFor(std::size_t n, const WriteOptions& options) { return n == 0 ? WriteFormat::ascii : options.format; }

void writeField(const std::filesystem::path& folder, const std::string& location, std::size_t n, const FieldView& field,
                const WriteOptions& options)
{
    assert(int(field.component.size()) == componentsOf(field.type));
    const auto format = formatFor(n, options);
    OutputFile file(folder / field.name);
    file.write(foamHeader(format, classOf(field.type), location, field.name));
    file.write(std::int64_t(n));
    if (format == WriteFormat::binary)
    {
        file.write("\n(");
        for (std::size_t i = 0; i < n; ++i) writeBinary(file, field, i);
        file.write(")\n");
    }
    else if (n > 1 && isUniform(field, n))
    {
        file.write("{");
        writeValue(file, field, 0, options.precision);
        file.write("}\n");
    }
    else
    {
        file.write("\n(\n");
        for (std::size_t i = 0; i < n; ++i)
        {
            writeValue(file, field, i, options.precision);
            file.write("\n");
        }
        file.write(")\n");
    }
    file.close();
}

/// The class is OpenFOAM's own: its tools and ParaView accept any Cloud<...>, but the name of a known particle asks for nothing more.
/// Every particle is in the one cell of the bounding mesh, 0.
void writePositions(const std::filesystem::path& folder, const std::string& location, std::size_t n, const FieldView& positions,
                    const WriteOptions& options)
{
    const auto format = formatFor(n, options);
    OutputFile file(folder / "positions");
    file.write(foamHeader(format, "Cloud<passiveParticle>", location, "positions"));
    file.write(std::int64_t(n));
    file.write("\n(\n");
    for (std::size_t i = 0; i < n; ++i)
    {
        if (format == WriteFormat::binary)
        {
            const std::int32_t cell = 0;
            file.write("(");
            writeBinary(file, positions, i);
            file.writeBytes(&cell, sizeof cell);
            file.write(")\n");
        }
        else
        {
            writeTuple(file, positions, i, options.precision);
            file.write(" 0\n");
        }
    }
    file.write(")\n");
    file.close();
}

}

FieldView fieldView(const std::string& name, const ValueType& type, const std::vector<const double*>& component)
{
    assert(int(component.size()) == type.components);
    FieldView view{name, type.fieldClass, std::vector<const double*>(std::size_t(componentsOf(type.fieldClass)), nullptr)};
    for (std::size_t c = 0; c < component.size(); ++c) view.component[std::size_t(type.place[c])] = component[c];
    return view;
}

void writeCloud(const std::filesystem::path& timeFolder, const std::string& cloud, std::size_t n, const FieldView& positions,
                const std::vector<FieldView>& fields, const WriteOptions& options)
{
    assert(positions.type == FieldClass::vector && positions.component.size() == 3);
    const auto time = finalName(timeFolder);
    const auto folder = timeFolder / "lagrangian" / cloud;
    const auto location = fmt::format("{}/lagrangian/{}", time, cloud);
    createFolders(folder);
    writePositions(folder, location, n, positions, options);
    for (const auto& field : fields) writeField(folder, location, n, field, options);

    // Without `geometry positions;` OpenFOAM's tools look for barycentric coordinates and silently read no particles. The names of the fields
    // are for readCloud, which misses what has been lost.
    std::string names;
    for (const auto& field : fields) names += (names.empty() ? "" : " ") + field.name;
    const auto properties = timeFolder / "uniform" / "lagrangian" / cloud;
    createFolders(properties);
    writeFile(properties / "cloudProperties",
              foamHeader(WriteFormat::ascii, "dictionary", fmt::format("{}/uniform/lagrangian/{}", time, cloud), "cloudProperties") +
                  fmt::format("geometry        positions;\n\nprocessor0\n{{\n    particleCount   {};\n}}\n\nfields          ({});\n", n,
                              names));
}

}
