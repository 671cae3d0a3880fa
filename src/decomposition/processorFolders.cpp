#include "decomposition/processorFolders.hpp"
#include "base/OutputFile.hpp"
#include "base/words.hpp"
#include "case/FoamHeader.hpp"
#include "case/TimeFolder.hpp"
#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <system_error>

namespace sph
{

namespace
{
constexpr const char *prefix = "processor", *portionFile = "constant/decomposition";

/// The numbers of folders whose names have one, sorted.
std::vector<int> numbersOf(const std::filesystem::path& caseFolder)
{
    constexpr std::size_t mostDigits = 8;
    std::vector<int> numbers;
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(caseFolder, unreadable))
    {
        const auto name = entry.path().filename().string();
        if (!name.starts_with(prefix) || !entry.is_directory(unreadable)) continue;
        const auto digits = name.substr(std::string(prefix).size());
        const bool isNumber =
            !digits.empty() && digits.size() <= mostDigits && std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c); });
        if (isNumber) numbers.push_back(std::stoi(digits));
    }
    std::ranges::sort(numbers);
    return numbers;
}

constexpr const char* anew = "decomposeParticles -force makes them anew, from a time folder of the case";

Portion parse(const Case& theCase, int part)
{
    const auto file = processorFolder(part) + "/" + portionFile;
    if (!theCase.has(file)) throw CaseError({file, 0}, fmt::format("is missing: the folder is none of decomposeParticles. {}", anew));
    const auto mistakes = std::make_shared<Diagnostics>();
    const auto dict = Dictionary::read(theCase.folder(), file, mistakes);
    Portion p{dict.get<int>("part"), dict.get<int>("numberOfSubdomains"), dict.get<std::string>("stamp"),
              dict.get<std::vector<std::string>>("times")};
    mistakes->throwIfAny();
    return p;
}
}

std::string processorFolder(int part) { return fmt::format("{}{}", prefix, part); }

int countProcessorFolders(const std::filesystem::path& caseFolder)
{
    const auto numbers = numbersOf(caseFolder);
    for (std::size_t k = 0; k < numbers.size(); ++k)
        if (numbers[k] != int(k))
            throw CaseError({processorFolder(int(k)), 0},
                            fmt::format("is missing, and {} is there. {}", processorFolder(numbers.back()), anew));
    return int(numbers.size());
}

void removeProcessorFolders(const std::filesystem::path& caseFolder)
{
    for (const int number : numbersOf(caseFolder)) removeFolder(caseFolder, processorFolder(number));
}

void writePortion(const std::filesystem::path& folder, const Portion& p)
{
    createFolders((folder / portionFile).parent_path());
    writeFile(folder / portionFile,
              foamHeader(WriteFormat::ascii, "dictionary", "constant", "decomposition") +
                  fmt::format("// Made by decomposeParticles.\nnumberOfSubdomains {};\npart  {};\nstamp \"{}\";\ntimes (\"{}\");\n",
                              p.parts, p.part, p.stamp, fmt::join(p.times, "\" \"")));
}

Portion readPortion(const Case& theCase, int part, int parts)
{
    const auto own = parse(theCase, part);
    const auto fail = [&](const std::string& what) {
        throw CaseError({processorFolder(part) + "/" + portionFile, 0}, fmt::format("{}. {}", what, anew));
    };
    if (own.parts != parts) fail(fmt::format("is of one of {} folders, and the case has {}", own.parts, parts));
    if (own.part != part) fail(fmt::format("is that of {}", processorFolder(own.part)));
    if (part > 0 && parse(theCase, 0).stamp != own.stamp) fail("is of another decomposition than that of processor0");
    return own;
}

}
