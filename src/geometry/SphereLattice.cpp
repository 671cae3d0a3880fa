#include "geometry/Geometry.hpp"
#include <stdexcept>

namespace sph
{

SphereLattice sphereLattice(const std::string& lattice, double a)
{
    if (lattice == "sc") return {{{0, 0, 0}}, {a, a, a}};
    if (lattice == "bcc") return {{{0, 0, 0}, {a / 2, a / 2, a / 2}}, {a, a, a}};
    if (lattice == "fcc") return {{{0, 0, 0}, {a / 2, a / 2, 0}, {a / 2, 0, a / 2}, {0, a / 2, a / 2}}, {a, a, a}};
    if (lattice != "hcp") throw std::invalid_argument("sphereLattice: no lattice " + lattice);
    const double row = std::sqrt(3.0) * a, layers = std::sqrt(8.0 / 3.0) * a;
    return {{{0, 0, 0}, {a / 2, row / 2, 0}, {a / 2, row / 6, layers / 2}, {0, 2 * row / 3, layers / 2}}, {a, row, layers}};
}

}
