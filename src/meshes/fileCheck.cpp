#include "fileCheck.hpp"
#include "NumberedMesh.hpp"
#include "plyCheck.hpp"
#include "textParts.hpp"
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <map>

namespace sph
{

namespace
{

/// Assimp ends a line at a zero and at a form feed.
bool isText(std::string_view text)
{
    return std::none_of(text.begin(), text.end(),
                        [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t'; });
}

/// Of lines with anything but blanks and comments.
std::size_t fullLines(std::string_view rest)
{
    std::size_t n = 0;
    while (!rest.empty())
    {
        auto line = nextLine(rest);
        const auto word = nextWord(line);
        n += !word.empty() && word.front() != '#';
    }
    return n;
}

std::string stl(std::string_view text)
{
    constexpr std::size_t header = 80, perFacet = 50;
    if (text.size() >= header + 4)
    {
        std::uint32_t facets = 0;
        std::memcpy(&facets, text.data() + header, 4);
        const auto whole = header + 4 + perFacet * std::size_t(facets);
        if (text.size() == whole) return facets == 0 ? "it has no facets" : "";
        // No text has a zero, and the count of fewer than 2^24 facets ends with one.
        const bool binary = text.substr(0, header + 4).find('\0') != text.npos;
        if (binary && text.size() < whole)
            return fmt::format("its header tells of {} facets, {} are there: it is truncated", facets,
                               (text.size() - header - 4) / perFacet);
        if (binary) return fmt::format("its header tells of {} facets, and {} bytes follow them", facets, text.size() - whole);
    }
    std::size_t begun = 0, ended = 0, solids = 0, closed = 0;
    while (!text.empty())
    {
        auto line = nextLine(text);
        const auto word = nextWord(line);
        begun += word == "facet";
        ended += word == "endfacet";
        solids += word == "solid";
        closed += word == "endsolid";
    }
    if (solids == 0) return "it begins with no solid: this is no STL file";
    if (begun == 0) return "it has no facets";
    if (begun != ended || closed < solids)
        return fmt::format("{} of {} facets and {} of {} solids are ended: it is truncated", ended, begun, closed, solids);
    return "";
}

std::string obj(std::string_view text)
{
    while (!text.empty())
    {
        auto line = nextLine(text);
        if (nextWord(line) == "v") return "";
    }
    return "it has no vertices: this is no OBJ file";
}

std::string gltf(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t\r\n");
    return text.substr(0, 4) == "glTF" || (first != text.npos && text[first] == '{')
               ? ""
               : "it begins with neither glTF nor {: this is no glTF file";
}

std::string off(std::string_view text)
{
    std::vector<std::size_t> counts;
    bool first = true;
    while (!text.empty() && counts.size() < 3)
    {
        auto line = nextLine(text);
        for (auto word = nextWord(line); !word.empty() && word.front() != '#'; word = nextWord(line))
        {
            if (first && word.find("OFF") == word.npos) return "it does not begin with OFF: this is no OFF file";
            if (!first) counts.push_back(number(word));
            first = false;
        }
    }
    if (counts.size() < 3) return "it ends within its header";
    if (counts[1] == 0) return "it has no facets";
    const auto lines = fullLines(text);
    if (lines < counts[0] + counts[1])
        return fmt::format("its header tells of {} vertices and {} facets, but {} lines follow: it is truncated", counts[0], counts[1],
                           lines);
    for (std::size_t row = 0; row < counts[0] + counts[1];)
    {
        auto line = nextLine(text);
        auto word = nextWord(line);
        if (word.empty() || word.front() == '#' || row++ < counts[0]) continue;
        const auto facet = row - 1 - counts[0], corners = number(word);
        if (corners < 3) return fmt::format("facet {} of {} has {} corners", facet, counts[1], corners);
        for (std::size_t k = 0; k < corners; ++k)
            if (word = nextWord(line); number(word) >= counts[0] || word.find_first_not_of("0123456789") != word.npos || word.empty())
                return fmt::format("facet {} of {} has the vertex \"{}\", and there are {}", facet, counts[1], word, counts[0]);
    }
    return "";
}

}

MeshFormat meshFormat(const std::filesystem::path& file)
{
    static const std::map<std::string, MeshFormat> formats{{".stl", MeshFormat::stl}, {".stlb", MeshFormat::stl},
                                                           {".obj", MeshFormat::obj}, {".ply", MeshFormat::ply},
                                                           {".off", MeshFormat::off}, {".gltf", MeshFormat::gltf},
                                                           {".glb", MeshFormat::gltf}};
    auto end = file.extension().string();
    std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const auto format = formats.find(end);
    if (format == formats.end())
        throw UnusableMesh(
            fmt::format("\"{}\" is no format that is known by its name. Known: .stl, .stlb, .obj, .ply, .off, .gltf, .glb", end));
    return format->second;
}

std::string truncation(std::string_view text, MeshFormat format)
{
    if (text.empty()) return "it is empty";
    switch (format)
    {
    case MeshFormat::stl:
        return stl(text);
    case MeshFormat::ply:
        return brokenPly(text);
    case MeshFormat::off:
        return isText(text) ? off(text) : "it has characters that no text has: this is no OFF file";
    // These have no counts to compare with.
    case MeshFormat::obj:
        return obj(text);
    case MeshFormat::gltf:
        return gltf(text);
    }
    return "";
}

}
