/// Entries of dictionaries, each declared once: the object that declares an entry reads it, checks it, and documents it.
///
///     const Scalar soundFactor{"soundFactor", units::none, 0.4, positive, "share of the limit by the speed of sound"};
///     const Choice density{"density", {"numberDensity", "continuity"}, "numberDensity", "where the density comes from"};
///     const Scalar support{"support", units::m, byScene("3 spacings"), positive, "support of the kernel"};
///
///     const double f = soundFactor(dict);                // with the declared default
///     const double h = support(dict, 3*scene.spacing);   // with a default that the scene decides
///     if (const auto p = leastPressure.ifGiven(dict)) ...
///
/// Reading is Dictionary's: nothing throws, mistakes are recorded with file and line, and a harmless value is returned. Declarations are
/// constants beside the reader; the EntryList of the file (EntryList.hpp) collects them for `sphDictionary -list` and the pages of
/// doc/reference.
#pragma once
#include "dictionary/Dictionary.hpp"
#include <cassert>
#include <initializer_list>
#include <limits>

namespace sph
{

/// A unit and how the reference writes it, "kg/m^3".
struct Unit
{
    DimensionSet dimensions;
    std::string text;
    Unit(const DimensionSet&);
    Unit(const DimensionSet& d, std::string t) : dimensions(d), text(std::move(t)) {}
};
inline const Unit degrees{units::none, "degrees"};

/// The values that a number may have.
struct Range
{
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    bool lowIncluded = true, highIncluded = true;
    std::string complaint = {}; ///< in place of: "keyword" must be ..., found ..; a {} in it stands for the value

