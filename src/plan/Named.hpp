/// Terms of which there are several kinds, by a policy, under a name each.
#pragma once
#include <algorithm>
#include <cstddef>

namespace sph
{

/// A sum under the name of a term.
template<std::size_t n> struct TermName
{
    char text[n];
    constexpr TermName(const char (&of)[n]) { std::copy_n(of, n, text); }
};
template<TermName term, class Sum> struct Named : Sum
{
    static constexpr auto name = term.text;
    using Sum::Sum;
};

}
