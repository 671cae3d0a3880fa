/// The one exception of user mistakes, and the list in which reading a case collects them so that all are reported at once.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace sph
{

/// A place in a file of the case; `file` relative to the case folder, `line` counted from 1 (0: the file as a whole).
struct Location
{
    std::string file;
    int line = 0;
};

/// "system/controlDict:14", or the file alone where there is no line.
std::string toString(const Location&);

/// A mistake of the user, in words for the user: where, what, what was meant, what is possible. Caught once per application.
class CaseError : public std::runtime_error
{
public:
    using runtime_error::runtime_error;
    CaseError(const Location& where, const std::string& what);
};

/// Errors and warnings met while a case is read. Reading goes on after an error, with a harmless value in place of the bad one;
/// `throwIfAny` then reports all of them, sorted by file and line.
class Diagnostics
{
    struct Entry
    {
        Location where;
        std::string what;
    };
    std::vector<Entry> errors_, warnings_;

public:
    void error(Location where, std::string what);
    void warning(Location where, std::string what);
    bool ok() const { return errors_.empty(); }
    std::size_t errors() const { return errors_.size(); }

    /// One line or paragraph each, "file:line: what".
    std::vector<std::string> warnings() const;

    /// Throws CaseError with every error, each on lines of its own, and their count where there are several.
    void throwIfAny() const;
};

}
