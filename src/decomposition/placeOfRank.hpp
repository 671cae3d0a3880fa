/// Folder of a rank in a parallel run.
#pragma once
#include "case/Case.hpp"
#include "case/RunTime.hpp"
#include "parallel/Ranks.hpp"

namespace sph
{

/// Folder in which a process of a parallel run reads and writes: processorN of a decomposed case, of which those times count that all ranks have
/// (the others are a warning of the case); else in the case itself. All ranks ask; `all` null: the one process of a run on one rank. Throws
/// CaseError where there are not as many folders as ranks, or not those of one decomposition.
RunTime::Place placeOfRank(const Case&, const Ranks* all);

}
