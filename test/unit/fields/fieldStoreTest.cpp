/// The store holds what was asked for and nothing else, keeps values through growth, and sorts the state alone.
#include "fields/FieldStore.hpp"
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <stdexcept>

namespace sph
{
namespace
{

// A field that nobody asked for is not there: asking for it is a broken invariant, not a silent allocation.
TEST(FieldStore, HoldsWhatWasAllocatedAlone)
{
    FieldStore<3> store;
    store.allocate(Density{});
    EXPECT_TRUE(store.has(Density{}));
    EXPECT_FALSE(store.has(Velocity{}));
    EXPECT_THROW(store.component("U", 0), std::logic_error);
    EXPECT_EQ(store.bytesPerParticle(), 8u);
}

// A vector has as many arrays as dimensions, a symmetric tensor 3 or 6: a 2-D scene carries no z.
TEST(FieldStore, CarriesNoThirdComponentIn2D)
{
    FieldStore<2> plane;
    plane.allocate(Velocity{});
    plane.allocate(Stress{});
    EXPECT_EQ(plane.bytesPerParticle(), 8u * (2 + 3));
    FieldStore<3> space;
    space.allocate(Velocity{});
    space.allocate(Stress{});
    EXPECT_EQ(space.bytesPerParticle(), 8u * (3 + 6));
}

// What a field is on disk follows from the type of its values, and not from how many arrays it has: 3 are a vector in space and a
// symmetric tensor in the plane.
TEST(FieldStore, KnowsWhatItsValuesAre)
{
    FieldStore<2> plane;
    plane.allocate(Velocity{});
    plane.allocate(Stress{});
    plane.allocate(Phase{});
    plane.allocate(Density{});
    EXPECT_EQ(plane.fields().at("U").type, valueType<Vector<2>>);
    EXPECT_EQ(plane.fields().at("S").type, valueType<SymmTensor<2>>);
    EXPECT_EQ(plane.fields().at("phase").type.fieldClass, FieldClass::label);
    EXPECT_EQ(plane.fields().at("rho").type.fieldClass, FieldClass::scalar);
    FieldStore<3> space;
    space.allocate(Velocity{});
    EXPECT_EQ(space.fields().at("U").type, valueType<Vector<3>>);
    EXPECT_EQ(space.fields().at("U").component.size(), plane.fields().at("S").component.size());
}

// Asking twice changes nothing, also when the first to ask wanted a state; growth keeps values and fills with 0.
TEST(FieldStore, KeepsValuesThroughGrowth)
{
    FieldStore<2> store;
    store.allocateState(Density{});
    store.resize(3);
    for (int i = 0; i < 3; ++i) store.component("rho", 0)[i] = i + 1;
    store.allocate(Density{});
    store.resize(50);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(store.component("rho", 0)[i], i < 3 ? i + 1 : 0);
    EXPECT_TRUE(store.fields().at("rho").state);
}

// What is added after some were given up is 0, and not what was there.
TEST(FieldStore, ForgetsWhatWasGivenUp)
{
    FieldStore<2> store;
    store.allocate(Density{});
    store.resize(3000);
    std::fill_n(store.component("rho", 0), 3000, 7);
    store.resize(1000);
    store.resize(2500);
    for (int i = 0; i < 2500; ++i) ASSERT_EQ(store.component("rho", 0)[i], i < 1000 ? 7 : 0) << i;
}

// Images have room in the named fields alone, also after a later resize.
TEST(FieldStore, GivesImagesRoomWhereTheyAreRead)
{
    FieldStore<2> store;
    store.allocate(Density{});
    store.allocate(Pressure{});
    store.resize(100, 40);
    store.keepImagesOf({"p"});
    const auto length = [&](const char* name) { return store.fields().at(name).component[0].size(); };
    EXPECT_EQ(length("rho"), 40u);
    EXPECT_EQ(length("p"), 100u);
    store.resize(200, 50);
    EXPECT_EQ(length("rho"), 50u);
    EXPECT_EQ(length("p"), 200u);
    EXPECT_EQ(store.owned(), 50u);
    EXPECT_EQ(store.size(), 200u);
}

// order[k] says who comes to place k; derived fields stay where they are, since the next evaluation writes them anew.
TEST(FieldStore, SortsTheStateAlone)
{
    FieldStore<2> store;
    store.allocateState(Velocity{});
    store.allocate(Pressure{});
    store.resize(4);
    for (int i = 0; i < 4; ++i)
    {
        store.component("U", 0)[i] = i;
        store.component("U", 1)[i] = 10 + i;
        store.component("p", 0)[i] = i;
    }
    store.sortState({2, 0, 1});
    const double x[] = {2, 0, 1, 3}, y[] = {12, 10, 11, 13};
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(store.component("U", 0)[i], x[i]);
        EXPECT_EQ(store.component("U", 1)[i], y[i]);
        EXPECT_EQ(store.component("p", 0)[i], i);
    }
}

// Arrays begin at cache lines: whole-vector loads of the first particles do not straddle two.
TEST(FieldStore, AlignsArraysToCacheLines)
{
    FieldStore<3> store;
    store.allocate(Velocity{});
    store.resize(17);
    for (const double* p : store.pointers(Velocity{})) EXPECT_EQ(reinterpret_cast<std::uintptr_t>(p) % 64, 0u);
}

}
}
