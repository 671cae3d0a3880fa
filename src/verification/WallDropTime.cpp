#include "verification/WallDropTime.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/sharedEntries.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

namespace entry
{
const Scalar share{"share", units::none, required, positiveBelow(1).saying("must be above 0 and less than 1: the whole way is never gone"),
                   "share of the way from the start to the last value"},
    time{"time", units::s, required, positive, "the exact time"},
    start{"start", Unit{units::none, "of the field"}, required, "its uniform value at t = 0"};
const Direction wallNormal{"normal", Vector<3>{0, 1, 0}, "of the wall through origin, into the fluid"};
}

WallDropTime::WallDropTime(const Dictionary& d, const Geometry&, const std::vector<std::string>&)
    : field_(entry::field(d)),
      share_(entry::share(d)),
      reference_(entry::time(d)),
      origin_(entry::origin(d)),
      normal_(entry::wallNormal(d)),
      where_(entry::field.where(d)),
      times_{0},
      values_{entry::start(d)}
{}

EntryList WallDropTime::entries() { return {entry::field, entry::start, entry::share, entry::time, entry::origin, entry::wallNormal}; }

double WallDropTime::wallValue(const ParticleView& view) const
{
    const SampledField f(view, field_, where_);
    const auto distance = [&](std::size_t i) { return dot(position(view, i) - origin_, normal_); };
    // This order of arguments puts a NaN into the first row, where it shows in the value.
    const auto row = [&](std::size_t i) { return std::size_t(std::min(3.0, std::max(0.0, distance(i) / view.spacing))); };
    const auto distances = groupSums(view.n, 3, row, [&](std::size_t i) { return VolumeMean<>::of(1, distance(i)); }),
               values = groupSums(view.n, 3, row, [&](std::size_t i) { return VolumeMean<>::of(1, f(0, i)); });
    double atWall = 0;
    for (std::size_t a = 0; a < 3; ++a)
    {
        const double d_a = distances[a].value();
        double term = values[a].value();
        for (std::size_t b = 0; b < 3; ++b)
            if (const double d_b = distances[b].value(); b != a) term *= d_b / (d_b - d_a);
        atWall += term;
    }
    return atWall;
}

Measurement WallDropTime::operator()(const ParticleView& view)
{
    Measurement result{std::numeric_limits<double>::quiet_NaN(), reference_, view.n, "nothing has changed yet"};
    const double value = wallValue(view);
    if (std::isnan(value))
    {
        result.note = "of the three rows of particles beside the wall one is empty";
        return result;
    }
    if (!times_.empty() && view.time <= times_.back()) values_.back() = value; // a restarted run samples the time of its folder again
    else
    {
        times_.push_back(view.time);
        values_.push_back(value);
    }
    const double way = values_.back() - values_.front();
    for (std::size_t k = 1; k < times_.size() && way != 0; ++k)
    {
        const double before = (values_[k - 1] - values_[0]) / way, after = (values_[k] - values_[0]) / way;
        if (after < share_) continue;
        result.value = times_[k - 1] + (share_ - before) / (after - before) * (times_[k] - times_[k - 1]);
        result.note.clear();
        break;
    }
    return result;
}

}
