/// Meshes read once more, in the simplest way and without any check: by streams and strtod, numbers as they come. It shares nothing with
/// the readers that are tested.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace sph::test
{

struct NaiveMesh
{
    using Point = std::array<double, 3>;
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;

    const Point& corner(std::size_t face, std::size_t k) const { return points.at(faces[face].at(k)); }

    struct Volume
    {
        double value = 0;      ///< about the origin
        double magnitudes = 0; ///< of its terms, which rounding goes with
        double bend = 0;       ///< by which it may differ between two cuts of faces that are not plane
    };
    Volume volume() const
    {
        const auto minus = [](const Point& a, const Point& b) { return Point{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
        const auto cross = [](const Point& a, const Point& b) {
            return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        };
        const auto dot = [](const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
        Volume v;
        for (std::size_t f = 0; f < faces.size(); ++f)
        {
            Point normal{};
            double area = 0, off = 0;
            for (std::size_t k = 2; k < faces[f].size(); ++k)
            {
                const auto &a = corner(f, 0), &b = corner(f, k - 1), &c = corner(f, k);
                const auto n = cross(minus(b, a), minus(c, a));
                const double term = dot(a, cross(b, c)) / 6;
                v.value += term;
                v.magnitudes += std::abs(term) + std::sqrt(dot(a, a) * dot(b, b) * dot(c, c));
                for (std::size_t i = 0; i < 3; ++i) normal[i] += n[i];
                area += std::sqrt(dot(n, n));
            }
            for (std::size_t k = 3; k < faces[f].size(); ++k)
                off = std::max(off, std::abs(dot(minus(corner(f, k), corner(f, 0)), normal)) / std::sqrt(dot(normal, normal)));
            v.bend += 2 * area * off;
        }
        return v;
    }
};

inline NaiveMesh naiveStl(std::string text)
{
    NaiveMesh m;
    const auto addFace = [&]
    {
        const auto n = m.points.size();
        m.faces.push_back({n - 3, n - 2, n - 1});
    };
    std::uint32_t count = 0;
    if (text.size() > 84) std::memcpy(&count, text.data() + 80, 4);
    if (text.size() == 84 + 50 * std::size_t(count) || text.substr(0, 134).find('\0') != text.npos)
    {
        for (std::size_t f = 0; f < count; ++f)
        {
            std::array<float, 9> x;
            std::memcpy(x.data(), text.substr(84 + 50 * f + 12, 36).c_str(), 36);
            for (std::size_t k = 0; k < 9; k += 3) m.points.push_back({x[k], x[k + 1], x[k + 2]});
            addFace();
        }
        return m;
    }
    for (auto& c : text) c = char(std::tolower(c));
    std::istringstream words(text);
    for (std::string word; words >> word;)
    {
        if (word == "solid" || word == "endsolid") std::getline(words, word, '\n');
        if (word != "vertex") continue;
        std::string x, y, z;
        words >> x >> y >> z;
        m.points.push_back({std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr), std::strtod(z.c_str(), nullptr)});
        if (m.points.size() % 3 == 0) addFace();
    }
    return m;
}

inline NaiveMesh naiveObj(const std::string& text)
{
    NaiveMesh m;
    std::istringstream lines(text);
    std::string before;
    for (std::string line; std::getline(lines, line);)
    {
        line = before + line.substr(0, line.find('#'));
        before.clear();
        if (const auto last = line.find_last_not_of(" \r\t"); last != line.npos && line[last] == '\\')
        {
            before = line.substr(0, last) + " ";
            continue;
        }
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v")
        {
            std::string x, y, z;
            words >> x >> y >> z;
            m.points.push_back({std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr), std::strtod(z.c_str(), nullptr)});
        }
        if (word != "f") continue;
        std::vector<std::size_t> face;
        while (words >> word)
        {
            const long n = std::strtol(word.c_str(), nullptr, 10);
            face.push_back(n < 0 ? m.points.size() + std::size_t(n) : std::size_t(n - 1));
        }
        if (face.size() > 2) m.faces.push_back(face);
    }
    return m;
}

inline NaiveMesh naiveOff(const std::string& text)
{
    NaiveMesh m;
    std::string plain;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line = line.substr(0, line.find('#')); line.find_first_not_of(" \t\r\v\f") != line.npos) plain += line + "\n";
    std::istringstream rows(plain);
    std::string line;
    std::getline(rows, line);
    std::istringstream counts(line.substr(line.find("OFF") + 3));
    std::size_t vertices = 0, faces = 0;
    if (!(counts >> vertices >> faces))
    {
        std::getline(rows, line);
        std::istringstream(line) >> vertices >> faces;
    }
    for (std::size_t i = 0; i < vertices; ++i)
    {
        std::getline(rows, line);
        std::istringstream words(line);
        std::string x, y, z;
        words >> x >> y >> z;
        m.points.push_back({std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr), std::strtod(z.c_str(), nullptr)});
    }
    for (std::size_t i = 0; i < faces; ++i)
    {
        std::getline(rows, line);
        std::istringstream words(line);
        std::size_t n = 0, k = 0;
        std::vector<std::size_t> face;
        for (words >> n; face.size() < n && words >> k;) face.push_back(k);
        m.faces.push_back(face);
    }
    return m;
}

