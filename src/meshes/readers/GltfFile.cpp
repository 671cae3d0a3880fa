#include "meshes/readers/GltfFile.hpp"
#include "case/MappedFile.hpp"
#include "meshes/readers/singlePrecision.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace sph
{

namespace
{

using Json = nlohmann::json;

/// Extensions that replace or multiply the geometry: a reader without them finds another one.
constexpr std::array<std::string_view, 4> unreadExtensions{"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                                           "KHR_meshopt_compression", "EXT_mesh_gpu_instancing"};
/// Beginnings of the names of those that may be required and change no geometry, or are read.
constexpr std::array<std::string_view, 8> harmlessExtensions{"KHR_mesh_quantization", "KHR_materials_", "KHR_texture_", "EXT_texture_",
                                                             "MSFT_texture_",         "KHR_lights_",    "EXT_lights_",  "KHR_xmp"};

[[noreturn]] void refuseExtension(const std::string& where, std::string_view name)
{
    throw UnusableMesh(fmt::format("{}: the extension \"{}\" is not read: export it without (compression)", where, name));
}

std::string fromBase64(const std::string& text, const std::string& where)
{
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text)
    {
        const auto value = c >= 'A' && c <= 'Z'   ? c - 'A'
                           : c >= 'a' && c <= 'z' ? c - 'a' + 26
                           : c >= '0' && c <= '9' ? c - '0' + 52
                           : c == '+'             ? 62
                           : c == '/'             ? 63
                                                  : -1;
        if (c == '=') break;
        if (value < 0) throw UnusableMesh(fmt::format("{}: its base64 has a character that is none", where));
        bits = bits << 6 | std::uint32_t(value);
        count += 6;
        if (count >= 8) bytes += char(bits >> (count -= 8) & 0xFF);
    }
    return bytes;
}

/// "mesh%20of%20tank.bin" -> "mesh of tank.bin"
std::string fromPercents(const std::string& uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i)
    {
        int code = 0;
        const auto *first = uri.data() + i + 1, *end = uri.data() + std::min(i + 3, uri.size());
        const bool isCode = uri[i] == '%' && end == first + 2 && std::from_chars(first, end, code, 16).ptr == end;
        text += isCode ? char(code) : uri[i];
        if (isCode) i += 2;
    }
    return text;
}

struct NumberKind
{
    std::size_t bytes;
    double largest; ///< of integers: what is 1 where they are normalized
};

NumberKind numberKind(const GltfNode& componentType)
{
    switch (componentType.whole())
    {
    case 5120:
        return {1, 127};
    case 5121:
        return {1, 255};
    case 5122:
        return {2, 32767};
    case 5123:
        return {2, 65535};
    case 5125:
        return {4, 4294967295};
    case 5126:
        return {4, 0};
    default:
        throw UnusableMesh(fmt::format("{}: {} is no type of numbers", componentType.path(), componentType.whole()));
    }
}

template<class T> double valueAt(const char* at)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    if constexpr (std::is_same_v<T, float>) return asWritten(value);
    else return value;
}

std::uint32_t word(std::string_view bytes, std::size_t at)
{
    if (bytes.size() < at + 4) throw UnusableMesh(fmt::format("byte {}: it ends within its header: it is truncated", bytes.size()));
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

double value(const char* at, std::size_t componentType)
{
    switch (componentType)
    {
    case 5120:
        return valueAt<std::int8_t>(at);
    case 5121:
        return valueAt<std::uint8_t>(at);
    case 5122:
        return valueAt<std::int16_t>(at);
    case 5123:
        return valueAt<std::uint16_t>(at);
    case 5125:
        return valueAt<std::uint32_t>(at);
    default:
        return valueAt<float>(at);
    }
}

}

void GltfNode::checkExtensions() const
{
    const auto extensions = find("extensions");
    if (!extensions) return;
    for (const auto name : unreadExtensions)
        if (extensions->find(std::string(name).c_str())) refuseExtension(path_, name);
}

