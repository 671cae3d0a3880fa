/// Work-precision diagrams, drawn by gnuplot.
#pragma once
#include "sweeps/ResultTable.hpp"

namespace sph
{

/// One diagram pair: errors of one field, norm and time.
struct Diagram
{
    std::string stem; ///< of the files: <stem>.gp, <stem>.cpuTime.svg and .png, <stem>.spacing.svg and .png
    std::string title;
    std::vector<ResultRow> rows;
    std::vector<ResultRow> peers;
};

/// A gnuplot script that draws error against processor time and error against spacing, each as SVG and PNG into the folder that it is
/// run in; the data stand in it, so that it can be changed and run again by itself. Rows that have no place on logarithmic axes (not
/// ended well, error 0) are left out; "" where none is left.
std::string gnuplotScript(const Diagram&);

}
