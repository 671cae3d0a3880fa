#include "surfaces/IsoSurface.hpp"
#include "surfaces/Cuts.hpp"
#include <algorithm>
#include <cmath>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCleanPolyData.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkStripper.h>
#include <vtkWindowedSincPolyDataFilter.h>

namespace sph
{

namespace
{

/// An array of VTK's on the numbers of a vector, which must outlive it.
vtkSmartPointer<vtkDoubleArray> view(const std::vector<double>& values)
{
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetArray(const_cast<double*>(values.data()), vtkIdType(values.size()), 1);
    return array;
}

/// The iso-surface in units of steps from the first node: VTK's filters compute points in single precision, which is exact for
/// the numbers of nodes, so that cuts at the domain's faces and periodic copies fit.
Mesh contourInSteps(const std::array<int, 3>& nodes, const std::vector<double>& values, double iso, bool normals)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(nodes[0], nodes[1], nodes[2]);
    image->GetPointData()->SetScalars(view(values));
    if (nodes[2] == 1)
    {
        vtkNew<vtkFlyingEdges2D> contour;
        contour->SetInputData(image);
        contour->ComputeScalarsOff();
        contour->SetValue(0, iso);
        contour->Update();
        return contour->GetOutput();
    }
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(image);
    contour->ComputeScalarsOff();
    contour->SetComputeNormals(normals);
    contour->SetValue(0, iso);
    contour->Update();
    return contour->GetOutput();
}

/// Converts steps to metres, in double precision; `firstNode` is the number of the grid's first node in the contour's image, points
/// outside the grid are moved onto its faces.
void toMetres(vtkPolyData* mesh, const RegularGrid& grid, int firstNode)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(mesh->GetNumberOfPoints());
    const double low[3] = {grid.low.x, grid.low.y, grid.low.z}, step[3] = {grid.step.x, grid.step.y, grid.step.z};
    auto* normals = mesh->GetPointData()->GetNormals();
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
        double x[3], n[3];
        mesh->GetPoint(p, x);
        for (int d = 0; d < 3; ++d)
            x[d] = low[d] + step[d] * std::clamp(x[d] - (d < grid.dimension ? firstNode : 0), 0.0, double(grid.nodes[d] - 1));
        points->SetPoint(p, x);
        if (!normals) continue;
        normals->GetTuple(p, n);
        Vector<3> unit{n[0] / step[0], n[1] / step[1], n[2] / step[2]};
        if (const double size = mag(unit); size > 0) unit = unit / size;
        normals->SetTuple3(p, unit.x, unit.y, unit.z);
    }
    mesh->SetPoints(points);
}

Mesh outsideSolids(vtkPolyData* mesh, const Geometry& geometry)
{
    if (geometry.patches.empty() || mesh->GetNumberOfPoints() == 0) return mesh;
    vtkNew<vtkDoubleArray> distance;
    distance->SetNumberOfValues(mesh->GetNumberOfPoints());
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
        double x[3];
        mesh->GetPoint(p, x);
        distance->SetValue(p, geometry.distance({x[0], x[1], x[2]}));
    }
    return clipped(mesh, distance);
}

Mesh smoothed(vtkPolyData* mesh, int passes)
{
    vtkNew<vtkWindowedSincPolyDataFilter> filter;
    filter->SetInputData(mesh);
    filter->SetNumberOfIterations(passes);
    filter->SetPassBand(0.03);
    filter->BoundarySmoothingOff();
    filter->NormalizeCoordinatesOn();
    filter->Update();
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(filter->GetOutputPort());
    normals->SplittingOff();
    normals->ConsistencyOff();
    normals->Update();
    return normals->GetOutput();
}

/// Segments joined into lines.
Mesh linesOf(vtkPolyData* segments)
{
    vtkNew<vtkStripper> stripper;
    stripper->SetInputData(segments);
    stripper->JoinContiguousSegmentsOn();
    stripper->SetMaximumLength(1 << 30);
    stripper->Update();
    return stripper->GetOutput();
}

Vector<3> point(vtkPolyData* mesh, vtkIdType id)
{
    double x[3];
    mesh->GetPoint(id, x);
    return {x[0], x[1], x[2]};
}

/// Calls `visit(n, ids)` for each cell of an array of cells.
void forEachCell(vtkCellArray* cells, const auto& visit)
{
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
        vtkIdType n;
        const vtkIdType* ids;
        iterator->GetCurrentCell(n, ids);
        visit(n, ids);
    }
}

}

