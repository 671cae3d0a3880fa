/// Measures: single numbers taken from a whole view that have a reference value of their own.
#pragma once
#include "Dictionary.hpp"
#include "ParticleView.hpp"
#include <filesystem>
#include <functional>

namespace sph
{

struct Measurement
{
    double value = 0, reference = 0; ///< value is NaN where it cannot be measured, and `note` says why; reference where there is none now
    std::size_t particles = 0;       ///< that the value rests on
    std::string note;
};

using Measure = std::function<Measurement(const ParticleView&)>;

std::vector<std::string> measureNames();

/// Reads the parameters of measure `name`, one of measureNames(); `phases` are those that `phase` may name, tables lie in the case's folder.
Measure readMeasure(const std::string& name, const Dictionary&, const Geometry&, const std::vector<std::string>& phases,
                    const std::filesystem::path& caseFolder);

/// The index of the phase that an entry names; the first one where there is no such entry.
std::size_t readPhase(const Dictionary&, const std::string& key, const std::vector<std::string>& phases);

}
