/// Output of elementTest in postProcessing/elementTest: a table of each test, and a gnuplot script that draws all.
#pragma once
#include "base/Column.hpp"
#include "elementTests/ElementTest.hpp"
#include <filesystem>

namespace sph
{

/// Its columns, whose names have their units.
TableInfo elementTestTable();
void writeElementTable(const std::filesystem::path&, const ElementTest&, const SoilLaw&, const std::vector<ElementRow>&);

/// Draws <name>.png beside each table, in the folder that it is started in.
std::string elementPlots(const std::vector<ElementTest>&, const SoilLaw&);

}
