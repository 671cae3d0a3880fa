#include "surfaces/entries/surfaceEntries.hpp"

namespace sph
{

EntryList surfaceEntries()
{
    using namespace entry;
    const EntryList ofPicture{entry::size,
                              {camera, {position, focalPoint, up, zoom}},
                              show,
                              shownWalls,
                              wallOpacity,
                              shownParticles,
                              colourBy,
                              range,
                              {plane, {point, normal}},
                              {cut, {point, normal}},
                              pictureSmoothing,
                              title,
                              showTime,
                              scaleBar,
                              framesPerSecond};
    return {entry::cloud, phases, gridSpacing, entry::support, entry::kernel,       iso,
            normalise,    closed, smoothing,   formats,        {picture, ofPicture}};
}

}
