/// A mesh prepared as meshToGhost does it, in a case of its own: domain (-2 -2 -2) to (2 2 2), spacing 0.01, H = 0.026.
#pragma once
#include "meshTexts.hpp"
#include "meshes/prepareMesh.hpp"
#include "temporaryCase.hpp"

namespace sph::test
{

struct Prepared
{
    TemporaryCase scene;
    std::shared_ptr<Diagnostics> diagnostics = std::make_shared<Diagnostics>();
    PreparedMesh mesh;
    std::string errors, warnings, repairs;

    /// `entries` after `fluid outside;`, which a second `fluid` replaces.
    Prepared(const std::string& file, const std::string& text, const std::string& entries = "", const std::array<bool, 3>& periodic = {})
    {
        scene.write("constant/triSurface/" + file, text);
        const auto walls =
            Dictionary::parse("rock\n{\n    type triSurface;\n    file \"" + file + "\";\n    fluid outside;\n    " + entries + "\n}\n",
                              "constant/geometry", diagnostics);
        const auto wall = walls.subDict("rock");
        wall.ignore("type");
        const auto source = readTriSurface(wall);
        walls.reportUnused();
        if (diagnostics->ok())
            mesh = prepareMesh(scene.folder(), source,
                               {.low = {-2, -2, -2}, .high = {2, 2, 2}, .periodic = periodic, .spacing = 0.01, .H = 0.026}, *diagnostics);
        errors = messages(*diagnostics);
        for (const auto& w : diagnostics->warnings()) warnings += w + "\n";
        for (const auto& r : mesh.repairs) repairs += r + "\n";
    }
    bool showsDefects() const { return scene.has("constant/triSurface/rock.defects.vtp"); }
};

inline Prepared prepared(const Mesh& m, const std::string& entries = "") { return {"rock.stl", solid(m), entries}; }

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}
