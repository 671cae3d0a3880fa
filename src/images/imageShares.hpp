/// Shares of an image in what lies behind several bodies, so that each place is filled once. The weight of an image is the product, over its reflections, of
///
///   volume factor                 of the curved wall, eq. (18) of Barker et al. (2012): volumeFactor
///   share of the face             beside the other faces of its body: faceShare
///   share among bodies            beside the images that end with the other bodies of the chain: shareAmong
///   share of the wedge            fades where two bodies that mirror in turn leave a gap: shareOfWedge
///
/// Verified by test/unit/images/meshImagesTest.cpp: the sum of W over fluid and images is 1.
#pragma once
#include "images/ReflectingWalls.hpp"

namespace sph
{

/// Share of what is mirrored again in a wall of normal n after one of normal m: all of it in a wedge, nothing in a gap. `slack`: what their product may grow by.
double shareOfWedge(const Vector<3>& n, const Vector<3>& m, double slack = 0);

/// Share of what was mirrored in a face of normal n, and lies h behind it, beside the images that end with another face, of normal m, and lies k behind [m],
/// in a solid behind both: half of it each on the bisecting plane. `slack`: what the image may have moved by [m].
double shareBeside(const Vector<3>& n, double h, const Vector<3>& m, double k, double spacing, double slack = 0);

/// Share of an image y, last mirrored in `faces[last]`, beside those that end with the other bodies of its chain; of one that has moved by `slack` [m] at most.
/// What is in one solid alone is its own.
double shareAmong(const ReflectingWalls&, const Mirror* mirrors, const Face* faces, int last, const Vector<3>& y, double slack = 0);

/// The greatest factor that the last reflection of a chain, with this foot, may give to the weight until lists are built anew; `speed` is that of what it mirrors,
/// over that of the source.
double weightSoon(const ReflectingWalls&, const Chain&, Foot, double speed, int dim);

}
