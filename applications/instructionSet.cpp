/// Ends a program with a message where the machine lacks the vector instructions that it was compiled for; without this file its first such
/// instruction ends it, with no more than 'illegal instruction'. Runs before main, and before whatever other files initialise.
#include <cstdio>
#include <cstdlib>

namespace
{

struct Needed
{
    const char* name;
    bool present;
};

Needed needed()
{
    __builtin_cpu_init();
#if defined(__AVX512F__) && defined(__AVX512VL__)
    return {"AVX-512", __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")};
#elif defined(__AVX2__)
    return {"AVX2 and FMA", __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")};
#else
    return {"", true};
#endif
}

[[gnu::constructor(101)]] void checkInstructionSet()
{
    const auto [name, present] = needed();
    if (present) return;
    std::fprintf(stderr,
                 "This program was compiled for machines with %s, which this machine lacks.\n"
                 "Possible: compile on this machine; -DSPH_NATIVE=OFF (any machine with AVX2); -DSPH_ARCH=x86-64 (any x86-64).\n",
                 name);
    std::_Exit(1);
}

}
