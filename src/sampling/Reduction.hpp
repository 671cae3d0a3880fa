/// Function object `reduction`: numbers that the case makes of expressions.
#pragma once
#include "sampling/Numbers.hpp"
#include <optional>

namespace sph
{

/// The numbers of Numbers.hpp as columns of a table, one row a time.
///
///     type reduction;
///     numbers { front { operation max; value "$x + $spacing/2"; phase water; } }
class Reduction : public FunctionObject
{
    FunctionContext context_;
    Numbers numbers_;
    NamedNumbers last_;
    std::optional<OutputTable> table_;

public:
    static EntryList entries();
    static TableInfo table();
    Reduction(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override;
    Histories histories() const override { return numbers_.histories(); }
    void restore(const Histories& stored) override { numbers_.restore(stored); }
};

}
