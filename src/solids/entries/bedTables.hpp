/// The tables of a bed that packParticles -solids writes below postProcessing/solids.
#pragma once
#include "base/Column.hpp"

namespace sph
{

/// bed.csv: the bed in one row.
TableInfo bedTable();
/// porosity.csv: the profile along the height.
TableInfo heightTable();
/// radialPorosity.csv: the profile across a cylinder.
TableInfo radialTable();
/// sizes.csv: the grading curve.
TableInfo sizesTable();
/// grains.csv and contacts.csv
TableInfo grainsTable();
TableInfo contactsTable();

}
