#include "surfaces/SmoothedField.hpp"
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace sph
{

SmoothedField::SmoothedField(const RegularGrid& grid, PhaseParticles particles, const std::vector<double>& values,
                             const std::string& kernel, double support)
    : grid_(grid), weight_(colourFunction(grid, {}, particles, kernel, support, Normalisation::none))
{
    for (std::size_t p = 0; p < particles.size(); ++p) particles.volume[p] *= values[p];
    sum_ = colourFunction(grid, {}, particles, kernel, support, Normalisation::none);
}

double SmoothedField::operator()(const Vector<3>& x) const
{
    const double weight = interpolated(grid_, weight_, x);
    return weight > 0 ? interpolated(grid_, sum_, x) / weight : 0;
}

void SmoothedField::colour(vtkPolyData* mesh) const
{
    vtkNew<vtkDoubleArray> values;
    values->SetName("value");
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
        double x[3];
        mesh->GetPoint(p, x);
        values->InsertNextValue((*this)({x[0], x[1], x[2]}));
    }
    mesh->GetPointData()->SetScalars(values);
}

}
