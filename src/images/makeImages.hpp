/// Images of particles, when neighbour lists are built: each particle is mirrored in the walls within reach, its images in further walls as the decision table
/// says (chainTable.hpp), and all of them are shifted by the periods.
///
/// To search the facets of meshes takes as long as some passes over pairs, and while lists are built anew for the fastest particles most have hardly moved. Where images are recalled (Recall),
/// those that were made for a particle at x_m stand for it at x, by the same reflections and shifts, as long as
///
///   |x - x_m| <= way
///
/// and all images are made within a reach, and for a skin, that are 2 way more.
#pragma once
#include "base/values.hpp"
#include "images/ReflectingWalls.hpp"

namespace sph
{

template<int dim> struct ImageEntry
{
    int source;
    std::array<signed char, dim> shift;
    unsigned char reflections = 0;
    bool ghost() const { return reflections > 0; }
};
static_assert(sizeof(ImageEntry<3>) <= 8);

/// How far an image is shifted [m].
template<int dim> Vector<dim> shiftOf(const ImageEntry<dim>& e, const Geometry& geometry)
{
    Vector<dim> by;
    fetch(by, [&](int c) { return e.shift[std::size_t(c)] * geometry.length(c); });
    return by;
}

/// Images of some particles, in the order of their sources.
template<int dim> struct MadeImages
{
    struct Particle
    {
        Vector<dim> at;         ///< x_m
        double fastest;         ///< largest speed of an image over that of its source
        unsigned entry, mirror; ///< the first of its images, and of their mirrors
    };
    std::vector<ImageEntry<dim>> entries;
    std::vector<Vector<dim>> places; ///< positions; of images that are recalled only where they are asked for
    std::vector<Mirror> mirrors;     ///< mirrors of all ghosts, as many for each as it has reflections, in order
    double fastest = 1;              ///< largest of the particles
    std::vector<Particle> particles; ///< where images are recalled

    void add(const ImageEntry<dim>& e, const Vector<dim>& place, const Mirror* of)
    {
        entries.push_back(e);
        places.push_back(place);
        mirrors.insert(mirrors.end(), of, of + e.reflections);
    }
};
/// Particles whose images make one MadeImages.
inline constexpr std::size_t particlesAtOnce = 256;

/// Images that were made before, of which those of particles that have hardly moved are taken again.
template<int dim> struct Recall
{
    std::span<const MadeImages<dim>> made; ///< of particlesAtOnce particles each
    const double* number = nullptr;        ///< ImagesMade of each particle; null: no images are recalled
    double way = 0;                        ///< [m]
    bool places = false;                   ///< the positions of recalled images are asked for
};

/// Way within which images are recalled [m] where walls stay where they are: only those of meshes take longer to find than to copy. 0: none are.
double recalledWithin(const Geometry&, double spacing);

/// Images of the particles `begin` to `end` - 1, in portions of particlesAtOnce that follow one another. Where walls do not reflect there are those of the periods alone.
template<int dim>
std::vector<MadeImages<dim>> makeImages(const ReflectingWalls&, bool wallsReflect, const std::array<double*, dim>& x, std::size_t begin,
                                        std::size_t end, const Recall<dim>& = {});

}
