/// Numbers of a view by name, each a reduction of an expression over particles, or a formula of the numbers before it.
#pragma once
#include "sampling/ContourShape.hpp"
#include "sampling/FunctionContext.hpp"
#include "sampling/HistoryFit.hpp"
#include "sampling/ParticleExpression.hpp"
#include <optional>

namespace sph
{

/// Dictionary:
///
///     numbers
///     {
///         inside   { operation mean; value "$p"; phase water; where "sqrt($x^2 + $y^2) < 0.2"; }
///         outside  { operation mean; value "$p"; phase air; }
///         jump     { value "$inside - $outside"; }               // no operation: a formula of what is above it
///         speed    { operation percentile; percent 99; value "mag($U)"; region { min (0 0 0); max (1 1 0); } }
///         atFloor  { operation mean; value "$p"; wall floor; within 1; }
///         steady   { operation timeMean; value "$jump"; from 2; }
///         filled   { operation arrival; value "$speed"; level 0.1; }
///         period   { operation fit; value "$jump"; from 0.5; form oscillation; gives period; }     // HistoryFit.hpp
///         angle    { operation contour; phase water; wall floor; gives angle; }                    // ContourShape.hpp
///     }
///
/// Of the particles that are chosen, f the value and w the weight (the volume unless given):
///
///   sum = sum_i f_i,  mean = sum_i w_i f_i/sum_i w_i
///
/// percentile: the least value that has at least the share `percent` of the weight at or below it. NaN where no particle is chosen; a sum is 0 then. Particles that openings
/// hold beyond their planes are left out.
///
/// Over time, of the values that a formula had at the rows since `from`, until `to`, a restarted run goes on with them: timeMean, their mean, of which there is none before; arrival, the first time at which
/// they have gone past `level` [s], between two rows in proportion; fit, a constant of a law. NaN while there is none.
class Numbers
{
    enum class Operation
    {
        formula,
        sum,
        mean,
        min,
        max,
        percentile,
        timeMean,
        arrival,
        fit,
        contour
    };
    struct Number
    {
        std::string name;
        Operation operation = Operation::formula;
        std::optional<ParticleExpression> value, weight, condition; ///< a value but of a contour
        std::optional<std::size_t> phase;
        std::optional<Box> region;
        std::optional<int> wall;
        double within = 0; ///< distance to the wall [spacings]
        double percent = 0, level = 0;
        std::optional<HistoryFit> fit;
        History history;
        std::optional<ContourShape> contour;
        std::size_t figure = 0; ///< of the contour, in the order of contourFigures

        bool isOverTime() const { return operation >= Operation::timeMean && operation != Operation::contour; }
        /// A number over time, with `now` the value that its formula has.
        NamedNumber overTime(const ParticleView&, double now);
    };
    std::vector<Number> numbers_;

    static std::vector<char> chosen(const Number&, const ParticleView&, const NamedNumbers&);
    static NamedNumber reduced(const Number&, const ParticleView&, const NamedNumbers&);

public:
    /// Of a dictionary that holds the sub-dictionary `numbers`; `beside`: what else a number may have.
    static EntryList entries(const EntryList& beside = {});
    static bool given(const Dictionary&);
    Numbers(const Dictionary&, const FunctionContext&);
    /// The dictionary of one of them.
    static Dictionary of(const Dictionary&, const std::string& name);
    std::vector<std::string> names() const;
    NamedNumbers operator()(const ParticleView&);
    /// Lists of those over time by name, for a restart.
    Histories histories() const;
    void restore(const Histories&);
};

}
