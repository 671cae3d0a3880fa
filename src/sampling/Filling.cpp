#include "sampling/Filling.hpp"
#include "geometry/components.hpp"
#include "geometry/contains.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/readBox.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Scalar level{"level", units::none, 0.99, positiveUpTo(1).saying("{} is no share of the cavity, above 0 and at most 1"),
                   "share of the cavity reached at the fill time"};
}

namespace column
{
const Column filled{"filled", "-", "volume of the fluid in the box, at its density at rest, over that of the cavity"},
    reached{"reached", "-", "share of the cavity's points that a particle has within a spacing"},
    minPhi{"minPhi", "-", "least powder fraction of a particle in the box"},
    maxPhi{"maxPhi", "-", "largest powder fraction of a particle in the box"};
}

Filling::Filling(const Dictionary& d, const FunctionContext& context)
    : context_(context), box_(readBox(d, context.geometry)), level_(entry::level(d))
{}

EntryList Filling::entries() { return {entry::min, entry::max, entry::level}; }

TableInfo Filling::table()
{
    return {"filling",
            "filling.dat",
            "how far a cavity is filled; the powder where there is some",
            {column::filled, column::reached, column::minPhi, column::maxPhi}};
}

Vector<3> Filling::centre(int i, int k, int l) const
{
    return box_.low + Vector<3>{(i + 0.5) * step_.x, (k + 0.5) * step_.y, context_.geometry.dimension == 3 ? (l + 0.5) * step_.z : 0};
}

void Filling::findCavity(double spacing)
{
    for (int c = 0; c < context_.geometry.dimension; ++c)
    {
        const double length = box_.high.*component(c) - box_.low.*component(c);
        n_[c] = std::max(1, int(std::lround(length / spacing)));
        step_.*component(c) = length / n_[c];
    }
    cavity_.resize(std::size_t(n_[0]) * n_[1] * n_[2]);
    std::size_t at = 0;
    for (int l = 0; l < n_[2]; ++l)
        for (int k = 0; k < n_[1]; ++k)
            for (int i = 0; i < n_[0]; ++i, ++at)
            {
                const double distance = context_.geometry.distance(centre(i, k, l));
                cavity_[at] = distance > 0;
                volume_ += std::clamp(0.5 + distance / spacing, 0.0, 1.0);
            }
    volume_ *= step_.x * step_.y * step_.z;
    samples_ = double(std::count(cavity_.begin(), cavity_.end(), true));
}

double Filling::shareReached(const ParticleView& view) const
{
    std::vector<bool> reached(cavity_.size(), false);
    const bool flat = context_.geometry.dimension == 2;
    for (std::size_t p = 0; p < view.n; ++p)
    {
        if (!view.inScene(p)) continue;
        const auto from = position(view, p) - box_.low;
        const Vector<3> q{from.x / step_.x, from.y / step_.y, from.z / step_.z};
        if (!contains({{-1, -1, -1}, {n_[0] + 1.0, n_[1] + 1.0, n_[2] + 1.0}}, q, context_.geometry.dimension)) continue;
        const int i_p = int(std::floor(q.x)), k_p = int(std::floor(q.y)), l_p = flat ? 0 : int(std::floor(q.z));
        for (int l = flat ? 0 : l_p - 1; l <= (flat ? 0 : l_p + 1); ++l)
            for (int k = k_p - 1; k <= k_p + 1; ++k)
                for (int i = i_p - 1; i <= i_p + 1; ++i)
                {
                    if (i < 0 || k < 0 || l < 0 || i >= n_[0] || k >= n_[1] || l >= n_[2]) continue;
                    auto by = position(view, p) - centre(i, k, l);
                    if (flat) by.z = 0;
                    if (mag(by) <= view.spacing) reached[(std::size_t(l) * n_[1] + k) * n_[0] + i] = true;
                }
    }
    double count = 0;
    for (std::size_t at = 0; at < cavity_.size(); ++at) count += cavity_[at] && reached[at];
    return count / samples_;
}

void Filling::execute(const ParticleView& view)
{
    if (cavity_.empty()) findCavity(view.spacing);
    const FieldView* const phi = view.find("phi");
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto inBox = [&](std::size_t i) { return view.inScene(i) && contains(box_, position(view, i), context_.geometry.dimension); };
    const double volume = sum(view.n, [&](std::size_t i) { return inBox(i) ? view.mass[i] / view.restDensity[phaseOf(view, i)] : 0; });
    leastPhi_ = least(view.n, [&](std::size_t i) { return phi && inBox(i) ? phi->component[0][i] : infinity; });
    mostPhi_ = most(view.n, [&](std::size_t i) { return phi && inBox(i) ? phi->component[0][i] : -infinity; });
    filled_ = volume / volume_;
    reached_ = shareReached(view);
    if (!fillTime_ && reached_ >= level_) fillTime_ = view.time;
    TableRow row;
    row.add(column::filled, filled_);
    row.add(column::reached, reached_);
    if (phi)
    {
        row.add(column::minPhi, leastPhi_);
        row.add(column::maxPhi, mostPhi_);
    }
    if (!table_)
        table_.emplace(context_.file("filling.dat"),
                       std::vector<std::string>{fmt::format("cavity of {:.6g} points, a spacing apart", samples_)}, row.columns);
    table_->row(view.time, row.cells);
}

std::string Filling::report() const
{
    const auto ended = fillTime_ ? fmt::format("filled to {} at {:.6g} s", level_, *fillTime_) : "not filled yet";
    const auto powder = mostPhi_ < leastPhi_ ? "" : fmt::format(", phi {:.4g} .. {:.4g}", leastPhi_, mostPhi_);
    return fmt::format("{}: {:.4f} of the cavity by volume, {:.4f} reached, {}{}", context_.name, filled_, reached_, ended, powder);
}

}
