/// Fields and expressions that are sampled at points or over slabs.
#pragma once
#include "sampling/ParticleExpression.hpp"
#include <vector>

namespace sph
{

/// Dictionary:
///
///     fields (U p);
///     expressions { speed "mag($U)"; head "$p/9810 + $y"; push "-grad($p)"; }
///
/// An expression has the name that the case gives it, and may give a vector.
class SampledValues
{
    std::vector<std::string> fields_;
    Location where_;
    std::vector<std::pair<std::string, ParticleExpression>> expressions_;

public:
    struct Value
    {
        std::string name;
        std::vector<std::string> columns;      ///< one a component: "p", "U_x"
        std::vector<std::vector<double>> rows; ///< of an expression
        std::vector<const double*> ofField;    ///< of a field; null: 0
        const double* component(std::size_t c) const { return rows.empty() ? ofField[c] : rows[c].data(); }
    };

    static EntryList entries();
    explicit SampledValues(const Dictionary&);
    /// The names in the order in which they stand, those of fields first.
    std::vector<std::string> names() const;
    /// Throws CaseError where the view has no such field, or an expression has a name that there is not.
    std::vector<Value> operator()(const ParticleView&) const;
};

}
