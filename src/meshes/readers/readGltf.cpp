#include "MappedFile.hpp"
#include "RegionNames.hpp"
#include "readers.hpp"
#include "singlePrecision.hpp"
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

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

/// A place in the JSON text, with the path to it for errors.
class Node
{
    const Json* json_;
    std::string path_;

    [[noreturn]] void refuse(const std::string& what) const { throw UnusableMesh(fmt::format("{}: {}", path_, what)); }

public:
    Node(const Json& json, std::string path) : json_(&json), path_(std::move(path)) {}

    const std::string& path() const { return path_; }

    std::optional<Node> find(const char* key) const
    {
        if (!json_->is_object()) refuse("expected { ... }");
        const auto there = json_->find(key);
        return there == json_->end() ? std::nullopt : std::optional(Node(*there, path_.empty() ? key : path_ + "." + key));
    }
    Node at(const char* key) const
    {
        const auto there = find(key);
        if (!there) throw UnusableMesh(fmt::format("{}{}\"{}\" is missing", path_, path_.empty() ? "" : ": ", key));
        return *there;
    }
    std::size_t size() const
    {
        if (!json_->is_array()) refuse("expected [ ... ]");
        return json_->size();
    }
    Node operator[](std::size_t i) const
    {
        if (i >= size()) refuse(fmt::format("there is no number {} of {}", i, size()));
        return {(*json_)[i], fmt::format("{}[{}]", path_, i)};
    }
    std::size_t whole() const
    {
        if (!json_->is_number_unsigned()) refuse("expected a whole number");
        return json_->get<std::size_t>();
    }
    double number() const
    {
        if (!json_->is_number()) refuse("expected a number");
        return json_->get<double>();
    }
    bool flag() const
    {
        if (!json_->is_boolean()) refuse("expected true or false");
        return json_->get<bool>();
    }
    const std::string& text() const
    {
        if (!json_->is_string()) refuse("expected a text");
        return json_->get_ref<const std::string&>();
    }
    std::size_t whole(const char* key, std::size_t otherwise) const
    {
        const auto there = find(key);
        return there ? there->whole() : otherwise;
    }
    std::string text(const char* key) const
    {
        const auto there = find(key);
        return there ? there->text() : "";
    }
    template<std::size_t n> std::array<double, n> numbers(const char* key, const std::array<double, n>& otherwise) const
    {
        const auto there = find(key);
        if (!there) return otherwise;
        if (there->size() != n) there->refuse(fmt::format("expected {} numbers", n));
        std::array<double, n> all;
        for (std::size_t i = 0; i < n; ++i) all[i] = (*there)[i].number();
        return all;
    }
    /// Throws UnusableMesh where it has an extension that changes the geometry.
    void checkExtensions() const
    {
        const auto extensions = find("extensions");
        if (!extensions) return;
        for (const auto name : unreadExtensions)
            if (extensions->find(std::string(name).c_str())) refuseExtension(path_, name);
    }
};

/// x -> e_x x + e_y y + e_z z + shift
struct Affine
{
    Vector<3> e_x{1, 0, 0}, e_y{0, 1, 0}, e_z{0, 0, 1}, shift;

    Vector<3> turned(const Vector<3>& x) const { return x.x * e_x + x.y * e_y + x.z * e_z; }
    Vector<3> operator()(const Vector<3>& x) const { return turned(x) + shift; }
    Affine operator*(const Affine& inner) const { return {turned(inner.e_x), turned(inner.e_y), turned(inner.e_z), (*this)(inner.shift)}; }
    bool mirrors() const { return dot(cross(e_x, e_y), e_z) < 0; }
    double largestStretch() const { return std::max({mag(e_x), mag(e_y), mag(e_z)}); }
};

