/// An X display to draw on where there is none: Debian's VTK draws through X only.
#pragma once
#include <string>
#include <sys/types.h>

namespace sph
{

/// While it lives, DISPLAY names a display: the one that is set already, or an Xvfb of its own on a free number from 100 on, which ends with
/// this object or, whatever happens, with the process. Throws CaseError where Xvfb is not installed or does not start.
/// Make it in the main thread and before any window; one at a time.
class VirtualDisplay
{
    pid_t server_ = -1;

public:
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    /// True where this object started a server.
    bool started() const { return server_ > 0; }
};

}
