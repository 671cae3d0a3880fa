/// Level sets of a function on a line, in a plane or in space.
#pragma once
#include "base/Vector.hpp"
#include <functional>
#include <vector>

namespace sph
{

/// Cells between equidistant nodes along one, two or three directions.
struct Lattice
{
    Vector<3> origin;
    std::vector<Vector<3>> edges; ///< of a cell [m]
    std::vector<std::size_t> cells;

    std::size_t dimension() const { return edges.size(); }
    std::size_t nodes() const;
    Vector<3> node(std::size_t) const;
    /// The node that lies `corner` beside another: bit k of it one step along direction k.
    std::size_t beside(std::size_t node, unsigned corner) const;
    /// The nodes that are the first of a cell.
    std::vector<std::size_t> firstNodes() const;
    double diagonal() const; ///< of a cell [m]
};

/// The places where f is equal to a level, and what they enclose: f above it.
struct LevelSet
{
    /// A place on the level set with the size of the surface that it stands for, and a way to where f is above the level.
    struct Place
    {
        Vector<3> x, up;
        double weight; ///< [m^(dimension - 1)]
    };
    std::vector<Place> places;
    double size = 0;            ///< of the level set [m^(dimension - 1)], of a line the number of places
    double enclosed = 0;        ///< [m^dimension]
    Vector<3> moment;           ///< int x over what is enclosed [m^(dimension + 1)]
    double least = 0, most = 0; ///< of the nodes' values
};

/// The level set of f within inside(x) > 0. `atNodes` are values of f at nodes; where one is NaN there is nothing. Cells are cut into simplices, which fit from cell to cell (Kuhn 1960); on their edges the
/// level set is found to round-off, between them it is straight. `inside` is a distance [m], or changes no faster than one: cells farther than their diagonal from where it is 0 count whole.
LevelSet levelSet(const Lattice&, const std::vector<double>& atNodes, double level, const std::function<double(const Vector<3>&)>& f,
                  const std::function<double(const Vector<3>&)>& inside);

}
