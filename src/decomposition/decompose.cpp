#include "decomposition/decompose.hpp"
#include "base/Hash.hpp"
#include "base/OutputFile.hpp"
#include "base/readText.hpp"
#include "case/TimeFolder.hpp"
#include "case/TimeName.hpp"
#include "case/cloudViews.hpp"
#include "case/labelEntries.hpp"
#include "decomposition/processorFolders.hpp"
#include "geometry/Geometry.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <system_error>

namespace sph
{

namespace
{
constexpr const char* cloudName = "sph";

Cloud partOf(const Cloud& cloud, const std::vector<std::size_t>& members)
{
    const auto take = [&](const std::vector<double>& a)
    {
        std::vector<double> part;
        part.reserve(members.size());
        for (const auto i : members) part.push_back(a[i]);
        return part;
    };
    Cloud part{cloud.folder, take(cloud.x), take(cloud.y), take(cloud.z), {}};
    for (const auto& [name, field] : cloud.fields)
    {
        auto& to = part.fields[name] = {field.type, {}};
        for (const auto& a : field.component) to.component.push_back(take(a));
    }
    return part;
}

void append(Cloud& cloud, const Cloud& more)
{
    const auto join = [](std::vector<double>& a, const std::vector<double>& b) { a.insert(a.end(), b.begin(), b.end()); };
    join(cloud.x, more.x);
    join(cloud.y, more.y);
    join(cloud.z, more.z);
    for (auto& [name, field] : cloud.fields)
        for (std::size_t c = 0; c < field.component.size(); ++c) join(field.component[c], more.fields.at(name).component[c]);
}

void write(const std::filesystem::path& timeFolder, const Cloud& cloud, const WriteOptions& options)
{
    writeCloud(timeFolder, cloudName, cloud.size(), positionsOf(cloud), fieldsOf(cloud), options);
}

/// Numbers of a restart: the same for all parts.
void copyUniform(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::error_code reason;
    for (const auto& entry : std::filesystem::directory_iterator(from / "uniform", reason))
    {
        if (!entry.is_regular_file()) continue;
        const auto copy = to / "uniform" / entry.path().filename();
        if (!std::filesystem::copy_file(entry.path(), copy, reason))
            throw CaseError({copy.string(), 0}, "cannot be copied: " + reason.message());
    }
}

Cloud read(const Case& theCase, const std::string& time, const FieldClasses& wanted = {})
{
    Diagnostics mistakes;
    auto cloud = readCloud(theCase.folder(), time, cloudName, mistakes, wanted);
    mistakes.throwIfAny();
    return cloud;
}

void label(Cloud& cloud, const std::vector<std::string>& labels)
{
    for (const auto& name : labels)
    {
        const auto [field, isNew] = cloud.fields.try_emplace(name, CloudField{FieldClass::label, {std::vector<double>(cloud.size(), 0.0)}});
        if (isNew && name == origId) std::iota(field->second.component[0].begin(), field->second.component[0].end(), 0.0);
    }
}

std::string stampOf(const std::vector<Cloud>& clouds)
{
    Hash hash;
    for (const auto& cloud : clouds)
    {
        hash.add(cloud.folder);
        for (const auto* a : {&cloud.x, &cloud.y, &cloud.z})
            hash.add({reinterpret_cast<const char*>(a->data()), a->size() * sizeof(double)});
    }
    return hash.hex();
}

using Members = std::vector<std::vector<std::size_t>>;

Members membersOf(const Cloud& cloud, int dimension, const Decomposition& d)
{
    if (cloud.size() < std::size_t(d.parts))
        throw CaseError({decompositionDictionary, 0},
                        fmt::format("{} parts for the {} particles of {}: {}", d.parts, cloud.size(), cloud.folder,
                                    cloud.size() ? "take fewer" : "mpirun shares what openings bring without decomposeParticles"));
    std::vector<Vector<3>> places;
    for (std::size_t i = 0; i < cloud.size(); ++i) places.push_back({cloud.x[i], cloud.y[i], cloud.z[i]});
    const auto parts = divide(d.method, dimension, places, std::size_t(d.parts));
    Members members(std::size_t(d.parts));
    for (std::size_t i = 0; i < parts.size(); ++i) members[std::size_t(parts[i])].push_back(i);
    return members;
}

void checkSameRun(const Case& theCase, int part, const std::string& time)
{
    const auto file = [&](int k) { return processorFolder(k) + "/" + time + "/uniform/time"; };
    std::string none;
    if (readText(theCase.folder() / file(part), none) != readText(theCase.folder() / file(0), none))
        throw CaseError({file(part), 0}, fmt::format("differs from {}: one run has not written both", file(0)));
}

/// Checks that a part has the same fields as the parts before it.
void checkFields(const Cloud& whole, const Cloud& part)
{
    for (const auto& [name, _] : whole.fields)
        if (!part.fields.contains(name))
            throw CaseError({part.folder + "/" + name, 0}, fmt::format("is missing, and {} has it", whole.folder));
    for (const auto& [name, _] : part.fields)
        if (!whole.fields.contains(name))
            throw CaseError({whole.folder + "/" + name, 0}, fmt::format("is missing, and {} has it", part.folder));
}
}

std::vector<std::vector<std::size_t>> decompose(const Case& theCase, const std::vector<std::string>& times, const Decomposition& d,
                                                const WriteOptions& options)
{
    const auto geometry = readDomain(theCase);
    const auto labels = entry::shown(theCase.dictionaryIfPresent("system/sphSchemes"));
    theCase.diagnostics().throwIfAny();
    std::vector<Cloud> clouds;
    std::vector<Members> members;
    for (const auto& time : times)
    {
        clouds.push_back(read(theCase, time));
        label(clouds.back(), labels);
        members.push_back(membersOf(clouds.back(), geometry.dimension, d));
    }
    const auto stamp = stampOf(clouds);
    const auto [low, high] = boundingBox(geometry);
    const auto fill = [&](const std::filesystem::path& folder, int part)
    {
        writePolyMesh(folder, low, high);
        writePortion(folder, {part, d.parts, stamp, times});
        for (std::size_t t = 0; t < times.size(); ++t)
        {
            write(folder / times[t], partOf(clouds[t], members[t][std::size_t(part)]), options);
            copyUniform(theCase.folder() / times[t], folder / times[t]);
        }
    };
    removeProcessorFolders(theCase.folder());
    try
    {
        for (int part = 0; part < d.parts; ++part)
            writeFolder(theCase.folder(), processorFolder(part), [&](const auto& folder) { fill(folder, part); });
    }
    catch (...)
    {
        removeProcessorFolders(theCase.folder());
        throw;
    }
    std::vector<std::vector<std::size_t>> sizes(times.size());
    for (std::size_t t = 0; t < times.size(); ++t)
        for (const auto& part : members[t]) sizes[t].push_back(part.size());
    return sizes;
}

std::vector<std::string> processorTimes(const Case& theCase)
{
    const int parts = countProcessorFolders(theCase.folder());
    if (parts == 0) throw CaseError({processorFolder(0), 0}, "is missing: the case has not been decomposed");
    if (theCase.has(decompositionDictionary))
    {
        const auto d = readDecomposition(theCase);
        theCase.diagnostics().throwIfAny();
        if (d.parts != parts)
            throw CaseError(theCase.dictionary(decompositionDictionary).where("numberOfSubdomains"),
                            fmt::format("numberOfSubdomains is {}, and the case has {} processor folders", d.parts, parts));
    }
    std::map<double, std::string> names;
    for (int part = 0; part < parts; ++part)
    {
        readPortion(theCase, part, parts);
        for (const auto& name : theCase.times(processorFolder(part))) names.emplace(*timeValue(name), name);
    }
    std::vector<std::string> times;
    for (const auto& [_, name] : names) times.push_back(name);
    return times;
}

std::vector<std::string> dividedTimes(const Case& theCase)
{
    auto times = readPortion(theCase, 0, countProcessorFolders(theCase.folder())).times;
    std::erase_if(times, [&](const auto& time) { return !hasCloud(theCase.folder(), time, cloudName); });
    return times;
}

std::size_t reconstruct(const Case& theCase, const std::string& time, const WriteOptions& options)
{
    const auto timeOf = [&](int part) { return processorFolder(part) + "/" + time; };
    const int parts = countProcessorFolders(theCase.folder());
    for (int part = 0; part < parts; ++part)
        if (!theCase.has(timeOf(part)))
            throw CaseError(
                {timeOf(part), 0},
                "is missing, and others have that time: a run was stopped while it wrote, or the folder was removed. Choose other times, "
                "or remove this one from all");
    Cloud whole;
    for (int part = 0; part < parts; ++part)
    {
        checkSameRun(theCase, part, time);
        FieldClasses classes;
        for (const auto& [name, field] : whole.fields) classes[name] = field.type;
        auto next = read(theCase, timeOf(part), classes);
        if (part == 0) whole = std::move(next);
        else
        {
            checkFields(whole, next);
            append(whole, next);
        }
    }
    writeFolder(theCase.folder(), time,
                [&](const std::filesystem::path& folder)
                {
                    write(folder, whole, options);
                    copyUniform(theCase.folder() / timeOf(0), folder);
                });
    return whole.size();
}

}
