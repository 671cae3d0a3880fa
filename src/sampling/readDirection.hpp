/// Directions in dictionaries need not have length one.
#pragma once
#include "Dictionary.hpp"

namespace sph
{

/// The direction of an entry; a zero vector is an error.
inline Vector<3> readDirection(const Dictionary& dictionary, const std::string& key, const Vector<3>& fallback)
{
    const auto v = dictionary.get(key, fallback);
    if (mag(v) > 0) return v / mag(v);
    dictionary.error(key, key + " must not be a zero vector");
    return fallback;
}

}
