/// Measure: a number that a model publishes of the whole scene.
#pragma once
#include "sampling/Measurement.hpp"
#include <string>

namespace sph
{

/// A number that a model publishes of the whole scene (the columns of its report: `power(hot)` of thermal, `amount(dye)` of scalarTransport), against a
/// given value; of the moment, or the mean of all samples from a time on. Dictionary:
///
///     number "power(hot)";  value 0.0266;               // the reference
///     meanFrom 20;                                      // [s]
///
/// A number that no model publishes is an error, which lists those that there are. Stored times know no models' numbers: the value is then nan.
class ModelNumber
{
    std::string number_;
    double reference_;
    std::optional<double> meanFrom_;
    Location where_;
    std::vector<double> times_, values_;

public:
    static EntryList entries();
    ModelNumber(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&);
    std::vector<std::vector<double>*> lists() { return {&times_, &values_}; }
};

}
