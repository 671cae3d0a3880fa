#include "base/OutputFile.hpp"
#include "case/Cloud.hpp"
#include "case/TimeFolder.hpp"
#include "geometry/components.hpp"
#include "geometry/makeWallLayers.hpp"
#include <fmt/format.h>

namespace sph
{

namespace
{
constexpr auto cloudName = "wallLayers";
constexpr auto fieldFolder = "constant/lagrangian/wallLayers/";
}

void writeWallLayers(const std::filesystem::path& caseFolder, const std::vector<LayerParticle>& layers)
{
    std::array<std::vector<double>, 3> x;
    std::vector<double> wall, factor;
    for (const auto& particle : layers)
    {
        for (int c = 0; c < 3; ++c) x[c].push_back(particle.x.*component(c));
        wall.push_back(particle.wall);
        factor.push_back(particle.volumeFactor);
    }
    const FieldView positions{"positions", FieldClass::vector, {x[0].data(), x[1].data(), x[2].data()}};
    // Whole in a folder of its own before what was there goes.
    const auto constant = caseFolder / "constant";
    writeFolder(constant, cloudName,
                [&](const std::filesystem::path& folder)
                {
                    writeCloud(folder, cloudName, layers.size(), positions,
                               {{"wall", FieldClass::label, {wall.data()}}, {"volumeFactor", FieldClass::scalar, {factor.data()}}}, {});
                });
    removeWallLayers(caseFolder);
    for (const char* part : {"lagrangian", "uniform/lagrangian"})
    {
        createFolders(constant / part);
        std::filesystem::rename(constant / cloudName / part / cloudName, constant / part / cloudName);
    }
    std::filesystem::remove_all(constant / cloudName);
}

void removeWallLayers(const std::filesystem::path& caseFolder)
{
    std::filesystem::remove_all(caseFolder / "constant" / "lagrangian" / cloudName);
    std::filesystem::remove_all(caseFolder / "constant" / "uniform" / "lagrangian" / cloudName);
    for (const char* folder : {"lagrangian", "uniform/lagrangian", "uniform"})
        if (const auto emptied = caseFolder / "constant" / folder;
            std::filesystem::is_directory(emptied) && std::filesystem::is_empty(emptied))
            std::filesystem::remove(emptied);
}

std::vector<LayerParticle> readWallLayers(const std::filesystem::path& caseFolder, std::size_t walls, Diagnostics& diagnostics)
{
    const std::string folder = fieldFolder;
    if (!hasCloud(caseFolder, "constant", cloudName))
    {
        diagnostics.error(
            {"constant/lagrangian/wallLayers", 0},
            "is missing, and `walls layers;` is in system/sphSchemes: run meshToGhost, which makes it from constant/geometry");
        return {};
    }
    const auto cloud =
        readCloud(caseFolder, "constant", cloudName, diagnostics, {{"wall", FieldClass::label}, {"volumeFactor", FieldClass::scalar}});
    const auto wall = cloud.fields.find("wall"), factor = cloud.fields.find("volumeFactor");
    for (const auto& [field, name] : {std::pair{wall, "wall"}, std::pair{factor, "volumeFactor"}})
        if (field == cloud.fields.end() && diagnostics.ok()) diagnostics.error({folder + name, 0}, "is missing: run meshToGhost again");
    if (!diagnostics.ok()) return {};
    std::vector<LayerParticle> layers;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const double w = wall->second.component[0][i], f = factor->second.component[0][i];
        if (!(w >= 0 && w < double(walls)))
        {
            diagnostics.error({folder + "wall", 0},
                              fmt::format("particle {} belongs to wall {}, and there are {}: run meshToGhost again", i, w, walls));
            return {};
        }
        if (!(f > 0))
        {
            diagnostics.error({folder + "volumeFactor", 0},
                              fmt::format("particle {} has the factor {}, which must be greater than 0: run meshToGhost again", i, f));
            return {};
        }
        layers.push_back({{cloud.x[i], cloud.y[i], cloud.z[i]}, f, int(w)});
    }
    return layers;
}

}