Affine placeOf(const Node& node)
{
    if (node.find("matrix"))
    {
        const auto m = node.numbers<16>("matrix", {});
        return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    }
    const auto t = node.numbers<3>("translation", {0, 0, 0}), s = node.numbers<3>("scale", {1, 1, 1});
    const auto [x, y, z, w] = node.numbers<4>("rotation", {0, 0, 0, 1});
    const double norm = x * x + y * y + z * z + w * w;
    if (!(norm > 0)) throw UnusableMesh(fmt::format("{}.rotation: the quaternion is zero", node.path()));
    const double k = 2 / norm;
    return {s[0] * Vector<3>{1 - k * (y * y + z * z), k * (x * y + w * z), k * (x * z - w * y)},
            s[1] * Vector<3>{k * (x * y - w * z), 1 - k * (x * x + z * z), k * (y * z + w * x)},
            s[2] * Vector<3>{k * (x * z + w * y), k * (y * z - w * x), 1 - k * (x * x + y * y)},
            {t[0], t[1], t[2]}};
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

NumberKind numberKind(const Node& componentType)
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

class Gltf
{
    const std::filesystem::path& file_;
    Json json_;
    Node root_{json_, ""};
    std::optional<std::string_view> binary_; ///< the second part of a .glb
    std::vector<std::optional<std::string>> buffers_;
    RegionNames regions_;
    NumberedMesh mesh_;
    std::size_t linesAndPoints_ = 0;
    Notes& notes_;

    static std::uint32_t word(std::string_view bytes, std::size_t at)
    {
        if (bytes.size() < at + 4) throw UnusableMesh(fmt::format("byte {}: it ends within its header: it is truncated", bytes.size()));
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, 4);
        return value;
    }

    /// The JSON of a .glb; binary_ is set.
    std::string_view openBinary(std::string_view bytes)
    {
        constexpr std::size_t header = 12, chunkHeader = 8;
        constexpr std::uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;
        if (word(bytes, 4) != 2) throw UnusableMesh(fmt::format("byte 4: glTF {} is not read: export it as glTF 2.0", word(bytes, 4)));
        const std::size_t length = word(bytes, 8);
        if (length > bytes.size())
            throw UnusableMesh(fmt::format("byte 8: its header tells of {} bytes, {} are there: it is truncated", length, bytes.size()));
        if (length < bytes.size())
            notes_.push_back(counted(bytes.size() - length, "byte") + " behind the length that its header tells of left out");
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

    void open(std::string_view bytes)
    {
        const auto first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
        if (bytes.starts_with("glTF")) bytes = openBinary(bytes);
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
        if (!version.starts_with("2."))
            throw UnusableMesh(fmt::format("asset.version: glTF {} is not read: export it as glTF 2.0", version));
        if (const auto required = root_.find("extensionsRequired"))
            for (std::size_t i = 0; i < required->size(); ++i)
            {
                const std::string_view name = (*required)[i].text();
                if (std::ranges::none_of(harmlessExtensions, [&](auto known) { return name.starts_with(known); }))
                    refuseExtension((*required)[i].path(), name);
            }
        if (const auto buffers = root_.find("buffers")) buffers_.resize(buffers->size());
    }

    std::string_view buffer(std::size_t index)
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
            throw UnusableMesh(
                fmt::format("{}.byteLength: {}, and {} bytes are there: it is truncated", node.path(), length, bytes.size()));
        return bytes.substr(0, length);
    }

    std::string load(const Node& uri) const
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

    /// Elements of `size` bytes of a bufferView, from `offset` on.
    struct Elements
    {
        const char* begin = nullptr;
        std::size_t stride = 0;
    };
    Elements elements(std::size_t view, std::size_t offset, std::size_t count, std::size_t size, const std::string& where)
    {
        const auto node = root_.at("bufferViews")[view];
        node.checkExtensions();
        const auto bytes = buffer(node.at("buffer").whole());
        const auto from = node.whole("byteOffset", 0), length = node.at("byteLength").whole(), stride = node.whole("byteStride", size);
        if (from > bytes.size() || length > bytes.size() - from)
            throw UnusableMesh(fmt::format("{}: bytes {} to {} of a buffer of {}: it is truncated or damaged", node.path(), from,
                                           from + length, bytes.size()));
        if (stride < size || stride > 252 || count == 0 || offset > length || size > length - offset ||
            count - 1 > (length - offset - size) / stride)
            throw UnusableMesh(fmt::format("{}: {} of {} bytes from byte {} on, every {} bytes, do not fit in the {} bytes of {}", where,
                                           counted(count, "element"), size, offset, stride, length, node.path()));
        return {bytes.data() + from + offset, stride};
    }

    static double value(const char* at, std::size_t componentType)
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

    struct Numbers
    {
        std::vector<double> values;
        bool single; ///< in single precision
    };

    /// All components of all elements.
    Numbers numbers(std::size_t accessor, const std::string& type, std::size_t components)
    {
        const auto node = root_.at("accessors")[accessor];
        if (node.at("type").text() != type)
            throw UnusableMesh(fmt::format("{}.type: expected {}, found {}", node.path(), type, node.at("type").text()));
        const auto count = node.at("count").whole(), kind = node.at("componentType").whole();
        const auto [bytes, largest] = numberKind(node.at("componentType"));
        const auto normalized = node.find("normalized");
        const double unit = normalized && normalized->flag() && largest > 0 ? largest : 1;
        if (!node.find("bufferView"))
            throw UnusableMesh(fmt::format("{}: it has no bufferView{}", node.path(),
                                           node.find("sparse") ? ": sparse changes of nothing are not read" : ""));
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

    /// Corners of the triangles one after another, of a list (4), strip (5) or fan (6).
    std::vector<int> corners(const Node& primitive, std::size_t mode, std::size_t points)
    {
        std::vector<int> listed;
        if (const auto indices = primitive.find("indices"))
            for (const double i : numbers(indices->whole(), "SCALAR", 1).values)
            {
                if (!(i >= 0 && i < double(points) && i == std::floor(i)))
                    throw UnusableMesh(fmt::format("{}: vertex {}, and there are {}", indices->path(), i, points));
                listed.push_back(int(i));
            }
        else
            for (std::size_t i = 0; i < points; ++i) listed.push_back(int(i));
        if (mode == 4)
        {
            if (listed.size() % 3 != 0)
                throw UnusableMesh(fmt::format("{}: {} corners are no whole triangles", primitive.path(), listed.size()));
            return listed;
        }
        std::vector<int> all;
        for (std::size_t k = 2; k < listed.size(); ++k)
        {
            const bool odd = mode == 5 && k % 2 == 1;
            const int a = mode == 6 ? listed[0] : listed[k - 2], b = listed[k - 1], c = listed[k];
            all.insert(all.end(), {a, odd ? c : b, odd ? b : c});
        }
        return all;
    }

    void addPrimitive(const Node& primitive, const std::string& meshName, const Affine& toScene)
    {
        primitive.checkExtensions();
        const auto mode = primitive.whole("mode", 4);
        if (mode > 6) throw UnusableMesh(fmt::format("{}.mode: {} is none", primitive.path(), mode));
        if (mode < 4)
        {
            ++linesAndPoints_;
            return;
        }
        const auto position = primitive.at("attributes").at("POSITION").whole();
        const auto [x, single] = numbers(position, "VEC3", 3);
        const auto all = corners(primitive, mode, x.size() / 3);
        if (mesh_.points.size() + x.size() / 3 > std::size_t(std::numeric_limits<int>::max()))
            throw UnusableMesh(fmt::format("{}: more vertices than 2^31", primitive.path()));

        std::string name;
        if (const auto material = primitive.find("material")) name = root_.at("materials")[material->whole()].text("name");
        const int region = regions_.index(name.empty() ? meshName : name), first = int(mesh_.points.size());
        double largest = 0;
        for (std::size_t i = 0; i < x.size(); i += 3)
        {
            const Vector<3> p = toScene({x[i], x[i + 1], x[i + 2]});
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
                throw UnusableMesh(fmt::format("{}: its node puts it nowhere", primitive.path()));
            mesh_.points.push_back(p);
            largest = std::max({largest, std::abs(x[i]), std::abs(x[i + 1]), std::abs(x[i + 2])});
        }
        if (single) mesh_.rounding = std::max(mesh_.rounding, toScene.largestStretch() * roundingOf(largest));
        for (std::size_t k = 0; k < all.size(); k += 3)
        {
            const int a = first + all[k], b = first + all[k + 1], c = first + all[k + 2];
            mesh_.number.push_back(int(mesh_.triangles.size()));
            if (toScene.mirrors()) mesh_.triangles.push_back({a, c, b});
            else mesh_.triangles.push_back({a, b, c});
            mesh_.region.push_back(region);
        }
    }

    void addMesh(std::size_t index, const Affine& toScene)
    {
        const auto mesh = root_.at("meshes")[index];
        if (const auto weights = mesh.find("weights")) checkWeights(*weights);
        const auto primitives = mesh.at("primitives");
        auto name = mesh.text("name");
        if (name.empty()) name = fmt::format("meshes_{}", index);
        for (std::size_t i = 0; i < primitives.size(); ++i)
            addPrimitive(primitives[i], primitives.size() > 1 ? fmt::format("{}-{}", name, i) : name, toScene);
    }

    static void checkWeights(const Node& weights)
    {
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weights[i].number() != 0)
                throw UnusableMesh(fmt::format("{}: morph targets are not read: apply them, and export it again", weights.path()));
    }

    std::vector<std::size_t> rootNodes() const
    {
        const auto listed = [](const Node& list)
        {
            std::vector<std::size_t> all;
            for (std::size_t i = 0; i < list.size(); ++i) all.push_back(list[i].whole());
            return all;
        };
        if (root_.find("scenes"))
        {
            const auto nodes = root_.at("scenes")[root_.whole("scene", 0)].find("nodes");
            return nodes ? listed(*nodes) : std::vector<std::size_t>{};
        }
        const auto nodes = root_.at("nodes");
        std::vector<char> isChild(nodes.size(), 0);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (const auto children = nodes[i].find("children"))
                for (const auto child : listed(*children))
                    if (child < isChild.size()) isChild[child] = 1;
        std::vector<std::size_t> roots;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!isChild[i]) roots.push_back(i);
        return roots;
    }

    void addNodes()
    {
        struct Visit
        {
            std::size_t node;
            Affine parent;
        };
        std::vector<Visit> open;
        const auto roots = rootNodes();
        for (auto r = roots.rbegin(); r != roots.rend(); ++r) open.push_back({*r, {}});
        const auto nodes = root_.at("nodes");
        std::vector<char> visited(nodes.size(), 0);
        while (!open.empty())
        {
            const auto [index, parent] = open.back();
            open.pop_back();
            const auto node = nodes[index];
            if (std::exchange(visited[index], 1)) throw UnusableMesh(fmt::format("{}: it has two parents", node.path()));
            node.checkExtensions();
            const auto toScene = parent * placeOf(node);
            if (const auto weights = node.find("weights")) checkWeights(*weights);
            if (const auto mesh = node.find("mesh"))
            {
                if (node.find("skin"))
                    throw UnusableMesh(fmt::format("{}.skin: skins are not read: apply its pose, and export it again", node.path()));
                addMesh(mesh->whole(), toScene);
            }
            if (const auto children = node.find("children"))
                for (std::size_t i = children->size(); i-- > 0;) open.push_back({(*children)[i].whole(), toScene});
        }
    }

public:
    Gltf(const std::filesystem::path& file, Notes& notes) : file_(file), regions_(notes), notes_(notes) {}

    NumberedMesh read(std::string_view bytes)
    {
        open(bytes);
        addNodes();
        if (linesAndPoints_ > 0) notes_.push_back(counted(linesAndPoints_, "primitive") + " of lines or points left out");
        mesh_.regions = regions_.words();
        return std::move(mesh_);
    }
};

}

NumberedMesh readGltf(const std::filesystem::path& file, std::string_view bytes, Notes& notes) { return Gltf(file, notes).read(bytes); }

}
