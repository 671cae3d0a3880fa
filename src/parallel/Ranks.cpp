#include "parallel/Ranks.hpp"
#include "base/CaseError.hpp"
#include <algorithm>
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
bool isLastRank() { return !present || present->rank() == present->count() - 1; }
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

void allOrNone(const std::function<void()>& act)
{
    if (!present) return act();
    std::string failure;
    try
    {
        act();
    }
    catch (const std::exception& e)
    {
        failure = e.what();
    }
    std::vector<std::size_t> lengths(std::size_t(present->count()));
    const std::size_t length = failure.size();
    present->gatherAll(std::as_bytes(std::span(&length, 1)), std::as_writable_bytes(std::span(lengths)));
    const auto first = std::ranges::find_if(lengths, [](std::size_t n) { return n > 0; });
    if (first == lengths.end()) return;
    failure.resize(*first);
    std::string failures(*first * lengths.size(), ' ');
    present->gatherAll(std::as_bytes(std::span(failure)), std::as_writable_bytes(std::span(failures)));
    throw CaseError(failures.substr(std::size_t(first - lengths.begin()) * *first, *first));
}

void byFirst(const std::function<void()>& act)
{
    allOrNone(
        [&]
        {
            if (isFirstRank()) act();
        });
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