inline NaiveMesh naivePly(const std::string& bytes)
{
    struct Property
    {
        std::string name, count, type;
    };
    struct Element
    {
        std::string name;
        std::size_t rows;
        std::vector<Property> properties;
    };
    std::vector<Element> elements;
    std::istringstream in(bytes);
    std::string line, format;
    while (std::getline(in, line) && line.find("end_header") == line.npos)
    {
        std::istringstream words(line);
        std::string word, type, count, name;
        std::size_t rows = 0;
        words >> word;
        if (word == "format") words >> format;
        if (word == "element" && words >> name >> rows) elements.push_back({name, rows, {}});
        if (word != "property") continue;
        words >> type;
        if (type == "list") words >> count >> type;
        words >> name;
        elements.back().properties.push_back({name, count, type});
    }
    const auto next = [&](const std::string& type) -> double
    {
        if (format == "ascii")
        {
            std::string word;
            in >> word;
            return std::strtod(word.c_str(), nullptr);
        }
        const auto number = [&](auto value) -> double
        {
            std::array<char, sizeof value> raw{};
            in.read(raw.data(), sizeof value);
            if (format == "binary_big_endian") std::reverse(raw.begin(), raw.end());
            std::memcpy(&value, raw.data(), sizeof value);
            return double(value);
        };
        if (type == "char" || type == "int8") return number(std::int8_t());
        if (type == "uchar" || type == "uint8") return number(std::uint8_t());
        if (type == "short" || type == "int16") return number(std::int16_t());
        if (type == "ushort" || type == "uint16") return number(std::uint16_t());
        if (type == "int" || type == "int32") return number(std::int32_t());
        if (type == "uint" || type == "uint32") return number(std::uint32_t());
        if (type == "float" || type == "float32") return number(float());
        return number(double());
    };
    NaiveMesh m;
    for (const auto& element : elements)
        for (std::size_t row = 0; row < element.rows && in; ++row)
        {
            NaiveMesh::Point x{};
            std::vector<std::size_t> face;
            for (const auto& p : element.properties)
            {
                if (p.count.empty())
                {
                    const double value = next(p.type);
                    if (p.name == "x" || p.name == "y" || p.name == "z") x[std::size_t(p.name[0] - 'x')] = value;
                    continue;
                }
                const bool corners = p.name == "vertex_indices" || p.name == "vertex_index";
                const double n = next(p.count);
                for (double k = 0; k < n && in; ++k)
                    if (const double value = next(p.type); corners) face.push_back(std::size_t(value));
            }
            if (element.name == "vertex") m.points.push_back(x);
            if (element.name == "face") m.faces.push_back(face);
        }
    return m;
}

