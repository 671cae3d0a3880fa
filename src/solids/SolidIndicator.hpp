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
    /// Of one shape, at least 1: what a question costs.
    std::size_t mostFacets() const;
};

}
