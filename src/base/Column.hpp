/// A column of a table that the suite writes: declared once, by which its file, `sphDictionary -list` and the reference say what it holds.
#pragma once
#include <string>
#include <vector>

namespace sph
{

struct Column
{
    std::string name;    ///< "superficial_<phase>": one for each phase
    std::string unit;    ///< "m/s"; "-" of a pure number, "" of words
    std::string meaning; ///< "liquid over the volume of the pores"

    /// The column of one phase, wall or field: `superficial_water`; of none, where there is only one, `superficial`.
    Column of(const std::string& each) const
    {
        auto column = *this;
        auto from = name.find('<'), to = name.find('>') + 1;
        if (each.empty() && from > 0 && name[from - 1] == '_') --from;
        else if (each.empty() && to < name.size() && name[to] == '.') ++to;
        column.name.replace(from, to - from, each);
        return column;
    }
    /// "saturation [-]: liquid over the volume of the pores"
    std::string text() const { return name + (unit.empty() ? "" : " [" + unit + "]") + ": " + meaning; }
};

/// A file that a function object or a program writes below postProcessing, and its columns.
struct TableInfo
{
    std::string writer;  ///< "errors"
    std::string file;    ///< "errors.dat"
    std::string meaning; ///< "errors against exact solutions and tables"
    std::vector<Column> columns;
};

}
