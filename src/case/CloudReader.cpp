#include "case/Cloud.hpp"
#include "case/FieldFile.hpp"
#include "dictionary/Dictionary.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <system_error>

namespace sph
{

namespace
{

/// OpenFOAM's tools add barycentric `coordinates` beside the positions: the same particles once more.
bool isField(const std::string& name) { return name != "positions" && name != "coordinates" && name.front() != '.' && name.back() != '~'; }

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

/// Checks that every written field is there: one that is lost, or copied without, would be taken for one that was never given. OpenFOAM's tools
/// write this file without the names, and then nothing is known.
void checkComplete(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud, const std::string& folder,
                   std::size_t particles, const std::vector<std::string>& files, Diagnostics& diagnostics)
{
    const auto file = time + "/uniform/lagrangian/" + cloud + "/cloudProperties";
    std::error_code none;
    if (!std::filesystem::exists(caseFolder / file, none)) return;
    const auto mistakes = std::make_shared<Diagnostics>();
    const auto written = Dictionary::read(caseFolder, file, mistakes);
    std::vector<std::string> names;
    int count = int(particles);
    if (written.found("fields"))
    {
        names = written.get<std::vector<std::string>>("fields");
        count = written.subDict("processor0").get<int>("particleCount");
    }
    try
    {
        mistakes->throwIfAny();
    }
    catch (const CaseError& e)
    {
        return diagnostics.error({}, e.what());
    }
    if (std::size_t(count) != particles)
        diagnostics.error({folder + "/positions", 0}, fmt::format("has {} particles, and {} says {}", particles, file, count));
    for (const auto& name : names)
        if (std::ranges::find(files, name) == files.end())
            diagnostics.error({folder + "/" + name, 0},
                              fmt::format("is missing, and was written with the others: see `fields` in {}, and leave it out "
                                          "there if it is not meant to be read",
                                          file));
}

std::string cloudFolder(const std::string& time, const std::string& cloud) { return time + "/lagrangian/" + cloud; }

}

std::string Cloud::particle(std::size_t i) const
{
    return fmt::format("particle {} at ({:.6g} {:.6g} {:.6g})", before + i, x[i], y[i], z[i]);
}

Cloud readCloud(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud, Diagnostics& diagnostics,
                const FieldClasses& wanted, const Slice& slice)
{
    const auto folder = cloudFolder(time, cloud);
    Cloud result;
    result.folder = folder;
    auto positions = readPositions(caseFolder, folder + "/positions", diagnostics, slice);
    // The length of the fields is not known without positions.
    if (!positions) return result;
    result.x = std::move(positions->x);
    result.y = std::move(positions->y);
    result.z = std::move(positions->z);
    result.before = slice.begin(positions->count);
    const auto files = fieldsIn(caseFolder / folder);
    checkComplete(caseFolder, time, cloud, folder, positions->count, files, diagnostics);
    for (const auto& name : files)
    {
        const auto file = folder + "/" + name;
        const auto its = wanted.find(name);
        if (name.ends_with(".gz")) diagnostics.error({file, 0}, "compressed files are not read: gunzip it");
        else if (auto field = readField(caseFolder, file, positions->count, its == wanted.end() ? std::nullopt : std::optional(its->second),
                                        diagnostics, slice))
            result.fields[name] = std::move(*field);
    }
    return result;
}

std::vector<int> phasesOf(const Cloud& cloud, std::size_t phases)
{
    std::vector<int> result(cloud.size(), 0);
    const auto found = cloud.fields.find("phase");
    if (found == cloud.fields.end()) return result;
    const auto& index = found->second.component[0];
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        if (!(index[i] >= 0 && index[i] < double(phases) && index[i] == std::floor(index[i])))
            throw CaseError({cloud.folder + "/phase", 0},
                            fmt::format("{} has phase {}, but constant/phaseProperties lists {}", cloud.particle(i), index[i],
                                        phases == 1 ? "1 phase, 0" : fmt::format("{} phases, 0 to {}", phases, phases - 1)));
        result[i] = int(index[i]);
    }
    return result;
}

std::vector<double> volumesOf(const Cloud& cloud)
{
    const auto positive = [&](const std::string& name) -> const std::vector<double>&
    {
        const auto found = cloud.fields.find(name);
        if (found == cloud.fields.end()) throw CaseError({cloud.folder + "/" + name, 0}, "is missing: volumes are m/rho");
        const auto& values = found->second.component[0];
        for (std::size_t i = 0; i < cloud.size(); ++i)
            if (!(values[i] > 0))
                throw CaseError({cloud.folder + "/" + name, 0},
                                fmt::format("{} has {} {}, which must be positive", cloud.particle(i), name, values[i]));
        return values;
    };
    if (cloud.fields.contains("V")) return positive("V");
    const auto &m = positive("m"), &rho = positive("rho");
    std::vector<double> volumes(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) volumes[i] = m[i] / rho[i];
    return volumes;
}

bool hasCloud(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(caseFolder / cloudFolder(time, cloud) / "positions", ignored);
}

}
