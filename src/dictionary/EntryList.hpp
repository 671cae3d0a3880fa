/// The entries that a file or a sub-dictionary may have, for the reference that `sphDictionary -list` prints.
///
///     EntryList entries() { return {nPoints, bins, {region, {min, max}}, {type, {{"line", {start, end}}, {"plane", planeEntries()}}}}; }
#pragma once
#include "base/Column.hpp"
#include "dictionary/Parameter.hpp"

namespace sph
{

struct EntryList;
/// The words of a choice, and what comes beside it with each.
using Cases = std::vector<std::pair<ChoiceWord, EntryList>>;

struct ListedEntry
{
    ParameterInfo info;
    std::vector<ListedEntry> inside;                                     ///< of a sub-dictionary
    std::vector<std::pair<std::string, std::vector<ListedEntry>>> cases; ///< of a choice: what comes beside it with each word

    ListedEntry(const Parameter& p) : info(p.info()) {}
    /// A sub-dictionary (or a list of them, or freely named ones) with what it holds.
    ListedEntry(const Parameter& p, const EntryList& holds);
    /// A choice with the entries that go with its words.
    ListedEntry(const Choice& choice, const Cases&);
};

struct EntryList : std::vector<ListedEntry>
{
    EntryList() = default;
    EntryList(std::initializer_list<ListedEntry> entries) : vector(entries) {}
    EntryList& operator+=(const EntryList& more);
    friend EntryList operator+(EntryList a, const EntryList& b) { return a += b; }
};

Cases operator+(Cases, const Cases&);
/// The words alone, for the choice itself.
ChoiceWords wordsOf(const Cases&);

/// A list by file. Several parts of the suite may add to one file; entries of one keyword are merged. Beside what is read it has the tables that are written.
class EntryRegistry
{
public:
    struct File
    {
        std::string name, meaning;
        EntryList entries;
    };

private:
    std::vector<File> files_;
    std::vector<TableInfo> tables_;

public:
    /// `meaning` of a file is said once, by whoever comes first.
    void add(const std::string& file, const EntryList&, const std::string& meaning = "");
    const std::vector<File>& files() const { return files_; }
    const File* find(const std::string& file) const;
    void add(const TableInfo& table) { tables_.push_back(table); }
    const std::vector<TableInfo>& tables() const { return tables_; }
};

}
