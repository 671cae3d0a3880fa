/// Function object `contour`: shape and way of a level set.
#pragma once
#include "sampling/ContourShape.hpp"
#include "sampling/History.hpp"
#include <optional>

namespace sph
{

/// The level set of an expression, or the surface of a phase, as ContourShape finds it: area, what it encloses, circle, sphere or ellipsoid, angle with a wall, and how far it has come along a direction, with
/// the times at which it was first past given places, between two rows in proportion.
///
///     type contour;  phase water;  wall floor;
///     type contour;  value "$T";  level 330;  direction (0 0 1);  stations (0.01 0.02);
///
/// Each of the figures is also a number (Numbers.hpp), which `errors` compares with a reference.
class Contour : public FunctionObject
{
    FunctionContext context_;
    ContourShape shape_;
    std::vector<double> stations_; ///< [m]
    History fronts_;
    ContourFigures last_;
    std::optional<OutputTable> table_;

public:
    static EntryList entries();
    static TableInfo table();
    Contour(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override;
    Histories histories() const override;
    void restore(const Histories&) override;
};

}
