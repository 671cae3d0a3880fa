#include "case/Case.hpp"
#include "case/TimeName.hpp"
#include <algorithm>
#include <system_error>
#include <tuple>

namespace sph
{

Case::Case(const std::filesystem::path& folder) : folder_(folder)
{
    std::error_code reason;
    const auto status = std::filesystem::status(folder, reason);
    if (status.type() == std::filesystem::file_type::directory) return;
    if (status.type() == std::filesystem::file_type::not_found) throw CaseError("case folder \"" + folder.string() + "\" does not exist");
    throw CaseError("case \"" + folder.string() + "\" is not a folder");
}

bool Case::has(const std::string& file) const
{
    std::error_code ignored;
    return std::filesystem::exists(folder_ / file, ignored);
}

Dictionary Case::dictionary(const std::string& file) const { return Dictionary::read(folder_, file, diagnostics_); }

Dictionary Case::dictionaryIfPresent(const std::string& file) const
{
    return has(file) ? dictionary(file) : Dictionary::empty(file, diagnostics_);
}

std::vector<std::string> Case::times(const std::string& under) const
{
    std::vector<std::tuple<double, std::string>> found;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / under, ignored))
        if (const auto name = entry.path().filename().string(); entry.is_directory(ignored))
            if (const auto value = timeValue(name)) found.emplace_back(*value, name);
    std::sort(found.begin(), found.end());
    std::vector<std::string> names;
    for (const auto& [value, name] : found) names.push_back(name);
    return names;
}

}