/// The JSON of a .glb; binary_ is set.
std::string_view GltfFile::openBinary(std::string_view bytes, Notes& notes)
{
    constexpr std::size_t header = 12, chunkHeader = 8;
    constexpr std::uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;
    if (word(bytes, 4) != 2) throw UnusableMesh(fmt::format("byte 4: glTF {} is not read: export it as glTF 2.0", word(bytes, 4)));
    const std::size_t length = word(bytes, 8);
    if (length > bytes.size())
        throw UnusableMesh(fmt::format("byte 8: its header tells of {} bytes, {} are there: it is truncated", length, bytes.size()));
    if (length < bytes.size())
        notes.push_back(counted(bytes.size() - length, "byte") + " behind the length that its header tells of left out");
    bytes = bytes.substr(0, length);
    std::optional<std::string_view> json;
    for (auto at = header; at < bytes.size();)
    {
        const std::size_t size = word(bytes, at);
        const auto kind = word(bytes, at + 4);
        const auto chunk = bytes.substr(at + chunkHeader);
        if (chunk.size() < size)
            throw UnusableMesh(fmt::format("byte {}: a part of {} bytes, and {} are there: it is truncated", at, size, chunk.size()));
        if (kind == jsonChunk && !json) json = chunk.substr(0, size);
        if (kind == binaryChunk && !binary_) binary_ = chunk.substr(0, size);
        at += chunkHeader + size;
    }
    if (!json) throw UnusableMesh("byte 12: it has no part of JSON: this is no glTF file");
    return *json;
}

GltfFile::GltfFile(const std::filesystem::path& file, std::string_view bytes, Notes& notes) : file_(file)
{
    const auto first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (bytes.starts_with("glTF")) bytes = openBinary(bytes, notes);
    else if (first == bytes.npos || bytes[first] != '{') throw UnusableMesh("it begins with neither glTF nor {: this is no glTF file");
    try
    {
        json_ = Json::parse(bytes.begin(), bytes.end());
    }
    catch (const Json::parse_error& e)
    {
        // "[json.exception.parse_error.101] parse error at line 1, column 12: ..."
        const std::string_view what = e.what();
        const auto begin = what.find("at ");
        throw UnusableMesh(fmt::format("it is no JSON: it is truncated or damaged {}", what.substr(begin == what.npos ? 0 : begin)));
    }
    const auto version = root_.at("asset").at("version").text();
    if (!version.starts_with("2.")) throw UnusableMesh(fmt::format("asset.version: glTF {} is not read: export it as glTF 2.0", version));
    if (const auto required = root_.find("extensionsRequired"))
        for (std::size_t i = 0; i < required->size(); ++i)
        {
            const std::string_view name = (*required)[i].text();
            if (std::ranges::none_of(harmlessExtensions, [&](auto known) { return name.starts_with(known); }))
                refuseExtension((*required)[i].path(), name);
        }
    if (const auto buffers = root_.find("buffers")) buffers_.resize(buffers->size());
}

std::string_view GltfFile::buffer(std::size_t index)
{
    const auto node = root_.at("buffers")[index];
    node.checkExtensions();
    const auto uri = node.find("uri");
    std::string_view bytes;
    if (!uri && index == 0 && binary_) bytes = *binary_;
    else if (!uri) throw UnusableMesh(fmt::format("{}: it has no uri, and the file no binary part", node.path()));
    else
    {
        if (!buffers_[index]) buffers_[index] = load(*uri);
        bytes = *buffers_[index];
    }
    const auto length = node.at("byteLength").whole();
    if (bytes.size() < length)
        throw UnusableMesh(fmt::format("{}.byteLength: {}, and {} bytes are there: it is truncated", node.path(), length, bytes.size()));
    return bytes.substr(0, length);
}

