/// Dictionaries in OpenFOAM's syntax, in which every entry remembers its file and line and whether it was read.
///
/// A Dictionary is a cheap handle on a parsed (sub-)dictionary. Look-ups never throw: what is missing or wrong is recorded in the
/// Diagnostics that all dictionaries of a case share, with file and line, what was meant and what is possible, and a harmless value
/// is returned, so that one run reports every mistake of a case. `Diagnostics::throwIfAny` ends the set-up.
#pragma once
#include "base/CaseError.hpp"
#include "base/DimensionSet.hpp"
#include "base/Vector.hpp"
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sph
{

class Dictionary
{
public:
    struct Node;

    /// Reads `caseFolder/file`; messages name `file` as given. A file that cannot be read is recorded as an error and gives an
    /// empty dictionary.
    static Dictionary read(const std::filesystem::path& caseFolder, const std::string& file, std::shared_ptr<Diagnostics>);

    /// Parses a dictionary from text, for tests and defaults.
    static Dictionary parse(const std::string& text, const std::string& file, std::shared_ptr<Diagnostics>);

    /// An empty dictionary of that name: each look-up with a fallback succeeds.
    static Dictionary empty(const std::string& name, std::shared_ptr<Diagnostics>);

    /// Path of this dictionary, "system/controlDict.functions.probes".
    const std::string& name() const;
    /// Last word of the path, "probes".
    std::string keyword() const;
    Location location() const;

    bool found(const std::string& key) const;
    /// Location of an entry; this dictionary's own where it is missing.
    Location where(const std::string& key) const;
    /// Keywords in the order of the file, "FoamFile" left out. Listing does not count as reading.
    std::vector<std::string> keys() const;
    bool isDictionary(const std::string& key) const;
    /// True where the entry is this one word, as in `soundSpeed automatic;`.
    bool isWord(const std::string& key, const std::string& word) const;

    /// A missing sub-dictionary is an error; `subDictOrEmpty` gives an empty one silently.
    Dictionary subDict(const std::string& key) const;
    Dictionary subDictOrEmpty(const std::string& key) const;
    /// `( {..} {..} )` and `( name {..} name {..} )`, in order; unnamed ones are called by their number.
    std::vector<Dictionary> dictionaries(const std::string& key) const;

    /// T: double, int, bool, std::string (a word or a quoted string), Vector<3>, std::vector of these, std::vector<std::vector<double>>.
    /// A missing entry is an error in the first form. Values are checked: a number that is no number, an excess token, NaN, infinity.
    template<class T> T get(const std::string& key) const;
    template<class T> T get(const std::string& key, const T& fallback) const;
    std::string get(const std::string& key, const char* fallback) const { return get<std::string>(key, fallback); }
    /// A path, variables and names of folders expanded (expandPath.hpp), relative to `folder` of the case.
    std::string getPath(const std::string& key, const std::string& folder, const std::string& fallback) const;

    /// A dimensioned scalar or vector: `nu [0 2 -1 0 0 0 0] 1e-6;`, `nu nu [..] 1e-6;`, `nu [m^2/s] 1e-6;`, or the plain value.
    /// Dimensions other than those expected are an error.
    double get(const std::string& key, const DimensionSet& expected) const;
    double get(const std::string& key, const DimensionSet& expected, double fallback) const;
    Vector<3> getVector(const std::string& key, const DimensionSet& expected) const;
    Vector<3> getVector(const std::string& key, const DimensionSet& expected, Vector<3> fallback) const;

    /// A value as from `get`, which must be > 0 (>= 0).
    double getPositive(const std::string& key, const DimensionSet& expected) const;
    double getPositive(const std::string& key, const DimensionSet& expected, double fallback) const;
    double getNonNegative(const std::string& key, const DimensionSet& expected, double fallback) const;

    /// A word that must be one of `valid`: otherwise the error says what was meant and what is possible.
    std::string choose(const std::string& key, std::span<const std::string> valid) const;
    std::string choose(const std::string& key, std::span<const std::string> valid, const std::string& fallback) const;

    /// `( (water air) 0.072 (water oil) 0.03 )`, as OpenFOAM's `sigma`: pairs of words with a value each, `(water and air) 0.072` too.
    struct PairValue
    {
        std::string first, second;
        double value;
    };
    std::vector<PairValue> pairs(const std::string& key) const;

    /// Records an error at an entry (or at this dictionary where the entry is missing).
    void error(const std::string& key, const std::string& what) const;
    Diagnostics& diagnostics() const;
    std::shared_ptr<Diagnostics> sharedDiagnostics() const;

    /// Every entry that nothing has read becomes an error, with the nearest keyword that was looked up and all such keywords.
    /// Looking up with a fallback counts as known. Goes down into sub-dictionaries that were read.
    void reportUnused() const;
    /// Declares an entry, and all below it, as none of this program's business.
    void ignore(const std::string& key) const;

    /// The parsed entries, for the tools of this module that print and edit dictionaries.
    Node& node() const { return *node_; }

private:
    explicit Dictionary(std::shared_ptr<Node> node) : node_(std::move(node)) {}
    std::shared_ptr<Node> node_;
};

}
