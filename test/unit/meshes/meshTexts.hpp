/// Meshes as the text of files.
#pragma once
#include "meshes.hpp"
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>

namespace sph::test
{

using Mesh = TriangleSurface;

/// The box, normals outwards; the triangles of a face follow one another: z low, z high, y low, y high, x low, x high.
inline Mesh box(const Vector<3>& low = {0, 0, 0}, const Vector<3>& high = {1, 1, 1})
{
    Mesh m;
    for (int i = 0; i < 8; ++i) m.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return m;
}

/// The box with the other diagonal in each face.
inline Mesh otherDiagonals(Mesh m)
{
    for (std::size_t f = 0; f + 1 < m.triangles.size(); f += 2)
    {
        const auto [a, b, c] = m.triangles[f];
        const int d = m.triangles[f + 1][1] == c ? m.triangles[f + 1][2] : m.triangles[f + 1][1];
        m.triangles[f] = {a, b, d};
        m.triangles[f + 1] = {b, c, d};
    }
    return m;
}

inline std::string solid(const Mesh& m, const std::string& name = "body", std::size_t from = 0, std::size_t to = std::string::npos)
{
    std::string text = "solid " + name + "\n";
    for (auto f = from; f < std::min(to, m.triangles.size()); ++f)
    {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const int p : m.triangles[f])
        {
            const auto& x = m.points[std::size_t(p)];
            text += fmt::format("  vertex {} {} {}\n", x.x, x.y, x.z);
        }
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid " + name + "\n";
}

template<class T> void put(std::string& bytes, T value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }

inline std::string binaryStl(const Mesh& m)
{
    std::string bytes(80, ' ');
    put(bytes, std::uint32_t(m.triangles.size()));
    for (const auto& t : m.triangles)
    {
        for (int k = 0; k < 3; ++k) put(bytes, 0.0f);
        for (const int p : t)
        {
            const auto& x = m.points[std::size_t(p)];
            put(bytes, float(x.x));
            put(bytes, float(x.y));
            put(bytes, float(x.z));
        }
        put(bytes, std::uint16_t(0));
    }
    return bytes;
}

/// `separator` between coordinates; `before` and `from` of the corners of facets.
inline std::string rows(const Mesh& m, const std::string& beforePoint, const std::string& beforeFacet, int from)
{
    std::string text;
    for (const auto& p : m.points) text += fmt::format("{}{} {} {}\n", beforePoint, p.x, p.y, p.z);
    for (const auto& [a, b, c] : m.triangles) text += fmt::format("{}{} {} {}\n", beforeFacet, a + from, b + from, c + from);
    return text;
}

inline std::string off(const Mesh& m) { return fmt::format("OFF\n{} {} 0\n", m.points.size(), m.triangles.size()) + rows(m, "", "3 ", 0); }

inline std::string ply(const Mesh& m)
{
    return fmt::format("ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\n"
                       "property list uchar int vertex_indices\nend_header\n",
                       m.points.size(), m.triangles.size()) +
           rows(m, "", "3 ", 0);
}

inline std::string binaryPly(const Mesh& m)
{
    auto bytes =
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
                    "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                    m.points.size(), m.triangles.size());
    for (const auto& p : m.points)
        for (const double x : {p.x, p.y, p.z}) put(bytes, x);
    for (const auto& t : m.triangles)
    {
        put(bytes, std::uint8_t(3));
        for (const int p : t) put(bytes, std::int32_t(p));
    }
    return bytes;
}

/// The first `lidFacets` facets in group "the lid", the others in group "shell".
inline std::string obj(const Mesh& m, std::size_t lidFacets)
{
    std::string text;
    for (const auto& p : m.points) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
    {
        if (f == 0) text += "g lid/1\n";
        if (f == lidFacets) text += "g shell\n";
        const auto& [a, b, c] = m.triangles[f];
        text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
    }
    return text;
}

inline std::string base64(const std::string& bytes)
{
    constexpr auto letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? letters[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

/// A node that shifts the mesh by `shift`; the first `steelFacets` facets of material "steel", the others of none, in a mesh "rest".
inline std::string gltf(const Mesh& m, std::size_t steelFacets, const Vector<3>& shift)
{
    std::string bytes;
    for (const auto& p : m.points)
        for (const double x : {p.x, p.y, p.z}) put(bytes, float(x));
    const auto points = bytes.size();
    for (const auto& t : m.triangles)
        for (const int p : t) put(bytes, std::uint32_t(p));
    const auto view = [](std::size_t from, std::size_t length)
    { return fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}}", from, length); };
    const auto accessor = [](int v, std::size_t from, int type, std::size_t count, const char* kind)
    {
        return fmt::format("{{\"bufferView\":{},\"byteOffset\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"}}", v, from, type,
                           count, kind);
    };
    const auto rest = m.triangles.size() - steelFacets;
    return fmt::format(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0,1]}}],"
        "\"nodes\":[{{\"mesh\":0,\"translation\":[{0},{1},{2}]}},{{\"mesh\":1,\"translation\":[{0},{1},{2}]}}],"
        "\"materials\":[{{\"name\":\"steel\"}}],"
        "\"meshes\":[{{\"name\":\"cover\",\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":1,\"material\":0}}]}},"
        "{{\"name\":\"rest\",\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":2}}]}}],"
        "\"accessors\":[{3},{4},{5}],\"bufferViews\":[{6},{7}],"
        "\"buffers\":[{{\"byteLength\":{8},\"uri\":\"data:application/octet-stream;base64,{9}\"}}]}}",
        shift.x, shift.y, shift.z, accessor(0, 0, 5126, m.points.size(), "VEC3"), accessor(1, 0, 5125, 3 * steelFacets, "SCALAR"),
        accessor(1, 12 * steelFacets, 5125, 3 * rest, "SCALAR"), view(0, points), view(points, bytes.size() - points), bytes.size(),
        base64(bytes));
}

