/// View of a running or stored case for function objects: read-only arrays, names and numbers, nothing of the solver.
#pragma once
#include "case/Cloud.hpp"
#include "geometry/Geometry.hpp"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

/// Energy and impulse that forces have given the fluid since the start of the run, and the energy that it stores beside motion.
struct Supply
{
    Vector<3> impulse;         ///< of gravity and body force [kg m/s]
    double work = 0;           ///< of gravity, of the body force and of models [J]
    double stored = 0;         ///< energy of interfaces and of compression [J]
    bool ofBoundaries = false; ///< the work of moving walls and openings is counted
};

struct ParticleView
{
    int dimension = 3;
    std::size_t n = 0;
    const double *x = nullptr, *y = nullptr, *z = nullptr; ///< positions [m]; z null in 2-D
    std::vector<FieldView> fields;                         ///< U rho p and what the models show; 2-D vectors have a null third component
    const double *mass = nullptr, *volume = nullptr;       ///< [kg], [m^3]
    const double* phase = nullptr;                         ///< index into `phases` as a number
    const double* heldBy = nullptr; ///< > 0 of particles that openings hold beyond their planes; null where there are none
    std::vector<std::string> phases;
    std::vector<double> restDensity, soundSpeed, viscosity; ///< of each phase [kg/m^3], [m/s], [Pa s]
    std::map<std::string, std::vector<double>> constants;   ///< of models, by the keyword of their entry
    Vector<3> g;                                            ///< gravity or driving acceleration of the first phase [m/s^2]
    Vector<3> gravity, bodyForce;                           ///< that act at the view's time [m/s^2], [N/m^3]
    double spacing = 0, support = 0;                        ///< [m]
    std::string kernel;
    const Geometry* geometry = nullptr;

    std::optional<Supply> supply;          ///< none of stored times, which do not know it
    std::map<std::string, double> numbers; ///< that models tell of the whole scene, by name (RunningModel::columns)

    double time = 0, deltaT = 0, executionTime = 0;
    long step = 0;

    /// Whether a particle is part of the scene, and not of an opening's buffer: means and extremes are of those. Sums over neighbours take all particles.
    bool inScene(std::size_t i) const { return !heldBy || heldBy[i] == 0; }
    /// Null where there is no such field.
    const FieldView* find(const std::string& name) const
    {
        for (const auto& f : fields)
            if (f.name == name) return &f;
        return nullptr;
    }
};

}
