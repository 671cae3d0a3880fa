#include "Ranks.hpp"
#include <ctime>
#include <dlfcn.h>
#include <stdexcept>
#include <utility>

namespace sph
{

namespace
{
std::unique_ptr<const Ranks> joined;
const Ranks* present = nullptr;
}

const Ranks* ranks() { return present; }
bool isFirstRank() { return !present || present->rank() == 0; }
double busyTime()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec) - (present ? present->waited().processor : 0);
}
void waitForFirst()
{
    if (!isFirstRank()) present->barrier();
}
void firstIsThrough()
{
    if (present && isFirstRank()) present->barrier();
}

void startRanks()
{
    // A process alone neither loads MPI nor waits for it.
    void* const library = dlopen("libsphRanks.so", RTLD_NOW | RTLD_GLOBAL);
    if (!library) throw std::runtime_error(std::string("ranks need the library libsphRanks.so: ") + dlerror());
    using Make = Ranks*();
    auto* const make = reinterpret_cast<Make*>(dlsym(library, "makeRanks"));
    if (!make) throw std::runtime_error(std::string("libsphRanks.so: ") + dlerror());
    joined.reset(make());
    if (joined->count() > 1) present = joined.get();
}

Alone::Alone() : before_(std::exchange(present, nullptr)) {}
Alone::~Alone() { present = before_; }

}
