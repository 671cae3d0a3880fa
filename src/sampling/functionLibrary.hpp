/// Header for libraries of function objects, which a case names by `libs ("libcentreOfMass.so");`. A source of such a library includes it and adds its types:
///
///     class CentreOfMass : public sph::FunctionObject { .. static sph::EntryList entries(); static sph::TableInfo table(); .. };
///     const sph::AddedFunction added{sph::functionType<CentreOfMass>("centreOfMass", "centre of mass of a phase")};
///
/// The library holds nothing of the suite: it finds the functions that it calls in the program that loads it. doc/ownMeasure.md has a whole one.
#pragma once
#include "sampling/FunctionType.hpp"
#include "sampling/interfaceTag.hpp"
