#include "geometry/geodesicSphere.hpp"
#include <map>
#include <numbers>

namespace sph
{

TriangleSurface geodesicSphere(int n)
{
    const double g = std::numbers::phi;
    const std::array<Vector<3>, 12> corner{{{-1, g, 0},
                                            {1, g, 0},
                                            {-1, -g, 0},
                                            {1, -g, 0},
                                            {0, -1, g},
                                            {0, 1, g},
                                            {0, -1, -g},
                                            {0, 1, -g},
                                            {g, 0, -1},
                                            {g, 0, 1},
                                            {-g, 0, -1},
                                            {-g, 0, 1}}};
    constexpr int faces[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    TriangleSurface s;
    std::map<std::array<int, 12>, int> number; // a point by its weights at the corners, the same from each face
    for (const auto& f : faces)
    {
        const auto point = [&](int i, int j)
        {
            const int weight[3] = {n - i - j, i, j};
            std::array<int, 12> key{};
            for (int k = 0; k < 3; ++k) key[std::size_t(f[k])] = weight[k];
            const auto [at, isNew] = number.try_emplace(key, int(s.points.size()));
            if (isNew)
            {
                Vector<3> x; // in the order of the corners, so that each face makes the same number
                for (std::size_t c = 0; c < corner.size(); ++c) x += double(key[c]) * corner[c];
                s.points.push_back(x / mag(x));
            }
            return at->second;
        };
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j)
            {
                s.triangles.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
                if (i + j < n - 1) s.triangles.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
            }
    }
    return s;
}

}