std::string GltfFile::load(const GltfNode& uri) const
{
    const auto& text = uri.text();
    if (text.starts_with("data:"))
    {
        const auto comma = text.find(',');
        if (comma == text.npos || !std::string_view(text).substr(0, comma).ends_with(";base64"))
            throw UnusableMesh(fmt::format("{}: its data are not in base64", uri.path()));
        return fromBase64(text.substr(comma + 1), uri.path());
    }
    if (text.find("://") != text.npos)
        throw UnusableMesh(fmt::format("{}: \"{}\" is not beside the file: export it with its data", uri.path(), text));
    const auto name = fromPercents(text);
    try
    {
        const MappedFile bytes(file_.parent_path() / name);
        return std::string(bytes.text());
    }
    catch (const std::exception& e)
    {
        throw UnusableMesh(fmt::format("{}: \"{}\" cannot be read: {}", uri.path(), name, e.what()));
    }
}

GltfFile::Elements GltfFile::elements(std::size_t view, std::size_t offset, std::size_t count, std::size_t size, const std::string& where)
{
    const auto node = root_.at("bufferViews")[view];
    node.checkExtensions();
    const auto bytes = buffer(node.at("buffer").whole());
    const auto from = node.whole("byteOffset", 0), length = node.at("byteLength").whole(), stride = node.whole("byteStride", size);
    if (from > bytes.size() || length > bytes.size() - from)
        throw UnusableMesh(fmt::format("{}: bytes {} to {} of a buffer of {}: it is truncated or damaged", node.path(), from, from + length,
                                       bytes.size()));
    if (stride < size || stride > 252 || count == 0 || offset > length || size > length - offset ||
        count - 1 > (length - offset - size) / stride)
        throw UnusableMesh(fmt::format("{}: {} of {} bytes from byte {} on, every {} bytes, do not fit in the {} bytes of {}", where,
                                       counted(count, "element"), size, offset, stride, length, node.path()));
    return {bytes.data() + from + offset, stride};
}

GltfFile::Numbers GltfFile::numbers(std::size_t accessor, const std::string& type, std::size_t components)
{
    const auto node = root_.at("accessors")[accessor];
    if (node.at("type").text() != type)
        throw UnusableMesh(fmt::format("{}.type: expected {}, found {}", node.path(), type, node.at("type").text()));
    const auto count = node.at("count").whole(), kind = node.at("componentType").whole();
    const auto [bytes, largest] = numberKind(node.at("componentType"));
    const auto normalized = node.find("normalized");
    const double unit = normalized && normalized->flag() && largest > 0 ? largest : 1;
    if (!node.find("bufferView"))
        throw UnusableMesh(
            fmt::format("{}: it has no bufferView{}", node.path(), node.find("sparse") ? ": sparse changes of nothing are not read" : ""));
    Numbers all{{}, kind == 5126};
    const auto put = [&](std::size_t at, const Elements& from, std::size_t i)
    {
        for (std::size_t k = 0; k < components; ++k)
        {
            // The smallest of a signed type is -1, too, where it is normalized.
            const double x = std::max(value(from.begin + i * from.stride + k * bytes, kind) / unit,
                                      unit > 1 ? -1.0 : -std::numeric_limits<double>::infinity());
            if (!std::isfinite(x)) throw UnusableMesh(fmt::format("{}: element {} is no finite number", node.path(), at));
            all.values[at * components + k] = x;
        }
    };
    const auto base = elements(node.at("bufferView").whole(), node.whole("byteOffset", 0), count, components * bytes, node.path());
    all.values.resize(count * components);
    for (std::size_t i = 0; i < count; ++i) put(i, base, i);
    if (const auto sparse = node.find("sparse"))
    {
        const auto changes = sparse->at("count").whole();
        const auto places = sparse->at("indices"), values = sparse->at("values");
        const auto placeKind = places.at("componentType").whole();
        const auto at = elements(places.at("bufferView").whole(), places.whole("byteOffset", 0), changes,
                                 numberKind(places.at("componentType")).bytes, places.path());
        const auto from =
            elements(values.at("bufferView").whole(), values.whole("byteOffset", 0), changes, components * bytes, values.path());
        for (std::size_t i = 0; i < changes; ++i)
        {
            const double place = value(at.begin + i * at.stride, placeKind);
            if (!(place >= 0 && place < double(count) && place == std::floor(place)))
                throw UnusableMesh(fmt::format("{}: element {} of {} that are there", places.path(), place, count));
            put(std::size_t(place), from, i);
        }
    }
    return all;
}
}
