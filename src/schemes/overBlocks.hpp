/// Sums over particles that are the same bits on any number of threads: by blocks, of which each thread takes some, to be added up in order.
#pragma once
#include <algorithm>
#include <vector>

namespace sph
{

/// f(begin, end) of each block of the particles 0 .. n - 1, in the order of the blocks.
template<class F> auto overBlocks(std::size_t n, const F& f)
{
    const std::size_t block = 4096, blocks = (n + block - 1)/block;
    std::vector<decltype(f(n, n))> parts(blocks);
    #pragma omp parallel for schedule(static)
    for (std::size_t b = 0; b < blocks; ++b) parts[b] = f(b*block, std::min(n, (b + 1)*block));
    return parts;
}

}
