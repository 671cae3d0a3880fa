/// glTF 2.0 of one mesh of 8 points and 12 triangles, with positions and corners as any type of numbers.
#pragma once
#include "meshTexts.hpp"

namespace sph::test
{

/// Positions as `Number`, each element of four numbers with one of padding, then the corners as `Index`.
template<class Number, class Index> std::string data(const Mesh& m)
{
    std::string bytes;
    for (const auto& p : m.points)
        for (const double x : {p.x, p.y, p.z, 0.0}) put(bytes, Number(x));
    for (const auto& t : m.triangles)
        for (const int p : t) put(bytes, Index(p));
    return bytes;
}

/// A document of one mesh: `position` and `index` are the types of numbers, `node` and `more` further entries of the node and of the
/// document.
inline std::string document(const std::string& uri, std::size_t bytes, int position, std::size_t numberBytes, int index,
                            const std::string& accessor = "", const std::string& node = "", const std::string& more = "",
                            const std::string& primitive = "")
{
    return fmt::format(R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0{}}}],)"
                       R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1{}}}]}}],)"
                       R"("accessors":[{{"bufferView":0,"componentType":{},"count":8,"type":"VEC3"{}}},)"
                       R"({{"bufferView":1,"componentType":{},"count":36,"type":"SCALAR"}}],)"
                       R"("bufferViews":[{{"buffer":0,"byteLength":{},"byteStride":{}}},{{"buffer":0,"byteOffset":{},"byteLength":{}}}],)"
                       R"("buffers":[{{"byteLength":{}{}}}]{}}})",
                       node, primitive, position, accessor, index, 32 * numberBytes, 4 * numberBytes, 32 * numberBytes,
                       bytes - 32 * numberBytes, bytes, uri.empty() ? "" : ",\"uri\":\"" + uri + "\"", more);
}

template<class Number, class Index>
std::string embedded(const Mesh& m, int position, int index, const std::string& accessor = "", const std::string& node = "",
                     const std::string& more = "", const std::string& primitive = "")
{
    const auto bytes = data<Number, Index>(m);
    return document("data:application/octet-stream;base64," + base64(bytes), bytes.size(), position, sizeof(Number), index, accessor, node,
                    more, primitive);
}

inline std::string glb(std::string json, std::string bytes)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    std::string file = "glTF";
    put(file, std::uint32_t(2));
    put(file, std::uint32_t(12 + 8 + json.size() + 8 + bytes.size()));
    put(file, std::uint32_t(json.size()));
    file += "JSON" + json;
    put(file, std::uint32_t(bytes.size()));
    return file + std::string("BIN\0", 4) + bytes;
}

inline const std::string quantization = R"(,"extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":["KHR_mesh_quantization"])";

}
