/// Function object `surfaceIntegral`: integrals of an expression over a wall.
#pragma once
#include "sampling/FunctionContext.hpp"
#include "sampling/ParticleExpression.hpp"
#include "sampling/WallTriangles.hpp"
#include <optional>

namespace sph
{

/// Integrals over a wall within a region, with f an expression of fields at particles, n the normal into the fluid:
///
///   integral = int f dA,  force = -int f n dA,  torque = -int (x - origin) x f n dA
///
/// force and torque are those of a pressure f; per metre of depth in 2-D. f is carried to the wall by weights that are exact for linear fields, as the colour of WettedWalls, and is 0
/// where there are no particles:
///
///   f(x) = sum_j w_j f_j  min(1, sum_j V_j W_j/D)
///
/// It varies linearly over triangles no longer than half a spacing, without what lies in another solid.
///
///     type surfaceIntegral;  wall floor;  value "$p";  phase water;  region { min (0 0 0); max (1 1 0); }
class SurfaceIntegral : public FunctionObject
{
    FunctionContext context_;
    std::size_t wall_;
    ParticleExpression value_;
    std::optional<std::size_t> phase_;
    Box region_;
    Vector<3> origin_;
    std::optional<WallTriangles> triangles_;
    std::optional<OutputTable> table_;

    struct Sum
    {
        double area = 0, integral = 0;
        Vector<3> force, torque;
        Sum& operator+=(const Sum&);
    } last_;

public:
    static EntryList entries();
    static TableInfo table();
    SurfaceIntegral(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override;
};

}
