#include "meshes/volumes/VoxelContour.hpp"
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

extern "C" void contourVoxels(const std::array<int, 3>& nodes, const float* values, double iso, sph::VoxelContour& contour)
{
    vtkNew<vtkFloatArray> scalars;
    scalars->SetArray(const_cast<float*>(values), vtkIdType(nodes[0]) * nodes[1] * nodes[2], 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(nodes[0], nodes[1], nodes[2]);
    image->GetPointData()->SetScalars(scalars);
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(image);
    edges->ComputeScalarsOff();
    edges->ComputeNormalsOff();
    edges->SetValue(0, iso);
    edges->Update();
    auto* const mesh = edges->GetOutput();
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
        double x[3];
        mesh->GetPoint(p, x);
        contour.points.push_back({float(x[0]), float(x[1]), float(x[2])});
    }
    auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
        vtkIdType n;
        const vtkIdType* ids;
        cells->GetCurrentCell(n, ids);
        contour.triangles.push_back({int(ids[0]), int(ids[1]), int(ids[2])});
    }
}
