/// A law that is fitted to the history of a number, in least squares.
#pragma once
#include "dictionary/EntryList.hpp"
#include "sampling/History.hpp"

namespace sph
{

/// Dictionary, of a number whose history a(t) is kept:
///
///     form oscillation;  gives period;             // or decayRate; `guess` [s] a period near it
///
/// The forms, and what they give:
///
///   exponential:  a = A exp(s t), gives rate s [1/s] or amplitude A, from a line through ln |a|
///   power:  a = A t^n, gives exponent n or factor A, from a line through ln |a| over ln t
///   growth:  a = A exp(s t) + B exp(-s t), gives rate s [1/s]
///   oscillation:  a = Re[A exp(s t)] + B, gives period 2 pi/Im s [s] or decayRate -Re s [1/s]
///
/// NaN while the samples determine no such law: two for a line, a time of 1/s for growth, half a period for an oscillation.
class HistoryFit
{
    std::string form_, gives_;
    std::optional<double> guess_;

public:
    static EntryList entries();
    explicit HistoryFit(const Dictionary&);
    double operator()(const History&) const;
};

}
