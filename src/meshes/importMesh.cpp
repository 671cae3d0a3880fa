#include "importMesh.hpp"
#include "MappedFile.hpp"
#include "fileCheck.hpp"
#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace sph
{

namespace
{

/// Assimp goes on after most mistakes in a file, and tells of them here alone.
struct Complaints : Assimp::LogStream
{
    std::vector<std::string> lines;

    void write(const char* message) override
    {
        std::string line = message;
        line.erase(0, line.find(": ") + 2); // "Error, T0: "
        line.erase(line.find_last_not_of(" \n") + 1);
        // Colours are none of our business, and often missing.
        if (line.find("material") == line.npos) lines.push_back(line);
    }
};

/// Attached as long as it lives.
class Listener
{
    Complaints* complaints_ = new Complaints; // the logger's, once attached

public:
    Listener()
    {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
        Assimp::DefaultLogger::get()->attachStream(complaints_, Assimp::Logger::Err);
    }
    Listener(const Listener&) = delete;
    ~Listener() { Assimp::DefaultLogger::kill(); }
    const std::vector<std::string>& lines() const { return complaints_->lines; }
};

/// A word that a dictionary can have for a keyword.
std::string validWord(const std::string& name)
{
    std::string word = name;
    for (char& c : word)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
    if (!word.empty() && !std::isalpha(static_cast<unsigned char>(word.front()))) word.insert(0, "_");
    return word;
}

/// The number of fewest digits that single precision takes for this one: 0.2 of a file is 0.2, not 0.200000003.
double asWritten(float x)
{
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
    double value = 0;
    std::from_chars(text.data(), end, value);
    return value;
}

class SceneReader
{
    const aiScene& scene_;
    MeshFormat format_;
    NumberedMesh mesh_;
    std::vector<std::string> names_; ///< of the regions in the file
    std::vector<std::string>& notes_;
    std::size_t lines_ = 0;

    /// The name of its region in the file; empty where it has none.
    std::string nameOf(const aiMesh& part, const aiNode& node) const
    {
        if (format_ == MeshFormat::gltf)
        {
            aiString material;
            if (part.mMaterialIndex < scene_.mNumMaterials) scene_.mMaterials[part.mMaterialIndex]->Get(AI_MATKEY_NAME, material);
            return material.length > 0 && std::string(material.C_Str()) != AI_DEFAULT_MATERIAL_NAME ? material.C_Str() : part.mName.C_Str();
        }
        const std::string name = node.mName.C_Str();
        return format_ == MeshFormat::ply || format_ == MeshFormat::off || name == "<STL_BINARY>" || name == "defaultobject" ? "" : name;
    }

    int region(const std::string& name)
    {
        const auto known = std::find(names_.begin(), names_.end(), name);
        const auto index = int(known - names_.begin());
        if (known != names_.end()) return index;
        auto word = name.empty() ? fmt::format("patch{}", index) : validWord(name);
        const auto same = word;
        for (int n = 2; std::find(mesh_.regions.begin(), mesh_.regions.end(), word) != mesh_.regions.end(); ++n)
            word = fmt::format("{}_{}", same, n);
        if (!name.empty() && word != name) notes_.push_back(fmt::format("region \"{}\" is called {}", name, word));
        names_.push_back(name);
        mesh_.regions.push_back(word);
        return index;
    }

    void add(const aiMesh& part, const aiNode& node, const aiMatrix4x4& toScene)
    {
        const int offset = int(mesh_.points.size()), r = region(nameOf(part, node));
        for (unsigned i = 0; i < part.mNumVertices; ++i)
        {
            const aiVector3D x = toScene * part.mVertices[i];
            mesh_.points.push_back({asWritten(x.x), asWritten(x.y), asWritten(x.z)});
        }
        for (unsigned f = 0; f < part.mNumFaces; ++f)
        {
            const auto& face = part.mFaces[f];
            if (face.mNumIndices != 3)
            {
                ++lines_;
                continue;
            }
            std::array<int, 3> corners{};
            for (unsigned k = 0; k < 3; ++k)
            {
                if (face.mIndices[k] >= part.mNumVertices)
                    throw UnusableMesh(fmt::format("facet {} has the vertex {}, and there are {}", mesh_.triangles.size(), face.mIndices[k],
                                                   part.mNumVertices));
                corners[k] = offset + int(face.mIndices[k]);
            }
            mesh_.number.push_back(int(mesh_.triangles.size()));
            mesh_.triangles.push_back(corners);
            mesh_.region.push_back(r);
        }
    }

    void walk(const aiNode& node, const aiMatrix4x4& parent)
    {
        const aiMatrix4x4 toScene = parent * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], node, toScene);
        for (unsigned i = 0; i < node.mNumChildren; ++i) walk(*node.mChildren[i], toScene);
    }

public:
    SceneReader(const aiScene& scene, MeshFormat format, std::vector<std::string>& notes) : scene_(scene), format_(format), notes_(notes) {}

    NumberedMesh read()
    {
        walk(*scene_.mRootNode, aiMatrix4x4());
        if (lines_ > 0) notes_.push_back(counted(lines_, "face") + " of fewer than three corners left out");
        return std::move(mesh_);
    }
};

}

NumberedMesh importMesh(const std::filesystem::path& file, std::vector<std::string>& notes)
{
    const auto format = meshFormat(file);
    NumberedMesh mesh;
    try
    {
        const MappedFile bytes(file);
        if (const auto wrong = truncation(bytes.text(), format); !wrong.empty()) throw UnusableMesh(wrong);
        const Listener listener;
        Assimp::Importer importer;
        // By its name alone assimp does not know .stlb; what another file belongs to (glTF), it has to find.
        const auto* scene = format == MeshFormat::stl
                                ? importer.ReadFileFromMemory(bytes.text().data(), bytes.text().size(), aiProcess_Triangulate, "stl")
                                : importer.ReadFile(file.string(), aiProcess_Triangulate);
        if (!scene) throw UnusableMesh(fmt::format("it cannot be read: {}", importer.GetErrorString()));
        if (!listener.lines().empty()) throw UnusableMesh(fmt::format("it is damaged: {}", fmt::join(listener.lines(), "; ")));
        mesh = SceneReader(*scene, format, notes).read();
    }
    catch (const UnusableMesh&)
    {
        throw;
    }
    catch (const std::exception& e)
    {
        throw UnusableMesh(fmt::format("it cannot be read: {}", e.what()));
    }
    if (mesh.triangles.empty()) throw UnusableMesh("it has no facets");
    return mesh;
}

void place(NumberedMesh& m, const TriSurface& t)
{
    // Rodrigues: x cos + (k x x) sin + k (k.x)(1 - cos); right angles exactly.
    const double turns = t.angle / 90;
    const bool right = turns == std::round(turns);
    const auto quarter = int(std::fmod(std::fmod(turns, 4) + 4, 4));
    const double c = right ? (quarter == 0) - (quarter == 2) : std::cos(t.angle * std::numbers::pi / 180),
                 s = right ? (quarter == 1) - (quarter == 3) : std::sin(t.angle * std::numbers::pi / 180);
    for (auto& x : m.points)
    {
        const auto y = t.scale * x;
        x = c * y + s * cross(t.axis, y) + (1 - c) * dot(t.axis, y) * t.axis + t.translation;
    }
}

double weldOf(const Box& box) { return 1e-6 * mag(box.high - box.low); }

}
