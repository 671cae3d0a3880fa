/// Entries that several function objects, formulas and measures have.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph::entry
{

const Word field{"field", required, "field to compare"};
const ListOf<std::string> fields{"fields", required, "fields to sample"};
const Word phase{"phase", byScene("the first of constant/phaseProperties"), "phase that is measured"};
const VectorParameter origin{"origin", units::m, Vector<3>{}, "point that coordinates count from"};
const Direction direction{"direction", Vector<3>{1, 0, 0}, "along the flow"};
}
