#include "forcePass.hpp"
#include "plan/Plan.hpp"
#include "solver/models.hpp"
#include <algorithm>

namespace sph
{

Figures forcePass(PairLimit& limit, double skin)
{
    const std::size_t count = limit.x.size();
    const double H = 2 * limit.h;
    const auto planOf = [](bool mixed)
    {
        const std::vector<std::string> terms{"huAdamsPressure", "singlePhaseViscosity", "continuity", "integratedVolume", "tait"};
        return Plan<3>(allTerms<3>(), {{.name = "evaluate", .terms = terms, .bearsSingle = mixed}}, {"positions", "U", "m", "rho"});
    };
    auto plan = planOf(false), mixedPlan = planOf(true);
    FieldStore<3> store;
    plan.allocate(store);
    store.allocateState(Position{});
    store.allocateState(Velocity{});
    store.allocateState(Mass{});
    store.allocateState(Density{});
    store.resize(count + 1);
    const auto copy = [&](const std::vector<double>& from, const char* name, int c)
    { std::copy(from.begin(), from.end(), store.component(name, c)); };
    copy(limit.x, "positions", 0), copy(limit.y, "positions", 1), copy(limit.z, "positions", 2);
    copy(limit.u, "U", 0), copy(limit.v, "U", 1), copy(limit.w, "U", 2);
    copy(limit.rho, "rho", 0);
    std::fill_n(store.component("m", 0), count, 1.0);

    Geometry open;
    const auto largest = [](const std::vector<double>& x) { return *std::max_element(x.begin(), x.end()); };
    open.high = {largest(limit.x), largest(limit.y), largest(limit.z)};
    Images<3> images(open, H + skin, 1);
    images.build(store, count);
    const auto x = store.pointers(Position{});
    NeighbourLists<3> lists;
    Coefficients c;
    c.restDensity = {1};
    c.viscosity = {0.01};
    c.soundSpeed = {10};
    c.stateEquation = {StateEquation::tait(1, 10, 7)};
    c.phases = {"water"};
    c.support = H;
    c.spacing = 1;
    plan.bind(store, c);
    mixedPlan.bind(store, c);
    const Kernel<3> kernel("wendlandC2", H);

    auto singleLimit = inSinglePrecision(limit);
    std::vector<double> room(3 * std::size_t(images.nullParticle())); // a run lends that of its records
    double best = 1e9, bestOfMixed = 1e9, bestOfLimit = 1e9, bestOfSingleLimit = 1e9, bestOfBuild = 1e9;
    for (int turn = 0; turn < 7; ++turn)
    {
        bestOfLimit = std::min(bestOfLimit, secondsOf([&] { limit.evaluate(); }));
        bestOfSingleLimit = std::min(bestOfSingleLimit, secondsOf([&] { singleLimit.evaluate(); }));
        bestOfBuild =
            std::min(bestOfBuild,
                     secondsOf(
                         [&] {
                             lists.build({x[0], x[1], x[2]}, count, images.nullParticle(), H + skin, NeighbourLists<3>::Stored::yes, room);
                         }));
        best = std::min(best, secondsOf([&] { plan.evaluate(store, images, lists, kernel); }));
        bestOfMixed = std::min(bestOfMixed, secondsOf([&] { mixedPlan.evaluate(store, images, lists, kernel); }));
    }
    const double pairs = double(limit.list.size());
    return {{"pairLimit", pairs / bestOfLimit / 1e6, "million pairs/s"},
            {"singlePairLimit", pairs / bestOfSingleLimit / 1e6, "million pairs/s"},
            {"singlePairLimitOfPairLimit", bestOfLimit / bestOfSingleLimit, "1"},
            {"forcePass", pairs / best / 1e6, "million pairs/s"},
            {"forcePassOfPairLimit", bestOfLimit / best, "1"},
            {"mixedForcePassOfPairLimit", bestOfLimit / bestOfMixed, "1"},
            {"mixedForcePassOfSinglePairLimit", bestOfSingleLimit / bestOfMixed, "1"},
            {"mixedForcePassOfForcePass", best / bestOfMixed, "1"},
            {"listBuild", double(count) / bestOfBuild / 1e6, "million particles/s"},
            {"listBuildOfForcePass", bestOfBuild / best, "1"}};
}

}
