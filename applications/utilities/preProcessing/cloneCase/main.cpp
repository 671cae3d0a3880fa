/// Makes variants of a case, as cases of their own.
#include "base/CommandLine.hpp"
#include "sweeps/cloneCase.hpp"
#include <fmt/format.h>

int main(int argc, char** argv)
{
    std::vector<std::string> names;
    return sph::runApplication(
        "cloneCase", argc, argv,
        "Makes variants of a case: run/<name> with the files of variants/<name> and the entries of <name> in system/variantsDict, and\n"
        "prints the path. <a>-<b> has the changes of both. What is in the folder already and is no input of a run stays.",
        [&](sph::CommandLine& line) { line.argument("names", names, "Variants").required(); },
        [&](const std::filesystem::path& caseFolder)
        {
            for (const auto& name : names) fmt::print("{}\n", (caseFolder / sph::cloneCase(caseFolder, name)).lexically_normal().string());
            return 0;
        },
        sph::Banner::none);
}
