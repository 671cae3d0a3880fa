#include "surfaces/Cuts.hpp"
#include <algorithm>
#include <cmath>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace sph
{

namespace
{

/// Two triangles for each cell of nu x nv points in rows, the first of which is number `start`; turned round where `reversed`.
void addTriangles(vtkCellArray* triangles, vtkIdType start, int nu, int nv, bool reversed)
{
    for (int b = 0; b + 1 < nv; ++b)
        for (int a = 0; a + 1 < nu; ++a)
        {
            const vtkIdType p00 = start + a + vtkIdType(nu) * b, p10 = p00 + 1, p01 = p00 + nu, p11 = p01 + 1;
            vtkIdType lower[3] = {p00, p10, p11}, upper[3] = {p00, p11, p01};
            if (reversed)
            {
                std::swap(lower[1], lower[2]);
                std::swap(upper[1], upper[2]);
            }
            triangles->InsertNextCell(3, lower);
            triangles->InsertNextCell(3, upper);
        }
}

/// Clipped by `first` and then by `second`, both at the points of the mesh.
Mesh clippedByBoth(vtkPolyData* mesh, vtkDoubleArray* first, vtkDoubleArray* second)
{
    second->SetName("second");
    mesh->GetPointData()->AddArray(second);
    const auto part = clipped(mesh, first);
    const vtkSmartPointer<vtkDoubleArray> rest = vtkDoubleArray::SafeDownCast(part->GetPointData()->GetArray("second"));
    part->GetPointData()->RemoveArray("second");
    return rest ? clipped(part, rest) : part;
}

}

Mesh clipped(vtkPolyData* mesh, vtkDoubleArray* values)
{
    mesh->GetPointData()->SetScalars(values);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(mesh);
    clip->SetValue(0);
    clip->Update();
    Mesh result = clip->GetOutput();
    result->GetPointData()->SetScalars(nullptr);
    return result;
}

Mesh behind(const CutPlane& plane, vtkPolyData* mesh)
{
    if (mesh->GetNumberOfPoints() == 0) return mesh;
    vtkNew<vtkDoubleArray> depth;
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
        double x[3];
        mesh->GetPoint(p, x);
        depth->InsertNextValue(-plane.height({x[0], x[1], x[2]}));
    }
    return clipped(mesh, depth);
}

Mesh cutFaces(const RegularGrid& grid, const std::vector<double>& inside, const std::vector<double>& alsoInside)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> triangles;
    vtkNew<vtkDoubleArray> first, second;
    const auto addFace = [&](int axis, bool high)
    {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const vtkIdType start = points->GetNumberOfPoints();
        for (int b = 0; b < grid.nodes[v]; ++b)
            for (int a = 0; a < grid.nodes[u]; ++a)
            {
                std::array<int, 3> n{};
                n[axis] = high ? grid.nodes[axis] - 1 : 0;
                n[u] = a;
                n[v] = b;
                const auto x = grid.node(n[0], n[1], n[2]);
                points->InsertNextPoint(x.x, x.y, x.z);
                const auto node = grid.index(n[0], n[1], n[2]);
                first->InsertNextValue(inside[node]);
                second->InsertNextValue(alsoInside.empty() ? 1 : alsoInside[node]);
            }
        addTriangles(triangles, start, grid.nodes[u], grid.nodes[v], !high);
    };
    if (grid.dimension == 2) addFace(2, true);
    else
        for (int axis = 0; axis < 3; ++axis)
        {
            addFace(axis, false);
            addFace(axis, true);
        }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(triangles);
    if (alsoInside.empty()) return clipped(mesh, first);
    return clippedByBoth(mesh, first, second);
}

Mesh sectionOn(const CutPlane& plane, const RegularGrid& grid, const std::function<double(const Vector<3>&)>& inside)
{
    // A square around the domain's centre that covers the domain in any direction.
    const double half = 0.5 * mag(grid.high() - grid.low);
    const int n = 2 * int(std::ceil(half / grid.smallestStep())) + 1;
    const auto middle = 0.5 * (grid.low + grid.high());
    const auto centre = middle - plane.height(middle) * plane.normal;
    const auto [e1, e2] = crossSection(plane.normal);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> inDomain, inBody;
    for (int b = 0; b < n; ++b)
        for (int a = 0; a < n; ++a)
        {
            const auto x = centre + (half * (2.0 * a / (n - 1) - 1)) * e1 + (half * (2.0 * b / (n - 1) - 1)) * e2;
            points->InsertNextPoint(x.x, x.y, x.z);
            const auto low = x - grid.low, high = grid.high() - x;
            inDomain->InsertNextValue(std::min({low.x, low.y, low.z, high.x, high.y, high.z}));
            inBody->InsertNextValue(inDomain->GetValue(inDomain->GetNumberOfValues() - 1) > -2 * grid.largestStep() ? inside(x) : -1);
        }
    vtkNew<vtkCellArray> triangles;
    addTriangles(triangles, 0, n, n, false);
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(triangles);
    return clippedByBoth(mesh, inDomain, inBody);
}

Mesh solidsOn(const CutPlane& plane, const RegularGrid& grid, const Geometry& geometry)
{
    if (geometry.patches.empty()) return Mesh::New();
    return sectionOn(plane, grid, [&](const Vector<3>& x) { return -geometry.distance(x); });
}

Mesh joined(vtkPolyData* a, vtkPolyData* b)
{
    vtkNew<vtkAppendPolyData> both;
    both->AddInputData(a);
    both->AddInputData(b);
    both->Update();
    return both->GetOutput();
}

}
