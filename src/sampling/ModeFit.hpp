/// Rates of a mode from its amplitude over time, in least squares. The results do not depend on where time begins, nor on the phase.
#pragma once
#include <complex>
#include <optional>
#include <span>

namespace sph
{

/// s of a(t) = Re[A exp(s t)] + B, A complex: decay rate -Re s, period 2 pi/Im s. By Gauss and Newton from `start`; nothing where the samples
/// span less than half a period of it, or determine no rate.
std::optional<std::complex<double>> fitOscillation(std::span<const double> t, std::span<const double> a, std::complex<double> start);

/// s of a(t) = A exp(s t) + B exp(-s t), an interface that starts from a displacement, a velocity or both: the best between a tenth and four
/// times of `start`. Nothing where the samples span less than 1/start.
std::optional<double> fitGrowth(std::span<const double> t, std::span<const double> a, double start);

}
