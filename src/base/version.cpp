#include "base/version.hpp"
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>
#include <utility>

namespace sph
{

namespace
{

Version& current()
{
    static Version version{"unknown", ""};
    return version;
}

std::string hostName()
{
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    return name;
}

}

std::string Version::text() const { return commit.empty() ? number : fmt::format("{} ({})", number, commit); }

const Version& version() { return current(); }
void setVersion(Version built) { current() = std::move(built); }

std::string banner(const std::string& program, const std::filesystem::path& caseFolder, const std::string& further)
{
    const auto now = fmt::localtime(std::time(nullptr));
    return fmt::format("sphFoamLike: smoothed particle hydrodynamics in case folders\n\n"
                       "Build  : {}\nExec   : {}\nDate   : {:%b %d %Y}\nTime   : {:%H:%M:%S}\nHost   : {}\nPID    : {}\nCase   : {}\n{}\n",
                       version().text(), program, now, now, hostName(), getpid(), std::filesystem::weakly_canonical(caseFolder).string(),
                       further);
}

}
