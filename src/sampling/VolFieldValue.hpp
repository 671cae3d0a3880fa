/// Function object `volFieldValue`: one value of each field over a box.
#pragma once
#include "sampling/FunctionContext.hpp"
#include <optional>

namespace sph
{

/// One value of each field over the particles in a box, as OpenFOAM's function object of the same name.
///
///     type volFieldValue;  operation volAverage;  fields (phi U);  min (0 0 0);  max (1e-3 1e-3 1e-3);
///
/// operation: volAverage (sum V f/sum V), min, max. The box is all of the domain unless given. Written to volFieldValue.dat; nan where
/// the box holds no particle.
class VolFieldValue : public FunctionObject
{
    FunctionContext context_;
    Box box_;
    std::vector<std::string> fields_;
    Location fieldsWhere_;
    std::string operation_;
    std::vector<Column> columns_;
    std::vector<double> values_;
    std::optional<OutputTable> table_;

    double value(const ParticleView&, const double* field) const;

public:
    static EntryList entries();
    static TableInfo table();
    VolFieldValue(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override;
};

}
