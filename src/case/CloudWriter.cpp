#include "case/Cloud.hpp"
#include "case/FoamHeader.hpp"
#include "parallel/collated.hpp"
#include "parallel/reduce.hpp"
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <optional>

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

/// Bit by bit: 0 and -0 are different, so that a compact list too reads back to what was in memory.
struct Uniform
{
    bool any = false, uniform = true;
    std::array<std::uint64_t, 9> value{};

    Uniform() = default;
    Uniform(const FieldView& field, std::size_t n) : any(n > 0)
    {
        for (std::size_t c = 0; any && c < field.component.size(); ++c)
        {
            const double* const values = field.component[c];
            if (!values) continue;
            const auto bits = [&](std::size_t i) { return std::bit_cast<std::uint64_t>(values[i]); };
            value[c] = bits(0);
            for (std::size_t i = 1; uniform && i < n; ++i) uniform = bits(i) == value[c];
        }
    }
    void add(const Uniform& other)
    {
        if (!other.any) return;
        if (!any) *this = other;
        else uniform = uniform && other.uniform && value == other.value;
    }
};

/// The particles of this rank, of those of all.
struct Share
{
    std::size_t n, before, all;
    explicit Share(std::size_t own) : n(own), before(sumOfRanksBefore(own)), all(ofAllRanks(own, std::size_t(0), Add{})) {}

    /// Whether the first particle of all is here.
    bool hasFirst() const { return n > 0 && before == 0; }
    bool isUniform(const FieldView& field) const
    {
        return all > 1 && ofAllRanks(Uniform(field, n), Uniform(), [](Uniform& total, const Uniform& part) { total.add(part); }).uniform;
    }
    /// Labels are 32-bit integers on disk.
    std::int32_t label(const FieldView& field, std::size_t i) const
    {
        using limits = std::numeric_limits<std::int32_t>;
        const double value = std::round(valueOf(field, 0, i));
        if (!(value >= limits::min() && value <= limits::max()))
            throw CaseError(fmt::format("field {}: {} of particle {} is not a label", field.name, value, before + i));
        return std::int32_t(value);
    }
};

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

void writeValue(OutputFile& file, const FieldView& field, const Share& share, std::size_t i, int precision)
{
    switch (field.type)
    {
    case FieldClass::label:
        return file.write(std::int64_t(share.label(field, i)));
    case FieldClass::scalar:
        return file.write(valueOf(field, 0, i), precision);
    default:
        return writeTuple(file, field, i, precision);
    }
}

std::size_t binaryBytes(FieldClass type)
{
    return type == FieldClass::label ? sizeof(std::int32_t) : std::size_t(componentsOf(type)) * sizeof(double);
}

void writeBinary(OutputFile& file, const FieldView& field, const Share& share, std::size_t i)
{
    if (field.type == FieldClass::label)
    {
        const auto label = share.label(field, i);
        return file.writeBytes(&label, sizeof label);
    }
    const int components = componentsOf(field.type);
    for (int c = 0; c < components; ++c)
    {
        const double value = valueOf(field, c, i);
        file.writeBytes(&value, sizeof value);
    }
}

/// OpenFOAM writes an empty binary list without its parentheses and ParaView wants them: both read an empty ascii list.
WriteFormat formatFor(const Share& share, const WriteOptions& options) { return share.all == 0 ? WriteFormat::ascii : options.format; }

/// `head`, `write(file, i)` of n particles of each rank, and `foot`. `bytes`: of each particle, where all have as many.
void writeList(const std::filesystem::path& path, const std::string& head, std::size_t n, const auto& write, const std::string& foot,
               std::optional<std::size_t> bytes = {})
{
    const auto part = [&](OutputFile& file)
    {
        if (isFirstRank()) file.write(head);
        for (std::size_t i = 0; i < n; ++i) write(file, i);
        if (isLastRank()) file.write(foot);
    };
    const auto length = [&](std::size_t each) { return (isFirstRank() ? head.size() : 0) + n * each + (isLastRank() ? foot.size() : 0); };
    writeCollated(path, part, bytes ? std::optional(length(*bytes)) : std::nullopt);
}

void writeField(const std::filesystem::path& folder, const std::string& location, const Share& share, const FieldView& field,
                const WriteOptions& options)
{
    assert(int(field.component.size()) == componentsOf(field.type));
    const auto format = formatFor(share, options);
    const auto path = folder / field.name;
    const auto head = foamHeader(format, classOf(field.type), location, field.name) + std::to_string(share.all);
    const auto binary = [&](OutputFile& file, std::size_t i) { writeBinary(file, field, share, i); };
    const auto ascii = [&](OutputFile& file, std::size_t i) { writeValue(file, field, share, i, options.precision); };
    const auto line = [&](OutputFile& file, std::size_t i)
    {
        ascii(file, i);
        file.write("\n");
    };
    if (format == WriteFormat::binary) return writeList(path, head + "\n(", share.n, binary, ")\n", binaryBytes(field.type));
    if (share.isUniform(field)) return writeList(path, head + "{", share.hasFirst() ? 1 : 0, ascii, "}\n");
    writeList(path, head + "\n(\n", share.n, line, ")\n");
}

/// The class is OpenFOAM's own: its tools and ParaView accept any Cloud<...>, but the name of a known particle asks for nothing more.
/// Every particle is in the one cell of the bounding mesh, 0.
void writePositions(const std::filesystem::path& folder, const std::string& location, const Share& share, const FieldView& positions,
                    const WriteOptions& options)
{
    constexpr std::int32_t cell = 0;
    const auto format = formatFor(share, options);
    const auto binary = [&](OutputFile& file, std::size_t i)
    {
        file.write("(");
        writeBinary(file, positions, share, i);
        file.writeBytes(&cell, sizeof cell);
        file.write(")\n");
    };
    const auto ascii = [&](OutputFile& file, std::size_t i)
    {
        writeTuple(file, positions, i, options.precision);
        file.write(" 0\n");
    };
    const auto path = folder / "positions";
    const auto head = foamHeader(format, "Cloud<passiveParticle>", location, "positions") + std::to_string(share.all) + "\n(\n";
    if (format == WriteFormat::ascii) return writeList(path, head, share.n, ascii, ")\n");
    writeList(path, head, share.n, binary, ")\n", std::string_view("()\n").size() + binaryBytes(positions.type) + sizeof cell);
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
    const Share share(n);
    const auto time = finalName(timeFolder);
    const auto folder = timeFolder / "lagrangian" / cloud, properties = timeFolder / "uniform" / "lagrangian" / cloud;
    const auto location = fmt::format("{}/lagrangian/{}", time, cloud);
    byFirst(
        [&]
        {
            createFolders(folder);
            createFolders(properties);
        });
    writePositions(folder, location, share, positions, options);
    for (const auto& field : fields) writeField(folder, location, share, field, options);

    // OpenFOAM's tools look for barycentric coordinates without `geometry positions;` and silently read no particles. The names of the fields
    // are for readCloud, which misses what has been lost.
    std::string names;
    for (const auto& field : fields) names += (names.empty() ? "" : " ") + field.name;
    const auto text = fmt::format("geometry        positions;\n\nprocessor0\n{{\n    particleCount   {};\n}}\n\nfields          ({});\n",
                                  share.all, names);
    byFirst(
        [&]
        {
            writeFile(properties / "cloudProperties", foamHeader(WriteFormat::ascii, "dictionary",
                                                                 fmt::format("{}/uniform/lagrangian/{}", time, cloud), "cloudProperties") +
                                                          text);
        });
}

}
