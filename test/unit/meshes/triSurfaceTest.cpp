#include "geometry/triSurface.hpp"
#include "declaredEntries.hpp"
#include "temporaryCase.hpp"
#include <gtest/gtest.h>

namespace sph::test::triSurfaceTest
{

// What is declared of a mesh is what is read of it.
TEST(TriSurface, readsWhatItDeclares)
{
    EXPECT_EQ(difference("wall", triSurfaceEntries(),
                         [](const std::string& text) { readTriSurface(Dictionary::parse(text, "wall", std::make_shared<Diagnostics>())); }),
              "");
}

// Mistakes with their lines, all of them.
TEST(TriSurface, saysWhatIsWrong)
{
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto walls =
        Dictionary::parse("rock\n{\nfluid around;\nscale -1;\nrotation { axis (0 0 0); }\nwrap { tolerance 0; }\nregions { lid 3; }\n}\n",
                          "constant/geometry", diagnostics);
    readTriSurface(walls.subDict("rock"));
    const auto text = messages(*diagnostics);
    for (const auto* part :
         {"\"file\"", "constant/geometry:3: ", "inside, outside", "constant/geometry:4: \"scale\" must be positive, found -1",
          "constant/geometry:5: ", "\"angle\"", "constant/geometry:6: \"tolerance\" must be positive, found 0",
          "constant/geometry:7: region \"lid\" must be a dictionary: lid { contactAngle 30; }"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

}
