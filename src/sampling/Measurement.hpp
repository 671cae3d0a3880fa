/// Measures: single numbers taken from a whole view that have a reference value of their own.
#pragma once
#include "Dictionary.hpp"
#include "ParticleView.hpp"
#include <functional>

namespace sph
{

struct Measurement
{
    double value = 0, reference = 0; ///< value is NaN where it cannot be measured; `note` then says why
    std::size_t particles = 0;       ///< that the value rests on
    std::string note;
};

/// A measure of a rate keeps what it has seen, and is asked in the order of time.
using Measure = std::function<Measurement(const ParticleView&)>;

std::vector<std::string> measureNames();

/// Reads the parameters of measure `name`, one of measureNames(); `phases` are those that `phase` may name.
Measure readMeasure(const std::string& name, const Dictionary&, const Geometry&, const std::vector<std::string>& phases);

/// The index of the phase that an entry names; the first one where there is no such entry.
std::size_t readPhase(const Dictionary&, const std::string& key, const std::vector<std::string>& phases);

}
