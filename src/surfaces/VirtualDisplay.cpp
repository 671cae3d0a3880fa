#include "surfaces/VirtualDisplay.hpp"
#include "base/CaseError.hpp"
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sph
{

namespace
{

constexpr int secondsToStart = 30;
constexpr int notInstalled = 127; // as the shell has it
/// Above those that other programs look at: mpirun asks each display from 0 to 9 for its graphics cards, and is ended by X where a display goes meanwhile.
constexpr int firstNumber = 100, numbers = 30000;

class Descriptor
{
    int fd_;

public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    void close()
    {
        if (fd_ >= 0) ::close(fd_);
        fd_ = -1;
    }
    operator int() const { return fd_; }
};

/// The first number that no server has, from one that differs from process to process, so that two that start at once take two.
int freeNumber()
{
    int n = firstNumber + getpid() % numbers;
    while (std::filesystem::exists("/tmp/.X11-unix/X" + std::to_string(n))) ++n;
    return n;
}

/// The child: becomes Xvfb, which writes its display number to `number` when it is ready.
[[noreturn]] void becomeServer(int number, int messages, pid_t parent)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(1);
    dup2(messages, STDOUT_FILENO);
    dup2(messages, STDERR_FILENO);
    fcntl(number, F_SETFD, 0);
    const auto descriptor = std::to_string(number), display = ":" + std::to_string(freeNumber());
    execlp("Xvfb", "Xvfb", display.c_str(), "-displayfd", descriptor.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
           "-noreset", nullptr);
    _exit(errno == ENOENT ? notInstalled : 1);
}

/// Text that Xvfb writes until the end of the line; empty where it ends or takes too long.
std::string firstLine(int fd)
{
    std::string line;
    pollfd wait{fd, POLLIN, 0};
    char c;
    while (poll(&wait, 1, 1000 * secondsToStart) > 0 && read(fd, &c, 1) == 1)
    {
        if (c == '\n') return line;
        line += c;
    }
    return "";
}

std::string contents(int fd)
{
    std::string text(2000, ' ');
    const auto size = pread(fd, text.data(), text.size(), 0);
    text.resize(size > 0 ? size : 0);
    return text;
}

}

VirtualDisplay::VirtualDisplay()
{
    if (const char* display = std::getenv("DISPLAY"); display && *display) return;
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw CaseError("Cannot open a pipe to start Xvfb");
    const Descriptor readEnd(ends[0]);
    Descriptor writeEnd(ends[1]);
    const Descriptor messages(memfd_create("Xvfb", MFD_CLOEXEC));
    const pid_t parent = getpid();
    server_ = fork();
    if (server_ < 0) throw CaseError("Cannot start Xvfb: no process can be made");
    if (server_ == 0) becomeServer(writeEnd, messages, parent);
    writeEnd.close();

    const auto number = firstLine(readEnd);
    if (number.empty())
    {
        kill(server_, SIGTERM);
        int status = 0;
        waitpid(server_, &status, 0);
        server_ = -1;
        if (WIFEXITED(status) && WEXITSTATUS(status) == notInstalled)
            throw CaseError("Pictures need an X display: DISPLAY is not set and Xvfb is not installed (Debian: apt install xvfb)");
        throw CaseError(fmt::format("Pictures need an X display: DISPLAY is not set and Xvfb did not start\n{}", contents(messages)));
    }
    setenv("DISPLAY", (":" + number).c_str(), 1);
}

VirtualDisplay::~VirtualDisplay()
{
    if (server_ <= 0) return;
    unsetenv("DISPLAY");
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

}
