/// What is wrong with a file of triangles before anything is read of it: assimp takes truncated files for whole ones.
#pragma once
#include <filesystem>
#include <string>

namespace sph
{

enum class MeshFormat
{
    stl,
    obj,
    ply,
    off,
    gltf
};

/// By the end of the name; throws UnusableMesh where it is none of them.
MeshFormat meshFormat(const std::filesystem::path&);

/// "4 of 12 facets are there", or nothing.
std::string truncation(std::string_view text, MeshFormat);

}
