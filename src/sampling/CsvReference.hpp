/// A reference field from a table on disk, by linear or cubic interpolation in one coordinate and in time.
#pragma once
#include "dictionary/EntryList.hpp"
#include <filesystem>
#include <optional>

namespace sph
{

/// Dictionary:
///
///     type csv;
///     file "reference/startup.csv";                           // relative to the case; first line: names of the columns; # notes
///     columns { coordinate y; time t; value v; }              // without `time` the reference is steady
///     select { set paper4.1; nu 1e-6; }                       // only rows with these words or numbers
///     units { coordinate 1e-3; time 1; value 1.25e-5; }       // SI value of 1 in each column, default 1
///     axis (0 1 0); origin (0 0 0);                           // coordinate of a point: (x - origin).axis
///     mirror yes;                                             // ... its absolute value, for profiles given from the centre
///     interpolation linear;                                   // or cubic, through the four nearest rows
///
/// Points up to one interval beyond the ends of the table are extrapolated (tables of cell centres end half a cell from the
/// wall); farther away, and outside the table's times, there is no reference.
///
/// A table of a number over time alone has `columns { time t; value v; }` and neither axis nor coordinate.
class CsvReference
{
public:
    enum class Over
    {
        space,
        time
    };

private:
    struct Profile
    {
        std::vector<double> coordinate, value;
    };
    std::vector<Profile> profiles_; ///< ascending in time and coordinate
    std::vector<double> times_;
    Vector<3> axis_, origin_;
    bool mirror_ = false, cubic_ = false, steady_ = true;
    Over over_;

    void read(const Dictionary&, const std::filesystem::path& caseFolder);

public:
    static EntryList entries(Over);
    CsvReference(const Dictionary&, const std::filesystem::path& caseFolder, Over = Over::space);

    /// Over time: the first argument is the time [s], and nothing is extrapolated.

    std::optional<double> at(double coordinate, double t) const;
    std::optional<double> operator()(const Vector<3>& x, double t) const;

    /// Positions of the rows: origin + coordinate axis, each place once.
    std::vector<Vector<3>> rows() const;
};

}
