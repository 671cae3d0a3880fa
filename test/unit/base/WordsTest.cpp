#include "base/words.hpp"
#include <gtest/gtest.h>

using namespace sph;

using Words = std::vector<std::string>;

// Edits counted by hand; two swapped neighbours are one slip of the fingers.
TEST(Words, distance)
{
    EXPECT_EQ(distance("harmonc", "harmonic"), 1);
    EXPECT_EQ(distance("kitten", "sitting"), 3);
    EXPECT_EQ(distance("", "abc"), 3);
    EXPECT_EQ(distance("abc", ""), 3);
    EXPECT_EQ(distance("tyep", "type"), 1);
}

// A slip is recognised, in capitals too, and so is the beginning of one word alone; different short words are no slips.
TEST(Words, nearest)
{
    const Words known{"deltaT", "endTime", "cubicSpline", "quinticSpline", "wendlandC2", "wendlandC4", "dx"};
    EXPECT_EQ(nearest("deltat", known), "deltaT");
    EXPECT_EQ(nearest("edTime", known), "endTime");
    EXPECT_EQ(nearest("cubic", known), "cubicSpline");
    EXPECT_EQ(nearest("wend", known), "");
    EXPECT_EQ(nearest("wendlandC", known), "wendlandC2");
    EXPECT_EQ(nearest("dt", known), "");
    EXPECT_EQ(nearest("DX", known), "dx");
    EXPECT_EQ(nearest("viscosity", known), "");
}

// The sentence that follows "... is unknown.".
TEST(Words, suggestion)
{
    const Words known{"harmonic", "morris"};
    EXPECT_EQ(suggestion("harmonc", "models", known), "Did you mean \"harmonic\"? Known models: harmonic, morris.");
    EXPECT_EQ(suggestion("xyz", "models", known), "Known models: harmonic, morris.");
    EXPECT_EQ(suggestion("xyz", "models", {}), "There are no models.");
}