Mesh freeSurface(const RegularGrid& grid, const std::vector<double>& colour, double iso, const Geometry& geometry, int smoothingPasses)
{
    auto mesh = contourInSteps(grid.nodes, colour, iso, true);
    toMetres(mesh, grid, 0);
    if (smoothingPasses > 0 && mesh->GetNumberOfPoints() > 0) mesh = smoothed(mesh, smoothingPasses);
    mesh = outsideSolids(mesh, geometry);
    return grid.dimension == 2 ? linesOf(mesh) : mesh;
}

Mesh closedSurface(const RegularGrid& grid, const std::vector<double>& colour, double iso, const std::vector<double>& wallDistance,
                   double length)
{
    const auto region = [&](int i, int j, int k)
    {
        const auto node = grid.index(i, j, k);
        const double c = length * (colour[node] - iso);
        return wallDistance.empty() ? c : std::min(c, wallDistance[node]);
    };
    // One layer more on each side, of the opposite sign; its crossings are then moved onto the faces.
    const int deep = grid.dimension == 3 ? 1 : 0;
    const std::array<int, 3> nodes{grid.nodes[0] + 2, grid.nodes[1] + 2, grid.nodes[2] + 2 * deep};
    std::vector<double> values;
    values.reserve(std::size_t(nodes[0]) * nodes[1] * nodes[2]);
    for (int k = 0; k < nodes[2]; ++k)
        for (int j = 0; j < nodes[1]; ++j)
            for (int i = 0; i < nodes[0]; ++i)
            {
                const int a = std::clamp(i - 1, 0, grid.nodes[0] - 1), b = std::clamp(j - 1, 0, grid.nodes[1] - 1),
                          c = std::clamp(k - deep, 0, grid.nodes[2] - 1);
                const double inner = region(a, b, c);
                const bool padded = a != i - 1 || b != j - 1 || c != k - deep;
                values.push_back(padded ? -std::fabs(inner) - 1e-12 * length : inner);
            }
    auto mesh = contourInSteps(nodes, values, 0, false);
    toMetres(mesh, grid, 1);
    vtkNew<vtkCleanPolyData> clean;
    clean->SetInputData(mesh);
    clean->ConvertPolysToLinesOff();
    clean->ConvertLinesToPointsOff();
    clean->SetTolerance(0);
    clean->Update();
    return grid.dimension == 2 ? linesOf(clean->GetOutput()) : Mesh(clean->GetOutput());
}

Mesh wallSurface(const RegularGrid& grid, const std::vector<double>& wallDistance, const Geometry& geometry)
{
    if (wallDistance.empty()) return Mesh::New();
    std::vector<double> solid(wallDistance.size());
    std::transform(wallDistance.begin(), wallDistance.end(), solid.begin(), [](double d) { return -d; });
    auto mesh = contourInSteps(grid.nodes, solid, 0, true);
    toMetres(mesh, grid, 0);
    // The exact normal is the gradient of the distance; differences over a hundredth of a step keep shading free of the grid's
    // pattern.
    if (auto* normals = mesh->GetPointData()->GetNormals())
    {
        const double h = 0.01 * grid.smallestStep();
        for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
        {
            const auto x = point(mesh, p);
            const auto slope = [&](const Vector<3>& e) { return geometry.distance(x + h * e) - geometry.distance(x - h * e); };
            const Vector<3> n{slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
            if (const double size = mag(n); size > 0) normals->SetTuple3(p, n.x / size, n.y / size, n.z / size);
        }
    }
    return mesh;
}

double measure(vtkPolyData* mesh)
{
    double sum = 0;
    forEachCell(mesh->GetPolys(),
                [&](vtkIdType n, const vtkIdType* ids)
                {
                    Vector<3> twice;
                    for (vtkIdType c = 2; c < n; ++c)
                        twice += cross(point(mesh, ids[c - 1]) - point(mesh, ids[0]), point(mesh, ids[c]) - point(mesh, ids[0]));
                    sum += mag(twice) / 2;
                });
    forEachCell(mesh->GetLines(),
                [&](vtkIdType n, const vtkIdType* ids)
                {
                    for (vtkIdType c = 1; c < n; ++c) sum += mag(point(mesh, ids[c]) - point(mesh, ids[c - 1]));
                });
    return sum;
}

double signedVolume(vtkPolyData* mesh)
{
    double sum = 0;
    forEachCell(mesh->GetPolys(),
                [&](vtkIdType n, const vtkIdType* ids)
                {
                    for (vtkIdType c = 2; c < n; ++c)
                        sum += dot(point(mesh, ids[0]), cross(point(mesh, ids[c - 1]), point(mesh, ids[c]))) / 6;
                });
    return sum;
}

}
