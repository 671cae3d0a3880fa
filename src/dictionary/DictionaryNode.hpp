/// The node behind a Dictionary: the parsed entries, their place in the files, and what was looked up.
#pragma once
#include "dictionary/KeywordPattern.hpp"
#include "dictionary/Token.hpp"
#include <set>
#include <unordered_map>
#include <vector>

namespace sph
{

/// Treatment of an entry whose keyword is there already, as OpenFOAM's #inputMode.
enum class InputMode
{
    merge,     ///< sub-dictionaries merge, other values are replaced
    overwrite, ///< replaced
    protect,   ///< the first stays
    warn,      ///< the first stays, with a warning
    error      ///< an error
};

struct DictionaryEntry
{
    std::string keyword;
    Location where;
    /// Macros expanded. Empty for a sub-dictionary.
    std::vector<Token> value;
    std::shared_ptr<Dictionary::Node> dictionary = nullptr;
    /// Set where the keyword was written in quotes: it then stands for all keywords that it matches.
    std::shared_ptr<const KeywordPattern> pattern = nullptr;
    /// Counts the entries of its dictionary as they were given: among patterns the latest wins, though a repeated one keeps its place.
    std::size_t given = 0;
    /// Places at which macros have taken the value: what they made of it stays, whatever becomes of the entry.
    std::vector<Location> taken = {};

    /// The text of the value (or of `{ .. }`) in the file `where.file`.
    std::size_t begin = 0, end = 0;
    /// Came by `$base;`: the text belongs to another entry.
    bool copied = false;
    /// Came from a file that the dictionary includes, and which may serve other dictionaries as well.
    bool included = false;
    bool used = false, ignored = false;
    /// Came from a set of defaults, and not from the file (addDefaults).
    bool isDefault = false;
};

/// Name of the dictionary and keyword of every look-up, where a test has set it that compares what is read with what is declared.
inline std::vector<std::pair<std::string, std::string>>* lookUpLog = nullptr;

struct Dictionary::Node
{
    std::string name, keyword;
    Location where;
    std::shared_ptr<Diagnostics> diagnostics;
    /// Paths may name it.
    std::shared_ptr<const std::filesystem::path> caseFolder;
    /// Valid while parsing alone: macros search the enclosing dictionaries.
    Node* parent = nullptr;
    /// Added by `add` alone; `removeIf` removes.
    std::vector<DictionaryEntry> entries;
    /// Place of the closing brace, or the end of the file, in the text.
    std::size_t end = 0;

    /// Stands for a dictionary that is missing, which was reported: what is missing in it is not reported again.
    bool missing = false;
    /// Some look-up reached it, so that its entries are the program's business.
    bool visited = false;
    std::vector<std::string> lookedUp;

    std::shared_ptr<Node> child(const std::string& key, const Location&);

    DictionaryEntry* findExact(const std::string& key);
    /// The entry of that keyword, or the last pattern that matches it.
    DictionaryEntry* find(const std::string& key);
    /// The entry that a macro names: `a` and `a.b` here or in an enclosing dictionary, `:a.b` or `/a/b` from the top, `..a` one up,
    /// `...a` two up.
    DictionaryEntry* findScoped(const std::string& name);

    void add(DictionaryEntry, InputMode);
    /// Adds copies of the entries of another dictionary; they remember where they were written.
    void mergeCopies(const Node&);
    /// The words that it holds, and how deep dictionaries nest in it, itself included; counted up to the limits alone.
    struct Extent
    {
        std::size_t words = 0;
        int levels = 0;
    };
    Extent extent() const;
    void lookUp(const std::string& key);

    template<class Condition> void removeIf(const Condition& condition)
    {
        std::erase_if(entries, condition);
        places_.clear();
        placed_ = 0;
    }

private:
    /// Places of keywords in `entries`, the first so many of them: a file of 10^5 entries would take half a minute without.
    std::unordered_map<std::string, std::size_t> places_;
    std::size_t placed_ = 0, given_ = 0;

    /// Names that were sought in vain below nodes, by their length: patterns could make the ways to read a name with dots countless.
    using Vain = std::set<std::pair<const Node*, std::size_t>>;
    DictionaryEntry* descend(const std::string& name, Vain&);
    DictionaryEntry* descend(const std::string& name);
};

/// Extent of a value: the dictionaries in it counted with all they hold.
Dictionary::Node::Extent extentOf(const std::vector<Token>&);

}
