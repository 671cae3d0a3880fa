/// A model: one room with its words, its terms and laws, its state, its limits and columns, and what it cannot go with. Registered once
/// (models.cpp); all else of the suite knows models by this alone.
#pragma once
#include "dictionary/EntryList.hpp"
#include "scene/Settings.hpp"
#include <functional>
#include <optional>

namespace sph
{

/// Measured values that limits of the step are made of.
struct Measured
{
    double maxSpeed = 0, maxAcceleration = 0, maxSlowAcceleration = 0;
    std::optional<double> leastViscosity, largestViscosity; ///< of the moment, where viscosity is a field of its own [Pa s]
};

/// Input of a model while settings are read, and the settings that it fills.
struct Reading
{
    const Case& theCase;
    const Geometry& geometry;
    const Dictionary& schemes; ///< system/sphSchemes
    const Dictionary& phases;  ///< constant/phaseProperties
    Settings& settings;
    /// Limits of the step, as far as the settings have been read: what a default may hang on.
    std::vector<StepLimit> (*limits)(const Settings&, const Measured&);

    /// Whether the set of words is that of the paper on beds.
    bool paper() const;
    /// The word of an entry of system/sphSchemes, and keeps it.
    const std::string& choose(const Choice& entry, const std::string& fallback) const;
    const std::string& choose(const Choice& entry) const { return choose(entry, entry.info().fallback); }
    void select(const std::string& term) const { settings.terms.push_back(term); }
    /// An entry that does nothing without another one.
    void belongs(const Parameter& entry, const Parameter& to) const;
    /// An entry of the user's that does nothing in this scene is an error, which says why: "no phase has mu".
    void doesNothing(const Parameter& entry, const std::string& why) const;
};

/// Two choices that do not go together: an error at the first, which says why.
struct Conflict
{
    std::string entry;
    std::function<bool(const Settings&)> applies;
    std::string why;
};

/// Entries of a file that a model reads; `meaning` of the file, said once.
struct FileEntries
{
    std::string file;
    EntryList entries;
    std::string meaning = {};
};

using Limit = std::optional<StepLimit> (*)(const Settings&, const Measured&);

struct Model
{
    const char *word, *meaning;
    void (*read)(const Reading&); ///< words to terms, state, what runs
    Catalogue<2> terms2;
    Catalogue<3> terms3;
    void (*prepare)(const Reading&) = nullptr; ///< before all models read: what others' defaults hang on
    std::vector<Conflict> conflicts = {};      ///< looked at when all have read
    std::vector<Limit> limits = {};            ///< of the step, where particles move
    std::vector<FileEntries> entries = {};     ///< for the reference of entries
    void (*declare)(const Reading&) =
        nullptr; ///< before a set of schemes is chosen and any model prepares: facts that files say by themselves

    template<int dim> const Catalogue<dim>& terms() const
    {
        if constexpr (dim == 2) return terms2;
        else return terms3;
    }
};

}