/// One buffer, as data of the file or binary part; triangles alone.
inline NaiveMesh naiveGltf(const std::string& bytes)
{
    auto text = bytes;
    std::string buffer;
    if (bytes.substr(0, 4) == "glTF")
    {
        std::uint32_t json = 0, binary = 0;
        std::memcpy(&json, bytes.data() + 12, 4);
        text = bytes.substr(20, json);
        std::memcpy(&binary, bytes.data() + 20 + json, 4);
        buffer = bytes.substr(28 + json, binary);
    }
    const auto j = nlohmann::json::parse(text);
    if (j.at("buffers").at(0).contains("uri"))
    {
        const std::string uri = j.at("buffers").at(0).at("uri"),
                          letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        buffer.clear();
        int bits = 0, held = 0;
        for (const char c : uri.substr(uri.find(',') + 1))
        {
            const auto value = letters.find(c);
            if (value == letters.npos) break;
            bits = (bits << 6 | int(value)) & 0xFFFF;
            if ((held += 6) >= 8) buffer += char(bits >> (held -= 8));
        }
    }
    const auto numbers = [&](std::size_t index, std::size_t components)
    {
        const auto a = j.at("accessors").at(index), view = j.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
        const int kind = a.at("componentType");
        const std::size_t size = kind < 5122 ? 1 : kind < 5124 ? 2 : 4;
        const auto begin = view.value("byteOffset", std::size_t(0)) + a.value("byteOffset", std::size_t(0)),
                   stride = view.value("byteStride", components * size);
        std::vector<double> all;
        for (std::size_t i = 0; i < a.at("count").get<std::size_t>(); ++i)
            for (std::size_t k = 0; k < components; ++k)
            {
                const auto raw = buffer.substr(begin + i * stride + k * size, size);
                const auto read = [&](auto value)
                {
                    std::memcpy(&value, raw.c_str(), sizeof value);
                    return double(value);
                };
                double x = kind == 5120   ? read(std::int8_t())
                           : kind == 5121 ? read(std::uint8_t())
                           : kind == 5122 ? read(std::int16_t())
                           : kind == 5123 ? read(std::uint16_t())
                           : kind == 5125 ? read(std::uint32_t())
                                          : read(float());
                if (a.value("normalized", false))
                    x = kind == 5120   ? std::max(x / 127, -1.0)
                        : kind == 5121 ? x / 255
                        : kind == 5122 ? std::max(x / 32767, -1.0)
                        : kind == 5123 ? x / 65535
                                       : x;
                all.push_back(x);
            }
        return all;
    };
    NaiveMesh m;
    std::vector<std::size_t> nodes;
    if (j.contains("scenes")) nodes = j.at("scenes").at(j.value("scene", std::size_t(0))).value("nodes", nodes);
    else
        for (std::size_t n = 0; n < j.at("nodes").size(); ++n) nodes.push_back(n);
    for (const auto n : nodes)
    {
        const auto node = j.at("nodes").at(n);
        if (!node.contains("mesh")) continue;
        const auto shift = node.value("translation", NaiveMesh::Point{0, 0, 0}), scale = node.value("scale", NaiveMesh::Point{1, 1, 1});
        for (const auto& primitive : j.at("meshes").at(node.at("mesh").get<std::size_t>()).at("primitives"))
        {
            if (primitive.value("mode", 4) != 4) continue;
            const auto first = m.points.size();
            const auto x = numbers(primitive.at("attributes").at("POSITION"), 3), corners = numbers(primitive.at("indices"), 1);
            for (std::size_t i = 0; i < x.size(); i += 3)
                m.points.push_back({shift[0] + scale[0] * x[i], shift[1] + scale[1] * x[i + 1], shift[2] + scale[2] * x[i + 2]});
            for (std::size_t k = 0; k < corners.size(); k += 3)
            {
                m.faces.push_back(
                    {first + std::size_t(corners[k]), first + std::size_t(corners[k + 1]), first + std::size_t(corners[k + 2])});
                if (scale[0] * scale[1] * scale[2] < 0) std::swap(m.faces.back()[1], m.faces.back()[2]);
            }
        }
    }
    return m;
}

}
