#include "sweeps/ChildProcess.hpp"
#include "base/CaseError.hpp"
#include "base/Clock.hpp"
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace sph
{

namespace
{

constexpr double secondsToEnd = 5; ///< from TERM to KILL: time to write a time folder

std::string reasonOf(int error) { return std::generic_category().message(error); }

/// Becomes the program, with calls alone that POSIX permits between fork and exec; a failure is told to the parent through the pipe.
[[noreturn]] void becomeProgram(const ProcessTask& task, char* const* arguments, int pipe)
{
    const auto giveUp = [pipe]
    {
        const int reason = errno;
        if (::write(pipe, &reason, sizeof reason) < 0) ::_exit(126);
        ::_exit(127);
    };
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    for (const int s : {SIGINT, SIGTERM, SIGCHLD, SIGPIPE}) ::signal(s, SIG_DFL);
    if (task.core)
    {
        cpu_set_t cores;
        CPU_ZERO(&cores);
        CPU_SET(std::size_t(*task.core), &cores);
        if (::sched_setaffinity(0, sizeof cores, &cores) != 0) giveUp();
    }
    const int in = ::open("/dev/null", O_RDONLY), out = ::open(task.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (in < 0 || out < 0 || ::dup2(in, 0) < 0 || ::dup2(out, 1) < 0 || ::dup2(out, 2) < 0) giveUp();
    if (::chdir(task.folder.c_str()) != 0) giveUp();
    ::execv(arguments[0], arguments);
    giveUp();
    ::_exit(127);
}

double seconds(const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); }

bool isProgram(const std::filesystem::path& path)
{
    std::error_code none;
    return std::filesystem::is_regular_file(path, none) && ::access(path.c_str(), X_OK) == 0;
}

}

std::string ProcessOutcome::inWords() const
{
    if (stopped) return "stopped";
    if (reachedLimit) return "stopped at the time limit";
    if (signal != 0) return fmt::format("killed by signal {} ({})", signal, ::strsignal(signal));
    return fmt::format("exit code {}", exitCode);
}

ProcessOutcome runProcess(const ProcessTask& task)
{
    auto absolute = task;
    absolute.log = std::filesystem::absolute(task.log);
    std::vector<char*> arguments;
    for (auto& word : absolute.command) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw CaseError(fmt::format("no pipe to {}: {}", task.command.front(), reasonOf(errno)));
    const Clock clock;
    const pid_t child = ::fork();
    if (child == 0) becomeProgram(absolute, arguments.data(), ends[1]);
    const int forkError = errno;
    ::close(ends[1]);
    int startError = 0;
    ssize_t got = 0;
    if (child > 0) do
            got = ::read(ends[0], &startError, sizeof startError);
        while (got < 0 && errno == EINTR);
    ::close(ends[0]);
    if (child < 0) startError = forkError;
    if (child < 0 || got == ssize_t(sizeof startError))
    {
        if (child > 0) ::waitpid(child, nullptr, 0);
        throw CaseError(fmt::format("{} cannot be started in {}: {}", task.command.front(), task.folder.string(), reasonOf(startError)));
    }

    ProcessOutcome outcome;
    rusage use{};
    int status = 0;
    std::optional<double> askedToEnd;
    while (::wait4(child, &status, WNOHANG, &use) != child)
    {
        const double now = clock.clockTime();
        if (!askedToEnd)
        {
            outcome.reachedLimit = task.wallLimit && now > *task.wallLimit;
            outcome.stopped = !outcome.reachedLimit && !task.goOn();
            if (outcome.reachedLimit || outcome.stopped)
            {
                askedToEnd = now;
                ::kill(-child, SIGTERM);
            }
        }
        else if (now > *askedToEnd + secondsToEnd) ::kill(-child, SIGKILL);
        // Short runs are timed to the millisecond; long ones are not disturbed.
        std::this_thread::sleep_for(std::chrono::milliseconds(now < 1 ? 1 : 20));
    }
    outcome.wallSeconds = clock.clockTime();
    outcome.cpuSeconds = seconds(use.ru_utime) + seconds(use.ru_stime);
    outcome.peakMemory = 1024.0 * double(use.ru_maxrss);
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return outcome;
}

std::optional<std::filesystem::path> findProgram(const std::string& name)
{
    if (name.empty()) return {};
    if (name.find('/') != name.npos) return isProgram(name) ? std::optional(std::filesystem::absolute(name)) : std::nullopt;
    std::error_code none;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", none);
    if (!none && isProgram(self.parent_path() / name)) return self.parent_path() / name;
    const char* path = std::getenv("PATH");
    std::string rest = path ? path : "";
    while (!rest.empty())
    {
        const auto colon = rest.find(':');
        const auto folder = rest.substr(0, colon);
        if (!folder.empty() && isProgram(std::filesystem::path(folder) / name)) return std::filesystem::absolute(folder) / name;
        rest = colon == rest.npos ? "" : rest.substr(colon + 1);
    }
    return {};
}

std::vector<int> usableCores()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> cores;
    if (::sched_getaffinity(0, sizeof set, &set) == 0)
        for (int k = 0; k < CPU_SETSIZE; ++k)
            if (CPU_ISSET(std::size_t(k), &set)) cores.push_back(k);
    return cores;
}

std::string failureIn(const std::string& log)
{
    const std::string mark = "--> FATAL ERROR\n";
    const auto at = log.rfind(mark);
    if (at == std::string::npos) return "";
    auto text = log.substr(at + mark.size());
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

}
