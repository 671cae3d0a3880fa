/// Meshes that the periodic faces of the domain cut.
#pragma once
#include "meshes/MeshSpace.hpp"
#include "meshes/readers/NumberedMesh.hpp"

namespace sph
{

/// Continues a mesh over the periodic faces that cut it: a surface that ends in lines on both faces of a direction, open there or closed by facets in them
/// (caps, which go), is joined to its copies. Bodies that were cut are whole then, each in the period that its middle lies in. What goes on through the
/// domain, as a pipe does, spans some periods to either side, and is closed beyond them, out of the kernel's sight.
///
/// Lines on the one face must have their like on the other: points within `tolerance` [m] of the place one period on are one. Throws UnusableMesh with the
/// largest misfit and its place where they have not, where a line is not closed, where one body goes on through faces of two directions, and where one is
/// longer than the periods that were joined. A mesh that ends in lines on one face alone, or on none, is left as it is: bodies repeat as a whole (repeatPeriodically).
void continuePeriodically(NumberedMesh&, const MeshSpace&, double tolerance, std::vector<std::string>& repairs);

}
