/// Steps of a case from its dictionaries, packed in memory: all passes, images, lists and integration, timed in turns with the yardstick.
#pragma once
#include "measure.hpp"
#include <filesystem>

namespace sph
{

/// Figures are named after `name`. Work is counted as neighbours within the support (skin and the particle itself left out) times pair
/// passes times particle-steps. `mixed`: terms of pairs in single precision.
Figures wholeStep(const std::filesystem::path& caseFolder, const std::string& name, PairLimit& limit, int stepsATurn, int turns,
                  bool mixed = false);

/// Steps of a case on one thread and on two, in turns: the wall time of a pair pass on one, over that on two. Each is the best of its turns.
Figures twoThreads(const std::filesystem::path& caseFolder, const std::string& name, int stepsATurn, int turns);

}
