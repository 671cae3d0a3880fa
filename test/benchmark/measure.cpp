#include "measure.hpp"
#include "geometry/Geometry.hpp"
#include "images/Images.hpp"
#include "neighbours/NeighbourLists.hpp"
#include <chrono>
#include <random>

namespace sph
{

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

PairLimit jitteredBlock(int n)
{
    const double H = 2.6;
    const std::size_t count = std::size_t(n) * n * n;
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> u(-0.5, 0.5);
    FieldStore<3> store;
    store.allocateState(Position{});
    store.allocateState(Velocity{});
    store.allocateState(Density{});
    store.allocateState(Pressure{});
    store.resize(count + 1);
    auto x = store.pointers(Position{});
    const auto v = store.pointers(Velocity{});
    std::size_t k = 0;
    for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b)
            for (int c = 0; c < n; ++c, ++k)
            {
                const double at[3] = {double(a), double(b), double(c)};
                for (int d = 0; d < 3; ++d) x[d][k] = at[d] + 0.5 + 0.2 * u(generator), v[d][k] = u(generator);
                store.component("rho", 0)[k] = 1 + 0.01 * u(generator);
                store.component("p", 0)[k] = u(generator);
            }
    CellList<3> cells;
    cells.build({x[0], x[1], x[2]}, count, 0.5 * H);
    store.sortState(cells.order());
    for (int d = 0; d < 3; ++d) x[d][count] = -1e3;
    NeighbourLists<3> lists;
    lists.build({x[0], x[1], x[2]}, count, count, H);

    PairLimit limit;
    limit.h = 0.5 * H;
    const auto copy = [&](const char* name, int c)
    {
        const double* a = store.component(name, c);
        return std::vector<double>(a, a + count);
    };
    limit.x = copy("positions", 0), limit.y = copy("positions", 1), limit.z = copy("positions", 2);
    limit.u = copy("U", 0), limit.v = copy("U", 1), limit.w = copy("U", 2);
    limit.rho = copy("rho", 0), limit.p = copy("p", 0);
    limit.list.reserve(lists.pairs());
    NeighbourLists<3>::Room room;
    for (std::size_t i = 0; i < count; ++i)
    {
        for (int j : lists.of(i, room))
            if (j != int(i) && j < int(count)) limit.list.push_back(j);
        limit.begin.push_back(int(limit.list.size()));
    }
    return limit;
}

}
