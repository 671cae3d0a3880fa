/// Entries of a case's files that a copy of it gets another value of, as changeDictionary of OpenFOAM has them:
///
///     "system/sphSchemes" { resolution { spacing 0.025; } ~shifting; }     // a value; an entry that goes
#pragma once
#include "case/Case.hpp"

namespace sph
{

struct Override
{
    std::string file;                  ///< relative to the case
    std::vector<std::string> keywords; ///< dictionary, sub-dictionary, .. entry
    std::string value;                 ///< without one the entry goes
    Location where;                    ///< in the dictionary that asks for it

    /// "resolution.spacing"
    std::string entry() const;
};

/// Reads which entries a dictionary asks for, of any number of files of the case; every mistake goes to its Diagnostics.
std::vector<Override> readOverrides(const Dictionary&, const std::filesystem::path& baseCase);

/// Gives the entries their values, in order; comments, macros and includes stay, so that entries made of others by macros follow.
/// A dictionary that is missing is added. An entry that cannot be set is recorded at the place that asks for it.
void apply(const std::vector<Override>&, const std::filesystem::path& caseFolder, Diagnostics&);

/// Location of an override in the copy; file without line where it is not there.
Location placeOf(const Override&, const std::filesystem::path& caseFolder);

/// True of what may be the name of a folder and of a curve: letters, digits and _-+., no '.' ahead.
bool isPlainName(const std::string&);

}
