/// Regions of space by name, and their unions, intersections and differences.
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Geometry.hpp"
#include <functional>
#include <vector>

namespace sph
{

struct Region
{
    std::function<bool(const Vector<3>&)> contains;
    std::vector<Box> within; ///< boxes outside of which there is nothing of it

    bool operator()(const Vector<3>& x) const { return contains(x); }
};

/// Reads `region <type>;` and what belongs to it from an entry of `fill`.
Region readRegion(const Dictionary&, const Geometry&);

EntryList regionEntries();

}
