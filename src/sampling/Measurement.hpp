/// Measures: single numbers taken from a whole view that have a reference value of their own. They come from libraries that a case names by `libs`, as formulas do.
#pragma once
#include "dictionary/EntryList.hpp"
#include "sampling/Norms.hpp"
#include "sampling/ParticleView.hpp"
#include <concepts>
#include <filesystem>
#include <functional>
#include <memory>
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

/// A measure by the word for `name`, how it is read, and which entries it has.
struct MeasureType
{
    std::string name;
    Measure (*read)(const Dictionary&, const Geometry&, const std::vector<std::string>& phases, const std::filesystem::path& caseFolder);
    EntryList (*entries)();
};

/// The type of a class M that is made of a Dictionary, the geometry and the phases, or of a Dictionary, the phases and the case's folder. It has
/// `Measurement operator()(const ParticleView&)`, the static function `entries`, and where it keeps what it has seen, `lists()`.
template<class M> MeasureType measureType(const char* name)
{
    return {name,
            [](const Dictionary& d, [[maybe_unused]] const Geometry& geometry, const std::vector<std::string>& phases,
               [[maybe_unused]] const std::filesystem::path& folder) -> Measure
            {
                std::shared_ptr<M> made;
                if constexpr (std::constructible_from<M, const Dictionary&, const std::vector<std::string>&, const std::filesystem::path&>)
                    made = std::make_shared<M>(d, phases, folder);
                else made = std::make_shared<M>(d, geometry, phases);
                return {[made](const ParticleView& view) { return (*made)(view); },
                        [made]() -> std::vector<std::vector<double>*>
                        {
                            if constexpr (requires { made->lists(); }) return made->lists();
                            else return {};
                        }};
            },
            M::entries};
}

/// Adds a measure while it is constructed.
struct AddedMeasure
{
    explicit AddedMeasure(const MeasureType&);
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
