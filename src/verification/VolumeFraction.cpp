#include "verification/VolumeFraction.hpp"
#include "sampling/SampledField.hpp"
#include <utility>

namespace sph
{

double VolumeFraction::operator()(const Vector<3>& x) const
{
    const auto weights = interpolator_.weights(x, Interpolation::shepard);
    if (view_.phases.size() < 2) return weights.coverage;
    double sum = 0;
    for (std::size_t k = 0; k < weights.particle.size(); ++k)
        if (phaseOf(view_, weights.particle[k]) == phase_) sum += weights.weight[k];
    return sum;
}

std::optional<double> VolumeFraction::surface(const Vector<3>& from, const Vector<3>& direction, double reach) const
{
    const auto inside = [&](double r) { return (*this)(from + r * direction) >= 0.5; };
    double in = 0, out = view_.spacing / 2;
    while (out < reach && inside(out)) in = std::exchange(out, out + view_.spacing / 2);
    if (out >= reach) return {};
    for (int k = 0; k < 20; ++k)
    {
        const double middle = (in + out) / 2;
        (inside(middle) ? in : out) = middle;
    }
    return in;
}

}
