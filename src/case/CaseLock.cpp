#include "case/CaseLock.hpp"
#include "base/CaseError.hpp"
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace sph
{

namespace
{
constexpr const char* lockFile = ".lock";

std::string contents(int descriptor)
{
    char text[512];
    const auto size = ::pread(descriptor, text, sizeof text, 0);
    return size > 0 ? std::string(text, std::size_t(size)) : "its name is not known";
}

/// The name may have gone to another file between its opening and its locking.
bool isStill(const std::filesystem::path& file, int descriptor)
{
    struct stat open, named;
    return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}
}

CaseLock::CaseLock(const std::filesystem::path& caseFolder, const std::string& program) : file_(caseFolder / lockFile)
{
    const auto fail = [](const std::string& what) { throw CaseError({lockFile, 0}, what); };
    for (;;)
    {
        descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0) fail("cannot be made in the case: " + std::generic_category().message(errno));
        // Some file systems of networks know no locks: there, nothing is guarded.
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        {
            const auto other = contents(descriptor_);
            ::close(descriptor_);
            fail(fmt::format("another program is at work in this case: {}. Wait for it, or stop it: a signal TERM makes it write and end",
                             other));
        }
        if (isStill(file_, descriptor_)) break;
        ::close(descriptor_);
    }
    char host[256] = {};
    ::gethostname(host, sizeof host - 1);
    const auto text = fmt::format("{}, process {} on {}", program, ::getpid(), host);
    // The file stays empty on a full disk: the lock holds all the same.
    if (::ftruncate(descriptor_, 0) != 0 || ::pwrite(descriptor_, text.data(), text.size(), 0) < 0) return;
}

CaseLock::~CaseLock()
{
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
    ::close(descriptor_);
}

}
