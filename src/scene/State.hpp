/// State of a scene: one declaration for each field that evolves. Allocating, loading, sorting, predicting, kicking, correcting, inlets,
/// buffer particles, writing and restart walk this list (Particles.hpp); none of them knows a field by name.
#pragma once
#include "case/Cloud.hpp"
#include "dictionary/Dictionary.hpp"
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

/// A field by its name in this scene, without its type.
struct StateField
{
    FieldInfo info;
    std::string name;
    std::array<ValueType, 2> types; ///< in two and three dimensions
    const ValueType& type(int dimension) const { return types[std::size_t(dimension) - 2]; }
    int in(int dimension) const { return type(dimension).components; }
};
template<class F> StateField stateField(F, const std::string& name = F::info.name)
{
    return {F::info, name, {valueType<FieldValue<F, 2>>, valueType<FieldValue<F, 3>>}};
}

/// Source from which a field is loaded.
struct Loading
{
    const Cloud& cloud;
    const Coefficients& coefficients;
    const std::vector<int>& phases; ///< of the particles
    bool restarted;                 ///< the time folder was written by a run
    std::vector<double*> values;    ///< by component, of all particles

    std::size_t size() const { return cloud.size(); }
    std::size_t phaseOf(std::size_t i) const { return std::size_t(phases[i]); }
    /// Throws CaseError, with file and particle, where a value of the file `name` is not within factors of that of a particle at rest.
    void checkScale(const std::string& name, const std::string& unit, double least, double most,
                    const std::function<double(std::size_t)>& atRest) const;
};

struct Evolving
{
    StateField value;
    std::optional<StateField> rate = {}; ///< value += dt rate; without one the value is moved by a stage of its model, or stays
    bool advancedByModel = false;        ///< at steps of its own: prediction and kick leave it alone
    bool written = true;                 ///< into time folders; what is not follows from the rest
    bool ofMaterial = false; ///< a property of the fluid or soil at a place, which other particles there take over (src/mapping)
    std::string onDisk = {}; ///< where the file has another name
    std::function<void(const Loading&)> missing = {}; ///< where the time folder has no such field; default 0
    std::function<void(const Loading&)> loaded = {};  ///< what other fields of the time folder make of it
    std::function<void(const Loading&)> check = {};   ///< throws CaseError where a value cannot be
    std::function<double(const Dictionary&, std::size_t phase)> inlet =
        {};                  ///< of what comes in, from the dictionary of its opening; default 0
    std::string amount = {}; ///< what openings call sum q m/rho_0 [m^3] of a fraction q, and count

    std::string startName() const { return value.name + "_0"; } ///< of the value at the start of a step
    const std::string& fileName() const { return onDisk.empty() ? value.name : onDisk; }
};

using State = std::vector<Evolving>;

}
