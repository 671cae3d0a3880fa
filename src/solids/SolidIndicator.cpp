#include "solids/SolidIndicator.hpp"
#include "solids/meshDistance.hpp"
#include <algorithm>

namespace sph
{

SolidIndicator::SolidIndicator(const SolidContainer& c, const Bed& bed) : container_(c), bed_(bed), cell_(bed.meanSize)
{
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        const double reach = bed.reachOf(b);
        for (int kx = c.periodic[0] ? -1 : 0; kx <= (c.periodic[0] ? 1 : 0); ++kx)
            for (int ky = c.periodic[1] ? -1 : 0; ky <= (c.periodic[1] ? 1 : 0); ++ky)
                for (int kz = c.periodic[2] ? -1 : 0; kz <= (c.periodic[2] ? 1 : 0); ++kz)
                {
                    const auto x = b.centre + Vector<3>{kx * c.length, ky * c.width, kz * c.height};
                    const auto from = [&](double a) { return int(std::floor((a - reach) / cell_)); };
                    const auto to = [&](double a) { return int(std::floor((a + reach) / cell_)); };
                    for (int p = from(x.x); p <= to(x.x); ++p)
                        for (int q = from(x.y); q <= to(x.y); ++q)
                            for (int r = from(x.z); r <= to(x.z); ++r) near_[{p, q, r}].push_back(int(i));
                }
    }
}

bool SolidIndicator::operator()(const Vector<3>& x) const
{
    const auto at = near_.find({int(std::floor(x.x / cell_)), int(std::floor(x.y / cell_)), int(std::floor(x.z / cell_))});
    if (at == near_.end()) return false;
    return std::ranges::any_of(at->second,
                               [&](int i)
                               {
                                   const auto& b = bed_.bodies[std::size_t(i)];
                                   const auto d = shortest(container_, x - b.centre);
                                   if (mag(d) > bed_.reachOf(b)) return false;
                                   const Rotation back{b.rotation.w, -b.rotation.v};
                                   return bed_.shapeOf(b).isSphere() || isInside(bed_.shapeOf(b).mesh, back(d) / b.size);
                               });
}

std::size_t SolidIndicator::mostFacets() const
{
    std::size_t facets = 1;
    for (const auto& b : bed_.bodies) facets = std::max(facets, bed_.shapeOf(b).mesh.triangles.size());
    return facets;
}

}