/// Faces of any number of corners.
struct PolygonMesh
{
    std::vector<Vector<3>> points;
    std::vector<std::vector<int>> faces;
};

/// Over an outline, counter-clockwise as seen from above, normals outwards; its floor and its lid are one polygon each.
inline PolygonMesh prism(const std::vector<std::array<double, 2>>& outline, double height)
{
    PolygonMesh m;
    for (const double z : {0.0, height})
        for (const auto& [x, y] : outline) m.points.push_back({x, y, z});
    const int n = int(outline.size());
    m.faces.resize(2);
    for (int k = 0; k < n; ++k)
    {
        m.faces[0].push_back(n - 1 - k);
        m.faces[1].push_back(n + k);
        const int next = (k + 1) % n;
        m.faces.push_back({k, next, n + next, n + k});
    }
    return m;
}

inline std::string pointRows(const PolygonMesh& m, const std::string& before = "")
{
    std::string text;
    for (const auto& p : m.points) text += fmt::format("{}{} {} {}\n", before, p.x, p.y, p.z);
    return text;
}

inline std::string faceRows(const PolygonMesh& m)
{
    std::string text;
    for (const auto& f : m.faces) text += fmt::format("{} {}\n", f.size(), fmt::join(f, " "));
    return text;
}

inline std::string obj(const PolygonMesh& m)
{
    auto text = pointRows(m, "v ");
    for (const auto& f : m.faces)
    {
        text += "f";
        for (const int p : f) text += fmt::format(" {}", p + 1);
        text += "\n";
    }
    return text;
}

inline std::string off(const PolygonMesh& m)
{
    return fmt::format("OFF\n{} {} 0\n", m.points.size(), m.faces.size()) + pointRows(m) + faceRows(m);
}

inline std::string plyHeader(const PolygonMesh& m, const std::string& format, const std::string& number = "double",
                             const std::string& index = "int")
{
    return fmt::format("ply\nformat {0} 1.0\nelement vertex {1}\nproperty {2} x\nproperty {2} y\nproperty {2} z\nelement face {3}\n"
                       "property list uint {4} vertex_indices\nend_header\n",
                       format, m.points.size(), number, m.faces.size(), index);
}

inline std::string ply(const PolygonMesh& m) { return plyHeader(m, "ascii") + pointRows(m) + faceRows(m); }

/// `Number` and `Index` as the header names them.
template<class Number, class Index>
std::string binaryPly(const PolygonMesh& m, const std::string& number, const std::string& index, bool bigEndian = false)
{
    auto bytes = plyHeader(m, bigEndian ? "binary_big_endian" : "binary_little_endian", number, index);
    const auto add = [&](auto value)
    {
        std::string one;
        put(one, value);
        bytes += bigEndian ? std::string(one.rbegin(), one.rend()) : one;
    };
    for (const auto& p : m.points)
        for (const double x : {p.x, p.y, p.z}) add(Number(x));
    for (const auto& f : m.faces)
    {
        add(std::uint32_t(f.size()));
        for (const int p : f) add(Index(p));
    }
    return bytes;
}

}
