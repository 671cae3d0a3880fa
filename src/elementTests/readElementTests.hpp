/// Element tests, as system/elementTestDict states them:
///
///     tests
///     {
///         oedometer { type oedometer; pressure 1e5; strain (0.02); points 20; }
///         ...
///     }
///     plots yes;
#pragma once
#include "case/Case.hpp"
#include "dictionary/EntryList.hpp"
#include "elementTests/ElementTest.hpp"

namespace sph
{

inline const std::string elementTestDictionary = "system/elementTestDict";

struct ElementTestPlan
{
    std::vector<ElementTest> tests;
    bool plots = true;
};

/// Mistakes go to the case's Diagnostics. Tests are checked against the law: a start that it does not admit is an error.
ElementTestPlan readElementTests(const Case&, const SoilLaw&);
/// The entries of the whole dictionary, its section `calibration` included.
EntryList elementTestEntries();

}
