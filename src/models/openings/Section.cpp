#include "Section.hpp"
#include "components.hpp"
#include "contains.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
/// Samples to a spacing by which the extents and the area of a section are found.
constexpr int samplesPerSpacing = 8;
}

Section::Section(const Opening& opening, const Geometry& geometry, double spacing) : point_(opening.point), dimension_(geometry.dimension)
{
    // Across the normal, along coordinates where it is along one.
    const auto n = opening.normal;
    const Vector<3> aside = dimension_ == 2                                           ? Vector<3>{0, 0, 1}
                            : std::abs(n.z) <= std::max(std::abs(n.x), std::abs(n.y)) ? Vector<3>{0, 0, 1}
                                                                                      : Vector<3>{0, 1, 0};
    across_[0] = unitVector(cross(aside, n));
    across_[1] = cross(n, across_[0]);
    for (int d = 0; d < dimension_ - 1; ++d)
        for (int k = 0; k < dimension_; ++k)
            if (geometry.periodic[k] && std::abs(std::abs(across_[d].*component(k)) - 1) < 1e-12) repeats_[d] = true;
    findExtents(opening, geometry, spacing);
    if (lines_.empty()) return;
    rowSpacing_ = std::pow(spacing, dimension_) * double(lines_.size()) / area_;
    if (opening.developed) developProfile(opening.where);
}

void Section::findExtents(const Opening& opening, const Geometry& geometry, double spacing)
{
    // What the domain can hold of the plane, as seen from the opening's point.
    double from[2] = {0, 0}, to[2] = {0, 0};
    for (int corner = 0; corner < 8; ++corner)
    {
        const Vector<3> x{corner & 1 ? geometry.high.x : geometry.low.x, corner & 2 ? geometry.high.y : geometry.low.y,
                          corner & 4 ? geometry.high.z : geometry.low.z};
        for (int d = 0; d < dimension_ - 1; ++d)
        {
            from[d] = std::min(from[d], dot(x - point_, across_[d]));
            to[d] = std::max(to[d], dot(x - point_, across_[d]));
        }
    }
    const double fine = spacing / samplesPerSpacing, margin = 1e-9 * spacing;
    const auto samples = [&](int d) { return d < dimension_ - 1 ? int(std::ceil((to[d] - from[d]) / fine - 1e-6)) : 1; };
    const auto sample = [&](int d, int i) { return d < dimension_ - 1 ? from[d] + (i + 0.5) * (to[d] - from[d]) / samples(d) : 0.0; };
    const Box domain{geometry.low - margin * Vector<3>{1, 1, 1}, geometry.high + margin * Vector<3>{1, 1, 1}};
    const auto open = [&](const Vector<3>& x, double clearance)
    { return contains(domain, x, dimension_) && opening.opensAt(x, dimension_) && geometry.distance(x) > clearance; };

    double least[2] = {Box::infinity, Box::infinity}, most[2] = {-Box::infinity, -Box::infinity}, cell = 1;
    for (int d = 0; d < dimension_ - 1; ++d) cell *= (to[d] - from[d]) / samples(d);
    long count = 0;
    for (int i = 0; i < samples(0); ++i)
        for (int k = 0; k < samples(1); ++k)
        {
            const double s[2] = {sample(0, i), sample(1, k)};
            if (!open(at(s[0], s[1]), 0)) continue;
            ++count;
            for (int d = 0; d < 2; ++d)
            {
                least[d] = std::min(least[d], s[d]);
                most[d] = std::max(most[d], s[d]);
            }
        }
    if (count == 0) return;
    area_ = double(count) * cell;
    for (int d = 0; d < dimension_ - 1; ++d)
    {
        const double half = 0.5 * (to[d] - from[d]) / samples(d);
        low_[d] = least[d] - half;
        extent_[d] = most[d] - least[d] + 2 * half;
        n_[d] = std::max(1, int(std::lround(extent_[d] / spacing)));
        step_[d] = extent_[d] / n_[d];
    }
    index_.assign(std::size_t(n_[0]) * n_[1], -1);
    for (int i = 0; i < n_[0]; ++i)
        for (int k = 0; k < n_[1]; ++k)
        {
            const auto foot = at(low_[0] + (i + 0.5) * step_[0], dimension_ == 3 ? low_[1] + (k + 0.5) * step_[1] : 0);
            if (!open(foot, 0.25 * spacing)) continue;
            index_[std::size_t(i) * n_[1] + k] = int(lines_.size());
            lines_.push_back({foot, 1});
        }
}

double Section::width() const { return dimension_ == 3 ? std::min(extent_[0], extent_[1]) : extent_[0]; }

int Section::site(int i, int k) const
{
    if (repeats_[0]) i = (i + n_[0]) % n_[0];
    if (repeats_[1]) k = (k + n_[1]) % n_[1];
    return i < 0 || k < 0 || i >= n_[0] || k >= n_[1] ? -1 : index_[std::size_t(i) * n_[1] + k];
}

int Section::lineAt(const Vector<3>& x) const
{
    int at[2] = {0, 0};
    for (int d = 0; d < dimension_ - 1; ++d) at[d] = int(std::floor((dot(x - point_, across_[d]) - low_[d]) / step_[d]));
    return site(at[0], at[1]);
}

void Section::developProfile(const Location& where)
{
    // Without walls nothing holds the flow back.
    bool walls = false;
    for (int i = -1; i <= n_[0]; ++i)
        for (int k = dimension_ == 3 ? -1 : 0; k < (dimension_ == 3 ? n_[1] + 1 : 1); ++k) walls = walls || site(i, k) < 0;
    if (!walls) return;

    // Successive over-relaxation: the lines are few.
    for (auto& line : lines_) line.profile = 0;
    double change = 1, largest = 0;
    for (int sweep = 0; sweep < 100000 && change > 1e-12 * largest; ++sweep)
    {
        change = 0;
        for (int i = 0; i < n_[0]; ++i)
            for (int k = 0; k < n_[1]; ++k)
            {
                const int self = site(i, k);
                if (self < 0) continue;
                double sum = 1, diagonal = 0;
                for (int d = 0; d < dimension_ - 1; ++d)
                    for (const int side : {-1, 1})
                    {
                        const int next = d == 0 ? site(i + side, k) : site(i, k + side);
                        const double weight = 1 / sqr(step_[d]);
                        diagonal += next < 0 ? 2 * weight : weight; // u = -u_i beyond a wall
                        if (next >= 0) sum += weight * lines_[next].profile;
                    }
                double& u = lines_[self].profile;
                const double by = 1.8 * (sum / diagonal - u);
                u += by;
                change = std::max(change, std::abs(by));
                largest = std::max(largest, u);
            }
    }
    if (!(change <= 1e-12 * largest))
        throw CaseError(where, "the profile of developed flow in this section has not converged; take `profile uniform;`");
    double mean = 0;
    for (const auto& line : lines_) mean += line.profile / double(lines_.size());
    for (auto& line : lines_) line.profile /= mean;
}

}
