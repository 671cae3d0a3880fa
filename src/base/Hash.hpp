/// FNV-1a, 64 bits (Fowler, Noll & Vo): whether two texts or files are the same, not who wrote them.
#pragma once
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace sph
{

class Hash
{
    std::uint64_t value_ = 14695981039346656037u;

public:
    void add(std::string_view text)
    {
        for (const unsigned char c : text) value_ = (value_ ^ c) * 1099511628211u;
    }
    std::string hex() const { return fmt::format("{:016x}", value_); }
};

}
