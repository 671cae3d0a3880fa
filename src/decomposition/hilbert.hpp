/// Places along a Hilbert curve: J. Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707 (2004) 381.
#pragma once
#include <array>
#include <cstdint>

namespace sph
{

/// Number of binary digits that each coordinate may have so that the index has 64 at most.
template<std::size_t dim> constexpr int hilbertBits = 64 / int(dim) - (dim == 2 ? 1 : 0);

/// The index along the curve of a cell of a lattice with 2^hilbertBits cells to the side. Cells of successive indices are neighbours.
template<std::size_t dim> std::uint64_t hilbertIndex(std::array<std::uint32_t, dim> x)
{
    constexpr int bits = hilbertBits<dim>;
    constexpr std::uint32_t highest = std::uint32_t(1) << (bits - 1);
    // The inverse of Skilling's undoing of excess work, and then the Gray code.
    for (std::uint32_t q = highest; q > 1; q >>= 1)
        for (auto& x_k : x)
            if (x_k & q) x[0] ^= q - 1;
            else
            {
                const std::uint32_t swapped = (x[0] ^ x_k) & (q - 1);
                x[0] ^= swapped;
                x_k ^= swapped;
            }
    for (std::size_t k = 1; k < dim; ++k) x[k] ^= x[k - 1];
    std::uint32_t parity = 0;
    for (std::uint32_t q = highest; q > 1; q >>= 1)
        if (x[dim - 1] & q) parity ^= q - 1;
    for (auto& x_k : x) x_k ^= parity;
    // Transposed: digit by digit, one of each coordinate.
    std::uint64_t index = 0;
    for (int bit = bits - 1; bit >= 0; --bit)
        for (const auto x_k : x) index = index << 1 | (x_k >> bit & 1);
    return index;
}

}
