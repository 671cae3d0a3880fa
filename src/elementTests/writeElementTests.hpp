/// Output of elementTest in postProcessing/elementTest: a table of each test, and a gnuplot script that draws all.
#pragma once
#include "elementTests/ElementTest.hpp"
#include <filesystem>

namespace sph
{

/// Columns with units; tension and extension positive, but p = -tr(stress)/3. q = sqrt(3 J2), K = stress.xx/stress.zz.
void writeElementTable(const std::filesystem::path&, const std::vector<ElementRow>&);

/// Draws <name>.png beside each table, in the folder that it is started in.
std::string elementPlots(const std::vector<ElementTest>&);

}
