/// A scalar that rides on the particles: its entries of one value for each phase, its initial values, and what an inlet brings of it.
#pragma once
#include "dictionary/Dictionary.hpp"
#include "scene/State.hpp"
#include <string>
#include <vector>

namespace sph
{

/// A value of each phase: `key value;` for all, or `key { water value; air value; }`. `read(dictionary, key)` reads one.
template<class T, class Read>
std::vector<T> ofPhases(const Dictionary& d, const std::string& key, const std::vector<std::string>& phases, const Read& read)
{
    if (!d.isDictionary(key)) return std::vector<T>(phases.size(), read(d, key));
    std::vector<T> values;
    for (const auto& phase : phases) values.push_back(read(d.subDict(key), phase));
    return values;
}

/// The entry `initial`: of each phase a number or an expression of $x $y $z; "0" where a dictionary has none. Mistakes go to the dictionary's Diagnostics.
std::vector<std::string> readInitial(const Dictionary&, const std::vector<std::string>& phases);

/// The field as state: `initial` of each phase where the time folder has no such field, and from inlets the entry of the field's name. `file` is where errors
/// of `initial` lie.
Evolving carriedScalar(const StateField& value, const StateField& rate, const std::vector<std::string>& initial, const std::string& file);

}
