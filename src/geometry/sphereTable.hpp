/// A table of spheres as other codes write them: LIGGGHTS, YADE, a spreadsheet.
///
///     x,y,z,radius                    # names of the columns, in any order and among others: x y z, and r, radius, d or diameter
///     0.012,0.034,0.005,0.004
///
/// Cells stand between commas or blanks. Lines that begin with `#` are notes. A table without names has the columns x y z r, as YADE's export.textExt writes them; one time
/// of a LIGGGHTS dump, whose names follow `ITEM: ATOMS`, is read as it is.
#pragma once
#include "base/CaseError.hpp"
#include "base/Vector.hpp"
#include <string>
#include <vector>

namespace sph
{

struct TableSphere
{
    Vector<3> centre; ///< in the table's lengths
    double radius;    ///< > 0
    int line;         ///< of the file
};

/// The spheres in the text of a file of this name. Rows that hold none are errors, the first ten of them each with its line.
std::vector<TableSphere> spheresInTable(const std::string& text, const std::string& file, Diagnostics&);

}
