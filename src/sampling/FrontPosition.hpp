/// Measure: the position of a front, against a table.
#pragma once
#include "sampling/CsvReference.hpp"
#include "sampling/Measurement.hpp"

namespace sph
{

/// Position of the front of a fluid along a direction, against a table over time
///
///   Z = max_i (x_i - origin).direction + Delta_x/2
///
/// Delta_x [m] the particle spacing: the fluid of the foremost particle ends half a spacing before it. Dictionary:
///
///     phase water;                            // the first by default
///     direction (1 0 0);  origin (0 0 0);
///     table { file "reference/front.csv";  columns { time T; value Z; }  units { time 0.054; value 0.057; }  select { .. } }
///
/// The table is that of CsvReference, with a time in the place of the coordinate, and interpolated in it; outside its times nothing is
/// compared.
class FrontPosition
{
    std::size_t phase_;
    Vector<3> direction_, origin_;
    CsvReference table_;

public:
    static EntryList entries();
    FrontPosition(const Dictionary&, const std::vector<std::string>& phases, const std::filesystem::path& caseFolder);
    Measurement operator()(const ParticleView&) const;
};

}