    bool holds(double value) const;
    /// A value that is possible: 0, else 1, else the end that is included.
    double harmless() const;
    /// "> 0", "0 to 180"; empty where every number will do.
    std::string text() const;
    /// Message about a wrong value: "width" must be positive, found -1.
    std::string wrong(const std::string& keyword, double value) const;
    /// A range with a complaint of its own, which gives the reason: "theta is 1/2 (Crank-Nicolson) to 1 (Euler)".
    Range saying(std::string reason) const;
};
inline const Range anyNumber, positive{.low = 0, .lowIncluded = false}, nonNegative{.low = 0};
inline Range atLeast(double low) { return {.low = low}; }
inline Range between(double low, double high) { return {.low = low, .high = high}; }
inline Range positiveBelow(double high) { return {.low = 0, .high = high, .lowIncluded = false, .highIncluded = false}; }
inline Range positiveUpTo(double high) { return {.low = 0, .high = high, .lowIncluded = false}; }

/// Mark in place of a default: the entry must be there.
inline constexpr struct Required
{
} required;

/// A default that the reader decides from the scene; the reference prints these words, "3 spacings".
struct ByScene
{
    std::string text;
};
inline ByScene byScene(std::string text) { return {std::move(text)}; }
/// The entry may be missing, and then there is no such thing.
inline const ByScene notGiven{"none"};

template<class T> struct Default
{
    std::optional<T> value;
    std::optional<std::string> words;
    Default(Required) {}
    Default(ByScene b) : words(std::move(b.text)) {}
    template<class V>
    requires std::convertible_to<V, T> Default(const V& v) : value(T(v)) {}
};

/// A word and, where the word does not say all, its meaning.
struct ChoiceWord
{
    std::string word, meaning;
    ChoiceWord(const char* w) : word(w) {}
    ChoiceWord(std::string w, std::string m = "") : word(std::move(w)), meaning(std::move(m)) {}
};

struct ChoiceWords : std::vector<ChoiceWord>
{
    ChoiceWords() = default;
    ChoiceWords(std::initializer_list<ChoiceWord> words) : vector(words) {}
    ChoiceWords(std::span<const std::string> words) : vector(words.begin(), words.end()) {}
    ChoiceWords(const std::vector<std::string>& words) : ChoiceWords(std::span(words)) {}
    std::vector<std::string> words() const;
};

/// Description of an entry in the reference.
struct ParameterInfo
{
    std::string keyword, type, unit;
    std::string fallback;                     ///< the default as a dictionary writes it, or the words that tell how it is chosen
    bool isRequired = false, isFixed = false; ///< isFixed: `fallback` is a value
    std::string example;                      ///< a value that the entry may have, as a dictionary writes it
    std::string range, meaning;
    ChoiceWords choices = {};
};

class Parameter
{
protected:
    ParameterInfo info_;

public:
    explicit Parameter(ParameterInfo info) : info_(std::move(info)) {}
    const ParameterInfo& info() const { return info_; }
    const std::string& keyword() const { return info_.keyword; }
    bool given(const Dictionary& d) const { return d.found(keyword()); }
    Location where(const Dictionary& d) const { return d.where(keyword()); }
    /// Records an error at the entry.
    void error(const Dictionary& d, const std::string& what) const { d.error(keyword(), what); }
    /// Records an error where a vector points out of the plane of a 2-D scene: what it gives along z would come to nothing.
    void checkPlane(const Dictionary& d, const Vector<3>& value, int dimension) const;
};

/// Text of a value as a dictionary writes it.
std::string written(double);
std::string written(int);
std::string written(bool);
std::string written(const std::string&);
std::string written(const Vector<3>&);
template<class T> std::string written(const std::vector<T>& list)
{
    std::string text;
    for (const auto& value : list) text += (text.empty() ? "" : " ") + written(T(value));
    return "(" + text + ")";
}

/// Base of all entries with a value of type T.
template<class T> class ValueParameter : public Parameter
{
    std::optional<T> fallback_;

protected:
    T harmless_;
    /// The value of an entry that is there; where it is wrong, an error is recorded and `harmless` returned.
    virtual T read(const Dictionary&, const T& harmless) const = 0;

public:
    ValueParameter(ParameterInfo info, const Default<T>& fallback, T harmless)
        : Parameter(std::move(info)), fallback_(fallback.value), harmless_(std::move(harmless))
    {
        info_.isRequired = !fallback.value && !fallback.words;
        info_.isFixed = bool(fallback.value);
        info_.fallback = fallback.value ? written(*fallback.value) : fallback.words.value_or("");
        info_.example = written(fallback.value.value_or(harmless_));
    }
    virtual ~ValueParameter() = default;

    /// The value, or the declared default; a missing entry is an error where there is none.
    T operator()(const Dictionary& d) const
    {
        assert((fallback_ || info_.isRequired) && "the reader must decide the default");
        return fallback_ ? (*this)(d, *fallback_) : needed(d);
    }
    T operator()(const Dictionary& d, const T& fallback) const { return given(d) ? read(d, fallback) : fallback; }
    /// The value of an entry that must be there in this place, though it need not be everywhere.
    T needed(const Dictionary& d) const
    {
        if (given(d)) return read(d, harmless_);
        d.get<std::string>(keyword()); // which says that it is missing
        return harmless_;
    }
    std::optional<T> ifGiven(const Dictionary& d) const { return given(d) ? std::optional(read(d, harmless_)) : std::nullopt; }
};

/// A number with a unit: `nu 1e-6;`, `nu [m^2/s] 1e-6;`.
class Scalar : public ValueParameter<double>
{
    DimensionSet dimensions_;
    Range range_;
    double read(const Dictionary&, const double& harmless) const override;

public:
    Scalar(std::string keyword, const Unit&, const Default<double>&, const Range&, std::string meaning);
    Scalar(std::string keyword, const Unit& unit, const Default<double>& fallback, std::string meaning)
        : Scalar(std::move(keyword), unit, fallback, anyNumber, std::move(meaning))
    {}
    /// The same entry in another unit, for a quantity per length in 2-D and per area in 3-D.
    Scalar in(const DimensionSet&) const;
};

/// A number with a unit, or the word `automatic`, which is as good as none.
class AutomaticScalar : public Scalar
{
public:
    AutomaticScalar(std::string keyword, const Unit& unit, ByScene how, const Range& range, std::string meaning)
        : Scalar(std::move(keyword), unit, std::move(how), range, std::move(meaning))
    {
        info_.type = "number or automatic";
        info_.example = "automatic";
    }
    std::optional<double> operator()(const Dictionary& d) const { return d.isWord(keyword(), "automatic") ? std::nullopt : ifGiven(d); }
};

/// A whole number.
class Count : public ValueParameter<int>
{
    Range range_;
    int read(const Dictionary&, const int& harmless) const override;

public:
    Count(std::string keyword, const Default<int>&, const Range&, std::string meaning);
};

class Switch : public ValueParameter<bool>
{
    bool read(const Dictionary& d, const bool& harmless) const override { return d.get(keyword(), harmless); }

public:
    Switch(std::string keyword, const Default<bool>&, std::string meaning);
};

class VectorParameter : public ValueParameter<Vector<3>>
{
    DimensionSet dimensions_;
    Vector<3> read(const Dictionary& d, const Vector<3>& harmless) const override { return d.getVector(keyword(), dimensions_, harmless); }

public:
    VectorParameter(std::string keyword, const Unit&, const Default<Vector<3>>&, std::string meaning);
};

/// A vector whose length does not matter but must not be 0; of length one when read.
class Direction : public ValueParameter<Vector<3>>
{
    bool scaled_ = true;
    Vector<3> read(const Dictionary&, const Vector<3>& harmless) const override;

public:
    Direction(std::string keyword, const Default<Vector<3>>&, std::string meaning);
    /// The vector of the length that was given.
    Vector<3> asGiven(const Dictionary&) const;
};

/// One of several words, all of them known beforehand.
class Choice : public ValueParameter<std::string>
{
    std::vector<std::string> words_;
    std::string read(const Dictionary& d, const std::string&) const override { return d.choose(keyword(), words_); }

public:
    Choice(std::string keyword, ChoiceWords, const Default<std::string>&, std::string meaning);
    const std::vector<std::string>& words() const { return words_; }
    /// The number of the word in the order of the declaration.
    int index(const Dictionary& d) const { return indexOf((*this)(d)); }
    int indexOf(const std::string& word) const;
    /// Nothing where the word is missing or unknown: the other entries of the dictionary are then left in peace, since which belong to
    /// it depends on the word.
    std::optional<std::string> known(const Dictionary&) const;
    /// True where the entry is there and is this word.
    bool is(const Dictionary& d, const std::string& word) const { return d.isWord(keyword(), word); }
};

/// A word: the name of a field, of a phase ...
class Word : public ValueParameter<std::string>
{
    std::string read(const Dictionary& d, const std::string& harmless) const override { return d.get(keyword(), harmless); }

public:
    Word(std::string keyword, const Default<std::string>&, std::string meaning);
    /// One of the words that the scene knows.
    std::string among(const Dictionary& d, std::span<const std::string> valid) const { return d.choose(keyword(), valid); }
    std::string among(const Dictionary& d, std::span<const std::string> valid, const std::string& fallback) const
    {
        return d.choose(keyword(), valid, fallback);
    }
};

/// A text in quotes: a file name, an expression ...
class Text : public Word
{
public:
    Text(std::string keyword, const Default<std::string>&, std::string meaning);
};

/// The path of a file in quotes, with variables and the names of folders in it as #include has them: "$FOAM_CASE/measured.csv",
/// "<constant>/rock.stl". What is read is relative to a folder of the case.
class FileName : public Text
{
    std::string folder_;
    std::string read(const Dictionary& d, const std::string& harmless) const override { return d.getPath(keyword(), folder_, harmless); }

public:
    FileName(std::string keyword, std::string folder, const Default<std::string>& fallback, std::string meaning)
        : Text(std::move(keyword), fallback, std::move(meaning)), folder_(std::move(folder))
    {}
};

/// `(a b c)`; T: double, int, std::string, Vector<3>, std::vector<double>.
template<class T> class ListOf : public ValueParameter<std::vector<T>>
{
    std::vector<T> read(const Dictionary& d, const std::vector<T>& harmless) const override { return d.get(this->keyword(), harmless); }

public:
    ListOf(std::string keyword, const Unit&, const Default<std::vector<T>>&, std::string meaning);
    ListOf(std::string keyword, const Default<std::vector<T>>& fallback, std::string meaning)
        : ListOf(std::move(keyword), units::none, fallback, std::move(meaning))
    {}
};

/// A list of words, each of which must be known: `phases (water air);`.
class Choices : public ListOf<std::string>
{
    std::string things_;

public:
    /// `things` says in an error what the words are: "Known phases: water, air".
    Choices(std::string keyword, std::string things, ChoiceWords, const Default<std::vector<std::string>>&, std::string meaning);
    /// The chosen words; an unknown one is an error, and left out.
    std::vector<std::string> operator()(const Dictionary&) const;
    std::vector<std::string> operator()(const Dictionary&, const std::vector<std::string>& fallback) const;
    std::vector<std::string> among(const Dictionary&, std::span<const std::string> known, const std::vector<std::string>& fallback) const;
};

/// `( (water air) 0.072 )`; none where the entry is missing. A value out of range, a pair of a word with itself and a second value for a pair, in
/// whatever order its words come, are errors and left out.
class PairValues : public Parameter
{
    std::string what_;
    Range range_;

public:
    /// `what` a pair has, in an error: "surface tension".
    PairValues(std::string keyword, std::string what, const Unit&, const Range&, std::string meaning);
    std::vector<Dictionary::PairValue> operator()(const Dictionary& d) const;
};

/// A sub-dictionary; `optional`: it may be missing, and reads as an empty one.
class SubDictionary : public Parameter
{
public:
    SubDictionary(std::string keyword, Required, std::string meaning);
    SubDictionary(std::string keyword, ByScene, std::string meaning);
    Dictionary operator()(const Dictionary& d) const { return info_.isRequired ? needed(d) : d.subDictOrEmpty(keyword()); }
    /// The sub-dictionary, which must be there in this place, though it need not be everywhere.
    Dictionary needed(const Dictionary& d) const { return d.subDict(keyword()); }
};

/// `( {..} {..} )`, or a dictionary of named ones; none where it is missing and not required.
class DictionaryList : public Parameter
{
public:
    DictionaryList(std::string keyword, Required, std::string meaning);
    DictionaryList(std::string keyword, ByScene, std::string meaning);
    std::vector<Dictionary> operator()(const Dictionary&) const;
};

/// Sub-dictionaries or words whose names are the case's own: "<wall>". There is nothing to read; the reader walks `keys()`.
class FreeName : public Parameter
{
public:
    /// `type`: "dictionary", "word", "number" ...
    FreeName(std::string name, std::string type, std::string meaning);
};

}
