/// A plan on a rank of two: what it sends before a pass is what the pass reads of neighbours and has not sent before, and its sums are those of one process.
#include "neighbours/Halo.hpp"
#include "Toy.hpp"
#include <algorithm>
#include <limits>
#include <utility>

namespace sph::test
{
namespace
{

/// The second half of a torus 2 long, which repeats the first: what comes from there is what goes there, its positions 1 farther on.
class Twin final : public Ranks
{
    struct Through final : Exchange
    {
        void progress() override {}
    };

public:
    bool sendsPositions = true;

    Twin() { count_ = 2; }
    void gatherAll(std::span<const std::byte> part, std::span<std::byte> all) const override
    {
        for (std::size_t begin = 0; begin < all.size(); begin += part.size()) std::ranges::copy(part, all.begin() + long(begin));
    }
    std::vector<std::size_t> exchangeCounts(std::span<const std::size_t> toEach) const override { return {toEach.begin(), toEach.end()}; }
    std::unique_ptr<Exchange> start(std::span<const Message> send, std::span<const Message> receive) const override
    {
        EXPECT_EQ(send.size(), receive.size());
        for (std::size_t k = 0; k < send.size(); ++k)
        {
            std::ranges::copy(send[k].bytes, receive[k].bytes.begin());
            auto* const x = reinterpret_cast<double*>(receive[k].bytes.data());
            for (std::size_t i = 0; sendsPositions && i < receive[k].bytes.size() / sizeof(double) / 2; ++i) x[i] += 1;
        }
        return std::make_unique<Through>();
    }
    std::vector<RankBox> cut(int, std::span<const double>, std::span<const float>) const override
    {
        const double infinity = std::numeric_limits<double>::infinity();
        return {{{-infinity, -infinity, -infinity}, {1, infinity, infinity}}, {{1, -infinity, -infinity}, {infinity, infinity, infinity}}};
    }
    std::unique_ptr<SharedFile> create(const std::filesystem::path&) const override { return nullptr; }
    void barrier() const override {}
    void abort() const override {}
};

// Sums of 21 numbers in another order: 1e-12 of them.
TEST(HaloOfAPlan, SendsWhatIsReadAtNeighboursAndSumsAsOneProcess)
{
    const auto terms = catalogue<2, Twice, Sum, Total, OtherSum>();
    const std::vector<Group> groups{{"first", {"sum"}}, {"second", {"total", "otherSum"}, {"a"}}};
    Toy whole(domain(2, {1, 1, 0}, {true, true, false}), terms, groups, Fields<A, Z>{});
    whole.evaluate("first");
    whole.evaluate("second");

    Geometry geometry = domain(2, {2, 1, 0}, {true, true, false});
    repeatPeriodically(geometry, 0.3);
    Twin twin;
    Halo<2> halo(twin, 0.28);
    FieldStore<2> store;
    Images<2> images(geometry, 0.28, 0.1, 0, &halo);
    Plan<2> plan(terms, groups, {"a", "z"}, {});
    plan.allocate(store);
    store.allocateState(A{});
    store.allocateState(Z{});
    NeighbourLists<2> lists;
    lists.partInterior();
    const auto prepare = [&](const std::vector<Vector<2>>& points)
    {
        twin.sendsPositions = true;
        setPositions(store, points);
        for (const char* name : {"a", "z"}) std::fill_n(store.component(name, 0), points.size(), 1.0);
        halo.balance(store, points.size(), 1.1, [] { return std::vector<float>{}; });
        images.build(store, points.size());
        lists.build(positions(store), points.size(), images.nullParticle(), 0.28);
        plan.bind(store, {});
        twin.sendsPositions = false;
    };
    const Kernel<2> kernel("wendlandC2", 0.25);
    // More particles before: where one of them was lies the null particle afterwards, behind which no neighbour may be seen.
    std::vector<Vector<2>> more, points;
    for (double x = 0.025; x < 1; x += 0.05)
        for (double y = 0.025; y < 1; y += 0.05) more.push_back({x, y});
    std::ranges::sort(more, {}, [](const Vector<2>& x) { return -mag(x - Vector<2>{0.5, 0.5}); });
    prepare(more);
    plan.evaluate(store, images, lists, kernel, plan.group("first"));
    for (std::size_t i = 0; i < whole.n; ++i) points.push_back(positionOf(whole.store, i));
    prepare(points);
    ASSERT_LT(images.nullParticle(), more.size());
    for (const char* name : {"a", "z"}) std::copy_n(whole.of(name), whole.n, store.component(name, 0));
    // Within 0.28 of another half lie the particles up to 0.15 off its sides, and off the sides of the rows, whose images are this rank's own.
    EXPECT_EQ(lists.interior().size() + lists.border().size(), whole.n);
    EXPECT_EQ(lists.interior().size(), 36u);

    const std::size_t copies = halo.count() * sizeof(double);
    auto sent = [&, before = halo.bytesSent()]() mutable { return halo.bytesSent() - std::exchange(before, halo.bytesSent()); };
    const auto expectEqual = [&](const char* name)
    {
        for (std::size_t i = 0; i < whole.n; ++i)
            ASSERT_NEAR(store.component(name, 0)[i], whole.of(name)[i], 1e-12 * std::fabs(whole.of(name)[i])) << name << ' ' << i;
    };
    plan.evaluate(store, images, lists, kernel, plan.group("first"));
    EXPECT_EQ(sent(), 1 * copies); // b alone
    expectEqual("c");
    plan.evaluate(store, images, lists, kernel, plan.group("second"));
    EXPECT_EQ(sent(), 2 * copies); // z, and b anew, which follows from a
    for (const char* name : {"c", "d", "e"}) expectEqual(name);
}

}
}
