#include "meshes/repairSurface.hpp"
#include "meshes/workingMesh.hpp"
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <fmt/format.h>

namespace sph
{

void remesh(NumberedMesh& m, double edgeLength, double featureAngle, std::vector<std::string>& repairs)
{
    namespace pmp = CGAL::Polygon_mesh_processing;
    constexpr unsigned rounds = 3; // more change edge lengths by a few per cent

    const auto before = m.triangles.size();
    auto w = toWorkingMesh(m);
    auto region = regionOf(w), number = numberOf(w);
    auto sharp = w.add_property_map<WorkingMesh::Edge_index, bool>("e:sharp", false).first;
    pmp::detect_sharp_edges(w, featureAngle, sharp);
    pmp::isotropic_remeshing(w.faces(), edgeLength, w,
                             pmp::parameters::number_of_iterations(rounds).edge_is_constrained_map(sharp).face_patch_map(region));
    for (const auto f : w.faces()) number[f] = -1;
    fromWorkingMesh(w, m);
    repairs.push_back(fmt::format("{} remeshed to {} with edges of about {:.4g} m", counted(before, "facet"),
                                  counted(m.triangles.size(), "facet"), edgeLength));
}

}
