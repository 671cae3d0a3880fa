#include "Cloud.hpp"
#include "FieldFile.hpp"
#include <algorithm>
#include <system_error>

namespace sph
{

namespace
{

/// OpenFOAM's tools add barycentric `coordinates` beside the positions: the same particles once more.
bool isField(const std::string& name)
{
    return name != "positions" && name != "coordinates" && name.front() != '.' && name.back() != '~';
}

/// Sorted, so that errors come in the same order everywhere.
std::vector<std::string> fieldsIn(const std::filesystem::path& folder)
{
    std::vector<std::string> names;
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
        if (const auto name = entry.path().filename().string(); isField(name) && !entry.is_directory()) names.push_back(name);
    std::sort(names.begin(), names.end());
    return names;
}

std::string cloudFolder(const std::string& time, const std::string& cloud) { return time + "/lagrangian/" + cloud; }

}

Cloud readCloud(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud,
                Diagnostics& diagnostics)
{
    const auto folder = cloudFolder(time, cloud);
    Cloud result;
    auto positions = readPositions(caseFolder, folder + "/positions", diagnostics);
    // How long the fields must be is not known without positions.
    if (!positions) return result;
    result.x = std::move(positions->x);
    result.y = std::move(positions->y);
    result.z = std::move(positions->z);
    for (const auto& name : fieldsIn(caseFolder / folder))
    {
        const auto file = folder + "/" + name;
        if (name.ends_with(".gz"))
            diagnostics.error({file, 0}, "compressed files are not read: gunzip it");
        else if (auto field = readField(caseFolder, file, result.size(), diagnostics))
            result.fields[name] = std::move(*field);
    }
    return result;
}

bool hasCloud(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(caseFolder / cloudFolder(time, cloud) / "positions", ignored);
}

}
