/// Measures: single numbers taken from a whole view that have a reference value of their own.
#pragma once
#include "dictionary/EntryList.hpp"
#include "sampling/Norms.hpp"
#include "sampling/ParticleView.hpp"
#include <filesystem>
#include <functional>
#include <optional>

namespace sph
{

struct Measurement
{
    double value = 0;          ///< NaN where it cannot be measured; `note` then says why
    double reference = 0;      ///< NaN where there is none at this time
    std::size_t particles = 0; ///< that the value rests on
    std::string note;
    std::optional<Norms> errors = {}; ///< of what each particle has, not over the reference; without, of the value alone
};

/// A measure of a rate keeps what it has seen, and is asked in the order of time. `lists` are those of a restart, in their order.
struct Measure
{
    std::function<Measurement(const ParticleView&)> take;
    std::function<std::vector<std::vector<double>*>()> lists;
    explicit operator bool() const { return bool(take); }
    Measurement operator()(const ParticleView& view) const { return take(view); }
};

std::vector<std::string> measureNames();
/// The measures with their entries.
Cases measures();

/// Reads the parameters of measure `name`, nothing where it is none of measureNames(); `phases` are those that `phase` may name, tables lie in
/// the case's folder.
Measure readMeasure(const std::string& name, const Dictionary&, const Geometry&, const std::vector<std::string>& phases,
                    const std::filesystem::path& caseFolder);

/// The index of the phase that an entry names; the first one where there is no such entry.
std::size_t readPhase(const Dictionary&, const Word&, const std::vector<std::string>& phases);

}
