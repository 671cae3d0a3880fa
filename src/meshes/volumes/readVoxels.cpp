#include "base/csv.hpp"
#include "case/MappedFile.hpp"
#include "meshes/readers/NumberedMesh.hpp"
#include "meshes/volumes/VoxelImage.hpp"
#include <algorithm>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace sph
{

namespace
{

using Words = std::vector<std::string>;

/// Bytes as values of one type, in either order.
template<class T> void convert(std::string_view bytes, bool isBigEndian, std::vector<float>& values)
{
    const bool reversed = isBigEndian != (std::endian::native == std::endian::big);
    for (std::size_t k = 0; k < values.size(); ++k)
    {
        std::array<char, sizeof(T)> one;
        std::memcpy(one.data(), bytes.data() + k * sizeof(T), sizeof(T));
        if (reversed) std::ranges::reverse(one);
        values[k] = float(std::bit_cast<T>(one));
    }
}

struct DataType
{
    std::string name, metaImage; ///< in dictionaries, and in the header of a MetaImage
    std::size_t bytes;
    bool isWhole;
    void (*convert)(std::string_view, bool isBigEndian, std::vector<float>&);
};

const std::vector<DataType>& dataTypes()
{
    static const std::vector<DataType> types{
        {"uint8", "MET_UCHAR", 1, true, convert<std::uint8_t>},    {"int8", "MET_CHAR", 1, true, convert<std::int8_t>},
        {"uint16", "MET_USHORT", 2, true, convert<std::uint16_t>}, {"int16", "MET_SHORT", 2, true, convert<std::int16_t>},
        {"uint32", "MET_UINT", 4, true, convert<std::uint32_t>},   {"int32", "MET_INT", 4, true, convert<std::int32_t>},
        {"float32", "MET_FLOAT", 4, false, convert<float>},        {"float64", "MET_DOUBLE", 8, false, convert<double>}};
    return types;
}

std::string lengthText(const std::array<int, 3>& cells) { return fmt::format("{} x {} x {}", cells[0], cells[1], cells[2]); }

/// Fills the values; `bytes` begins with the first of them.
void readValues(std::string_view bytes, const DataType& type, bool isBigEndian, VoxelImage& image)
{
    const auto needed = image.size() * type.bytes;
    if (bytes.size() != needed)
        throw UnusableMesh(
            fmt::format("{} voxels of {} are {} bytes, and there are {}: see the number of voxels, their type and the length of the header",
                        lengthText(image.cells), type.name, needed, bytes.size()));
    image.values.resize(image.size());
    image.isWhole = type.isWhole;
    type.convert(bytes, isBigEndian, image.values);
}

void checkCells(const std::array<int, 3>& cells)
{
    for (const int n : cells)
        if (n < 2 || n > 4096)
            throw UnusableMesh(fmt::format("a volume of {} voxels: 2 to 4096 along each edge are possible", lengthText(cells)));
}

VoxelImage readRaw(const std::filesystem::path& file, const TriSurface::Volume& v)
{
    VoxelImage image;
    image.cells = v.cells;
    checkCells(image.cells);
    image.voxel = *v.voxelSize * Vector<3>{1, 1, 1};
    const auto type = std::ranges::find(dataTypes(), v.dataType, &DataType::name);
    const MappedFile bytes(file);
    const auto header = std::size_t(v.headerBytes);
    if (bytes.text().size() < header)
        throw UnusableMesh(fmt::format("it has {} bytes, fewer than headerBytes {}", bytes.text().size(), header));
    readValues(bytes.text().substr(header), *type, v.bigEndian, image);
    return image;
}

/// The lines "Key = values" of a MetaImage's header.
class MetaHeader
{
    std::map<std::string, Words> entries_;
    std::size_t length_ = 0;

public:
    explicit MetaHeader(std::string_view text)
    {
        for (std::size_t at = 0; at < text.size() && entries_.count("ElementDataFile") == 0;)
        {
            const auto end = std::min(text.find('\n', at), text.size());
            const auto line = std::string(text.substr(at, end - at));
            at = length_ = std::min(end + 1, text.size());
            const auto equals = line.find('=');
            if (equals == std::string::npos) continue;
            std::istringstream key(line.substr(0, equals)), values(line.substr(equals + 1));
            std::string name;
            key >> name;
            entries_[name] = Words{std::istream_iterator<std::string>(values), {}};
        }
        if (!has("ElementDataFile")) throw UnusableMesh("no header of a MetaImage: it has no line ElementDataFile = ...");
    }
    std::size_t length() const { return length_; }
    bool has(const std::string& key) const { return entries_.count(key) > 0 && !entries_.at(key).empty(); }
    std::string word(const std::string& key, const std::string& fallback) const { return has(key) ? entries_.at(key)[0] : fallback; }
    bool isTrue(const std::string& key) const { return word(key, "False").starts_with('T'); }
    std::vector<double> numbers(const std::string& key, std::size_t count) const
    {
        if (!has(key)) throw UnusableMesh(fmt::format("its header has no {}", key));
        std::vector<double> all;
        for (const auto& word : entries_.at(key))
            if (const auto number = finiteNumber(word)) all.push_back(*number);
        if (all.size() != count || entries_.at(key).size() != count)
            throw UnusableMesh(
                fmt::format("{} of its header has \"{}\", and {} numbers are needed", key, fmt::join(entries_.at(key), " "), count));
        return all;
    }
};

VoxelImage readMetaImage(const std::filesystem::path& file, const TriSurface::Volume& v)
{
    const MappedFile bytes(file);
    const MetaHeader header(bytes.text());
    if (header.word("NDims", "3") != "3")
        throw UnusableMesh(fmt::format("it has {} dimensions, and 3 are needed", header.word("NDims", "")));
    if (header.isTrue("CompressedData")) throw UnusableMesh("its data are compressed: write it with CompressedData = False");
    if (header.word("BinaryData", "True").starts_with('F')) throw UnusableMesh("its data are text: write it with BinaryData = True");
    if (header.word("ElementNumberOfChannels", "1") != "1")
        throw UnusableMesh("a voxel has several values (ElementNumberOfChannels), and one is needed");
    for (const std::string key : {"TransformMatrix", "Orientation", "Rotation"})
        if (header.has(key) && header.numbers(key, 9) != std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1})
            throw UnusableMesh(
                fmt::format("{} of its header turns the volume: set it to 1 0 0 0 1 0 0 0 1, and turn the wall by its entry rotation",
                            key));
    VoxelImage image;
    const auto cells = header.numbers("DimSize", 3);
    image.cells = {int(std::clamp(cells[0], 0.0, 1e6)), int(std::clamp(cells[1], 0.0, 1e6)), int(std::clamp(cells[2], 0.0, 1e6))};
    checkCells(image.cells);
    if (v.voxelSize) image.voxel = *v.voxelSize * Vector<3>{1, 1, 1};
    else
    {
        const std::string key = header.has("ElementSpacing") ? "ElementSpacing" : "ElementSize";
        if (!header.has(key))
            throw UnusableMesh(
                "its header has no ElementSpacing, so that nobody knows how large a voxel is: add voxelSize to section volume, in the lengths that scale turns to m");
        const auto h = header.numbers(key, 3);
        if (!(h[0] > 0 && h[1] > 0 && h[2] > 0))
            throw UnusableMesh(fmt::format("{} of its header is {:g} {:g} {:g}, and must be positive", key, h[0], h[1], h[2]));
        image.voxel = {h[0], h[1], h[2]};
    }
    for (const std::string key : {"Offset", "Position", "Origin"})
        if (header.has(key))
        {
            const auto x = header.numbers(key, 3);
            image.low = Vector<3>{x[0], x[1], x[2]} - 0.5 * image.voxel;
            break;
        }
    const auto typeName = header.word("ElementType", "");
    const auto type = std::ranges::find(dataTypes(), typeName, &DataType::metaImage);
    if (type == dataTypes().end())
    {
        Words names;
        for (const auto& t : dataTypes()) names.push_back(t.metaImage);
        throw UnusableMesh(fmt::format("ElementType of its header is \"{}\"; possible are {}", typeName, fmt::join(names, ", ")));
    }
    const bool isBigEndian = header.isTrue("BinaryDataByteOrderMSB") || header.isTrue("ElementByteOrderMSB");
    const auto data = header.word("ElementDataFile", "");
    if (data == "LOCAL") readValues(bytes.text().substr(header.length()), *type, isBigEndian, image);
    else
    {
        const auto path = file.parent_path() / data;
        if (!std::filesystem::is_regular_file(path))
            throw UnusableMesh(fmt::format("ElementDataFile of its header is \"{}\", and there is no such file beside it", data));
        const MappedFile raw(path);
        // HeaderSize -1: the data are the end of the file.
        const double size = header.has("HeaderSize") ? header.numbers("HeaderSize", 1)[0] : 0;
        const auto total = raw.text().size(), voxels = image.size() * type->bytes;
        const auto skip = size < 0 ? total - std::min(total, voxels) : std::min(total, std::size_t(size));
        readValues(raw.text().substr(skip), *type, isBigEndian, image);
    }
    return image;
}

}

VoxelImage readVoxels(const std::filesystem::path& file, const TriSurface::Volume& v)
{
    const auto end = file.extension();
    return end == ".mhd" || end == ".mha" ? readMetaImage(file, v) : readRaw(file, v);
}

}
