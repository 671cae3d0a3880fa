#include "geometry/crevice.hpp"

namespace sph
{

Crevice creviceAt(const Geometry& g, std::span<const int> near, const Vector<3>& x, double narrowest)
{
    struct Side
    {
        double distance;
        Vector<3> normal;
    };
    constexpr double facing = -0.5;
    constexpr std::size_t most = 16; // edges of small facets have feet by the dozen, all of them alike
    std::array<Side, most> sides;
    std::size_t n = 0;
    Crevice found{narrowest, {}};
    forEachFoot(g, near, x, narrowest,
                [&](const Foot& foot, int)
                {
                    for (std::size_t k = 0; k < n; ++k)
                        if (const double width = sides[k].distance + foot.distance;
                            width < found.width && dot(sides[k].normal, foot.normal) < facing)
                            found = {width, sides[k].normal + foot.normal};
                    if (n < most) sides[n++] = {foot.distance, foot.normal};
                });
    return found.width < narrowest ? found : Crevice{};
}

}
