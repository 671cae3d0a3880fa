/// Function object `forces`: forces of the fluid or soil on walls.
#pragma once
#include "sampling/FunctionContext.hpp"
#include <optional>

namespace sph
{

/// The force on each of some walls, and how far its velocity has carried it, as OpenFOAM's function object of the same name; while a case runs alone.
///
///     type forces;  patches (footing);  executeControl runTime;  executeInterval 1e-3;
///
/// In 2-D [N/m]. Written to forces.dat. The solver measures them (solver/WallForces.hpp).
class Forces : public FunctionObject
{
    struct Wall
    {
        std::string name;
        Vector<3> velocity; ///< [m/s]
        bool underLoad;
        Vector<3> force; ///< [N]
    };
    FunctionContext context_;
    std::vector<Wall> walls_;
    Location where_;
    std::optional<OutputTable> table_;

public:
    static EntryList entries();
    static TableInfo table();
    Forces(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override;
};

}
