/// A full disk, on any machine.
#pragma once
#include <csignal>
#include <sys/resource.h>

namespace sph::test
{

/// Files cannot grow beyond some bytes while it lives: what a full disk does, on any machine.
class SmallFiles
{
    rlimit before_{};

public:
    explicit SmallFiles(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallFiles() { setrlimit(RLIMIT_FSIZE, &before_); }
};

}
