/// The entries of system/reconstructSurfaceDict. They stand in a library of their own, so that what prints them needs no VTK.
#pragma once
#include "dictionary/EntryList.hpp"
#include "kernels/Kernel.hpp"

namespace sph
{

namespace entry
{
const Word cloud{"cloud", "sph", "cloud of particles below <time>/lagrangian"};
const Choices phases{"phases", "phases", {}, byScene("the first of constant/phaseProperties"), "phases whose surface is made"},
    formats{"formats", "formats", {"vtp", "stl", "obj"}, std::vector<std::string>{"vtp"}, "files that are written"},
    show{"show",
         "things to show",
         {"surface", "walls", "particles"},
         byScene("(surface walls) in 3-D with several phases, (surface walls particles) in 2-D, (walls particles) of one phase"),
         "what the picture shows"},
    shownWalls{"walls",
               "walls",
               {},
               byScene("all"),
               "of those of constant/geometry the ones that the picture shows: not a box that hides what it holds"};
const Scalar gridSpacing{"gridSpacing", units::m, byScene("half the particles' spacing"), positive,
                         "of the grid that the colour function is sampled on"},
    support{"support", units::m, byScene("3 spacings of the particles"), positive, "radius of the kernel's support"};
const AutomaticScalar iso{"iso", units::none, byScene("0.5"), positiveBelow(1).saying("must lie between 0 and 1"),
                          "value of the colour function on the surface; automatic: the one whose surface encloses the particles' volume"};
const Choice kernel{"kernel", kernelNames(), "wendlandC2", "of the colour function"},
    normalise{"normalise",
              {"none",
               {"walls", "by the part of the kernel that lies in the fluid"},
               {"particles", "by the sum over the particles of all phases"}},
              byScene("particles where there are several phases, else walls"),
              "how the kernel sum is normalised"},
    shownParticles{"particles",
                   {{"onPlane", "those on `plane`"}, {"all", "as balls"}},
                   "onPlane",
                   "in 3-D, which particles the picture shows, where it shows them"};
const Switch closed{"closed", false, "cap the surface along walls and domain faces"},
    scaleBar{"scaleBar", false, "draw a length to measure by: in 3-D that of what is as far away as the camera's focal point"};
const Count smoothing{"smoothing", 0, nonNegative.saying("must not be negative"), "passes of the windowed-sinc filter"},
    pictureSmoothing{"smoothing", 20, nonNegative.saying("must not be negative"), "the same of the surface in the picture"};

const SubDictionary picture{"picture", byScene("all defaults"), "the picture of a time"},
    camera{"camera", byScene("sees the whole domain"), "the camera"},
    plane{"plane", byScene("through the middle"), "in 3-D particles are shown on this cut"},
    cut{"cut", byScene("nothing is cut"), "in 3-D, what lies before this plane, on the side that its normal points to, is left out"};
const ListOf<int> size{"size", std::vector<int>{1200, 900}, "width and height in pixels, each from 16 to 8000"};
const VectorParameter position{"position", units::m, byScene("so that the whole domain is seen"), "where the camera is"},
    focalPoint{"focalPoint", units::m, byScene("the middle of the domain"), "what it looks at"},
    up{"up", units::none, byScene("against gravity"), "what is up in the picture"},
    point{"point", units::m, byScene("the middle of the domain"), "a point of the cut"};
const Scalar zoom{"zoom", units::none, 1, positive, "enlargement"},
    wallOpacity{"wallOpacity", units::none, 1, positiveUpTo(1), "of walls: below 1 what is behind them shines through"},
    framesPerSecond{"framesPerSecond", units::none / units::s, 10, positive, "pictures a second, of a sequence by -movie"};
const Word colourBy{"colourBy", byScene("phase of the particles where there are several, else U; the surface's own colour"),
                    "what colours the particles or, where they are not shown, the surface: a field, or phase of particles"};
const ListOf<double> range{"range", byScene("each picture's own"), "least and largest value of the colours"};
const Direction normal{"normal", byScene("(0 0 1); where z is up in the picture (0 -1 0)"), "of the cut, towards the camera"};
const Text title{"title", "", "above the picture"};
const Switch showTime{"showTime", true, "write the time into the picture"};
}

EntryList surfaceEntries();

}
