/// Function object `errors`: errors of fields and measures against references.
#pragma once
#include "sampling/FieldComparison.hpp"
#include "sampling/Measurement.hpp"
#include "sampling/Numbers.hpp"

namespace sph
{

/// Errors against references, beside the run time that they cost.
///
///     type errors;  field U;  component x;  norm relative;
///     reference { type formula; name planePoiseuille; nu 1e-6; acceleration 1e-4; width 1e-3; }
///     // or     { type csv; file "reference/profile.csv"; columns { coordinate y; time t; value v; } }
///     // or     { type expression; value "exp(-4*$t)*sin(2*pi()*$x)"; }
///
/// A number of expressions over time (Numbers.hpp) against a table of times, or an expression of $t, constants and the numbers; it needs no field:
///
///     numbers { front { operation max; value "$x"; reference { type csv; file "front.csv"; columns { time t; value v; } } } }
///
/// Several comparisons at once: `fields ( { field U; reference {..} } { field p; reference {..} } );`. Formulas are those of
/// Formulas.hpp, for fields, and the measures of Measurement.hpp (laplaceJump, contactAngle, dragFactor, dropPeriod ...), which need
/// no field. They come from libraries, those of the suite from libsphVerification.so.
///
/// postProcessing/<name>/<startTime>/errors.dat, a row per time and comparison; tab separated:
///
///     # Time  field  L1  L2  Linf  nParticles  executionTime  value  reference
///
/// value and reference of a field are the L2 norms of field and reference (or `scale`). Of a measure they are its own, and
/// L1 = L2 = Linf is the error |value - reference|, relative to the reference with `norm relative`.
class Errors : public FunctionObject
{
    FunctionContext context_;
    std::vector<std::function<std::optional<ErrorRow>(const ParticleView&)>> comparisons_;
    std::vector<Measure> measures_;
    std::vector<FieldComparison> fields_; ///< those of the comparisons, for their histories
    std::optional<Numbers> numbers_;
    NamedNumbers found_; ///< at the time of the present row
    std::optional<OutputTable> table_;
    std::string report_;

    /// Calls f(name, list) for each list of each measure, and for the means over time of each field.
    void eachList(const std::function<void(const std::string&, std::vector<double>&)>& f) const;
    void readComparison(const Dictionary&);
    void readNumbers(const Dictionary&);
    void compareField(const Dictionary&, ReferenceField, const std::vector<Vector<3>>& rows = {});

public:
    static EntryList entries();
    static TableInfo table();
    Errors(const Dictionary&, const FunctionContext&);
    void execute(const ParticleView&) override;
    std::string report() const override { return report_; }
    Histories histories() const override;
    void restore(const Histories&) override;
};

}
