/// Whether a point lies in a solid of a bed.
#pragma once
#include "solids/Bed.hpp"
#include <map>

namespace sph
{

class SolidIndicator
{
    const SolidContainer& container_;
    const Bed& bed_;
    double cell_;
    std::map<std::array<int, 3>, std::vector<int>> near_; ///< bodies by the cells that they reach into

public:
    /// Keeps references to both.
    SolidIndicator(const SolidContainer&, const Bed&);
    bool operator()(const Vector<3>& x) const;
    /// Facets of the largest shape, or 1: a question costs as much.
    std::size_t mostFacets() const;
};

}
