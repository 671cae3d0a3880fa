/// Images of particles, when neighbour lists are built: each particle is mirrored in the walls within reach, its images in further walls as the decision table
/// says (chainTable.hpp), and all of them are shifted by the periods.
#pragma once
#include "images/ReflectingWalls.hpp"

namespace sph
{

template<int dim> struct ImageEntry
{
    int source;
    std::array<signed char, dim> shift;
    unsigned char reflections = 0;
    int place = 0; ///< place in the arrays, behind the owned particles and the copies of other ranks'
    bool ghost() const { return reflections > 0; }
};
static_assert(sizeof(ImageEntry<3>) <= 12);

/// Images of some particles, in the order of their sources.
template<int dim> struct MadeImages
{
    std::vector<ImageEntry<dim>> entries;
    std::vector<Vector<dim>> places; ///< positions
    std::vector<Mirror> mirrors;     ///< mirrors of all ghosts, as many for each as it has reflections, in order
    double fastest = 1;              ///< largest speed of an image over that of its source

    void add(const ImageEntry<dim>& e, const Vector<dim>& place, const Mirror* of)
    {
        entries.push_back(e);
        places.push_back(place);
        mirrors.insert(mirrors.end(), of, of + e.reflections);
    }
};

/// Images of the particles `begin` to `end` - 1, in portions that follow one another. Where walls do not reflect there are those of the periods alone.
template<int dim>
std::vector<MadeImages<dim>> makeImages(const ReflectingWalls&, bool wallsReflect, const std::array<double*, dim>& x, std::size_t begin,
                                        std::size_t end);

}
