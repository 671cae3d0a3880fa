/// The signals that ask a program to end: what it has done is to be kept.
#pragma once
#include <csignal>

namespace sph
{

/// Handles the signals of a user, of a queue, of a terminal that is closed. One that is ignored, as under nohup, stays so.
inline void onStopSignals(void (*handler)(int))
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}
