#include "models/openings/Section.hpp"
#include "geometry/components.hpp"
#include "geometry/contains.hpp"
#include "models/openings/evenLines.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
/// Samples to a spacing between which the edges of a section are sought.
constexpr int samplesPerSpacing = 8;
/// Lines keep this distance from a wall at least [spacings].
constexpr double leastClearance = 0.25;
/// An edge nearer to a wall than this is one [spacings].
constexpr double onWall = 1e-6;
/// Areas of a section and of the lattice that fits it agree to this.
constexpr double fits = 1e-6;
/// Refinement of the lattice on which the profile is found over lines that are on none.
constexpr int finerForProfile = 4;
/// Number of halvings of a sample's distance to an edge: 1e-12 of a spacing are left.
constexpr int halvings = 40;

/// The edge between a place that is open and one that is not.
double edgeBetween(double in, double out, const auto& open)
{
    for (int k = 0; k < halvings; ++k)
    {
        const double middle = 0.5 * (in + out);
        (open(middle) ? in : out) = middle;
    }
    return in;
}

/// visit(low, high) of each stretch of a straight line that is open.
void eachStretch(double from, double to, double fine, const auto& open, const auto& visit)
{
    const int n = std::max(1, int(std::ceil((to - from) / fine - 1e-6)));
    double before = from, low = from;
    bool wasOpen = open(from);
    const auto look = [&](double at)
    {
        const bool isOpen = open(at);
        if (isOpen && !wasOpen) low = edgeBetween(at, before, open);
        if (!isOpen && wasOpen) visit(low, edgeBetween(before, at, open));
        wasOpen = isOpen;
        before = at;
    };
    for (int i = 0; i < n; ++i) look(from + (i + 0.5) * (to - from) / n);
    look(to);
    if (wasOpen) visit(low, to);
}
}

Section::Section(const Opening& opening, const Geometry& geometry, double spacing, const OpenPlane* plane)
    : point_(opening.point), dimension_(geometry.dimension)
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

    const double margin = 1e-9 * spacing;
    const Box domain{geometry.low - margin * Vector<3>{1, 1, 1}, geometry.high + margin * Vector<3>{1, 1, 1}};
    const auto openOf = [&](const OpenPlane& o)
    {
        return [&](const Vector<3>& x, double clearance = 0)
        { return contains(domain, x, dimension_) && o.opensAt(x, dimension_) && geometry.distance(x) > clearance; };
    };
    const auto own = extentsOf(openOf(opening), geometry, spacing), whole = plane ? extentsOf(openOf(*plane), geometry, spacing) : own;
    if (!(own.area > 0)) return;
    area_ = own.area;
    for (int d = 0; d < dimension_ - 1; ++d)
    {
        width_[d] = own.high[d] - own.low[d];
        low_[d] = whole.low[d];
        n_[d] = std::max(1, int(std::lround((whole.high[d] - whole.low[d]) / spacing)));
        step_[d] = (whole.high[d] - whole.low[d]) / n_[d];
    }
    std::vector<Vector<3>> feet;
    for (int i = 0; i < n_[0]; ++i)
        for (int k = 0; k < n_[1]; ++k)
            if (openOf(plane ? *plane : opening)(centre(i, k), leastClearance * spacing)) feet.push_back(centre(i, k));
    const double onLattice = step_[0] * (dimension_ == 3 ? step_[1] : 1) * double(n_[0] * n_[1]);
    const bool isLattice = feet.size() == std::size_t(n_[0]) * n_[1] && std::abs(whole.area - onLattice) < fits * onLattice;
    const bool isMoved = !isLattice && whole.walled;
    if (isMoved) feet = oneToASquare(whole, spacing, openOf(plane ? *plane : opening));
    if (feet.empty()) return;
    rowSpacing_ = std::pow(spacing, dimension_) * double(feet.size()) / whole.area;
    if (isMoved) feet = evenLines(opening, geometry, feet, rowSpacing_, spacing);

    cells_.resize(std::size_t(n_[0]) * n_[1]);
    for (const auto& foot : feet)
    {
        const bool isOwn = openOf(opening)(foot, 0);
        cells_[std::size_t(nearestSite(foot))].push_back({foot, isOwn ? int(lines_.size()) : -1});
        if (isOwn) lines_.push_back({foot, 1});
    }
    carried_ = std::pow(spacing, dimension_) * double(lines_.size()) / rowSpacing_;
    if (!opening.developed || lines_.empty()) return;
    const auto isOpen = openOf(opening);
    developProfile([&](const Vector<3>& x) { return isOpen(x, 0); }, isMoved ? finerForProfile : 1, opening.where);
}

/// Places of a square lattice of the spacing, shifted so that they come nearest in number to one for each square of a spacing: rows of particles then stand a spacing
/// apart.
std::vector<Vector<3>> Section::oneToASquare(const Extents& whole, double spacing, const auto& open) const
{
    constexpr int shifts = 4;
    const double wanted = whole.area / std::pow(spacing, dimension_ - 1);
    std::vector<Vector<3>> best;
    for (int shift = 0; shift < (dimension_ == 3 ? shifts * shifts : shifts); ++shift)
    {
        std::vector<Vector<3>> feet;
        const double first = whole.low[0] + (0.5 + shift % shifts) * spacing / shifts,
                     second = dimension_ == 3 ? whole.low[1] + (0.5 + double(shift / shifts)) * spacing / shifts : 0;
        for (double a = first; a < whole.high[0]; a += spacing)
            for (double b = second; dimension_ == 3 ? b < whole.high[1] : b == second; b += spacing)
                if (open(at(a, b), 0)) feet.push_back(at(a, b));
        if (best.empty() || std::abs(double(feet.size()) - wanted) < std::abs(double(best.size()) - wanted)) best = std::move(feet);
    }
    return best;
}

Section::Extents Section::extentsOf(const auto& open, const Geometry& geometry, double spacing) const
{
    // Extents that the domain can hold of the plane, as seen from the opening's point.
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
    const double fine = spacing / samplesPerSpacing;
    /// Length of what is open along across_[0] at b along across_[1]; the middle of the longest stretch is where its end along across_[1] is sought.
    struct Row
    {
        double length = 0, longest = 0, middle = 0;
    };
    Extents all;
    const auto lookAtEdge = [&](const Vector<3>& x, int along)
    { all.walled = all.walled && (repeats_[along] || geometry.distance(x) < onWall * spacing); };
    const auto rowAt = [&](double b)
    {
        Row row;
        eachStretch(
            from[0], to[0], fine, [&](double a) { return open(at(a, b)); },
            [&](double low, double high)
            {
                row.length += high - low;
                if (high - low > row.longest) row = {row.length, high - low, 0.5 * (low + high)};
                all.low[0] = std::min(all.low[0], low);
                all.high[0] = std::max(all.high[0], high);
                lookAtEdge(at(low, b), 0);
                lookAtEdge(at(high, b), 0);
            });
        return row;
    };
    if (dimension_ == 2)
    {
        all.area = rowAt(0).length;
        return all;
    }
    // Rows along across_[0] first find the ends along across_[1], then measure the area between them.
    const int rows = std::max(1, int(std::ceil((to[1] - from[1]) / fine - 1e-6)));
    const double apart = (to[1] - from[1]) / rows;
    for (int k = 0; k < rows; ++k)
    {
        const double b = from[1] + (k + 0.5) * apart;
        const auto row = rowAt(b);
        if (!(row.length > 0)) continue;
        const auto end = [&](double beyond)
        {
            const auto opens = [&](double c) { return open(at(row.middle, c)); };
            const double edge = opens(beyond) ? beyond : edgeBetween(b, beyond, opens);
            if (edge != beyond || beyond == from[1] || beyond == to[1]) lookAtEdge(at(row.middle, edge), 1);
            return edge;
        };
        all.low[1] = std::min(all.low[1], end(std::max(from[1], b - apart)));
        all.high[1] = std::max(all.high[1], end(std::min(to[1], b + apart)));
    }
    if (!(all.high[1] > all.low[1])) return all;
    const int n = std::max(1, int(std::ceil((all.high[1] - all.low[1]) / fine - 1e-6)));
    const double h = (all.high[1] - all.low[1]) / n;
    for (int k = 0; k < n; ++k) all.area += h * rowAt(all.low[1] + (k + 0.5) * h).length;
    return all;
}

double Section::width() const { return dimension_ == 3 ? std::min(width_[0], width_[1]) : width_[0]; }

int Section::nearestSite(const Vector<3>& x) const
{
    int at[2] = {0, 0};
    for (int d = 0; d < dimension_ - 1; ++d)
        at[d] = std::clamp(int(std::floor((dot(x - point_, across_[d]) - low_[d]) / step_[d])), 0, n_[d] - 1);
    return site(at[0], at[1]);
}

Vector<3> Section::centre(int i, int k, int finer) const
{
    return at(low_[0] + (i + 0.5) * step_[0] / finer, dimension_ == 3 ? low_[1] + (k + 0.5) * step_[1] / finer : 0);
}

int Section::site(int i, int k, int finer) const
{
    const int n[2] = {n_[0] * finer, dimension_ == 3 ? n_[1] * finer : 1};
    if (repeats_[0]) i = (i + n[0]) % n[0];
    if (repeats_[1]) k = (k + n[1]) % n[1];
    return i < 0 || k < 0 || i >= n[0] || k >= n[1] ? -1 : i * n[1] + k;
}

int Section::lineAt(const Vector<3>& x) const
{
    int cell[2] = {0, 0};
    for (int d = 0; d < dimension_ - 1; ++d) cell[d] = int(std::floor((dot(x - point_, across_[d]) - low_[d]) / step_[d]));
    if (site(cell[0], cell[1]) < 0) return -1;
    double nearest = Box::infinity;
    int line = -1;
    for (int i = cell[0] - 1; i <= cell[0] + 1; ++i)
        for (int k = cell[1] - 1; k <= cell[1] + 1; ++k)
        {
            const int at = site(i, k);
            if (at < 0) continue;
            for (const auto& of : cells_[std::size_t(at)])
            {
                double square = 0;
                for (int d = 0; d < dimension_ - 1; ++d)
                {
                    double by = dot(x - of.foot, across_[d]);
                    if (const double period = n_[d] * step_[d]; repeats_[d]) by -= period * std::round(by / period);
                    square += by * by;
                }
                if (square >= nearest) continue;
                nearest = square;
                line = of.line;
            }
        }
    return line;
}

void Section::developProfile(const auto& isFluid, int finer, const Location& where)
{
    const int n[2] = {n_[0] * finer, dimension_ == 3 ? n_[1] * finer : 1};
    std::vector<char> fluid;
    for (int i = 0; i < n[0]; ++i)
        for (int k = 0; k < n[1]; ++k) fluid.push_back(isFluid(centre(i, k, finer)));
    const auto fluidAt = [&](int i, int k)
    {
        const int at = site(i, k, finer);
        return at >= 0 && fluid[std::size_t(at)] ? at : -1;
    };
    // Nothing holds the flow back without walls.
    bool walls = false;
    for (int i = -1; i <= n[0]; ++i)
        for (int k = dimension_ == 3 ? -1 : 0; k < (dimension_ == 3 ? n[1] + 1 : 1); ++k) walls = walls || fluidAt(i, k) < 0;
    if (!walls) return;

    // Successive over-relaxation: the lines are few.
    std::vector<double> profile(fluid.size(), 0.0);
    double change = 1, largest = 0;
    for (int sweep = 0; sweep < 100000 && change > 1e-12 * largest; ++sweep)
    {
        change = 0;
        for (int i = 0; i < n[0]; ++i)
            for (int k = 0; k < n[1]; ++k)
            {
                const int self = fluidAt(i, k);
                if (self < 0) continue;
                double sum = 1, diagonal = 0;
                for (int d = 0; d < dimension_ - 1; ++d)
                    for (const int side : {-1, 1})
                    {
                        const int next = d == 0 ? fluidAt(i + side, k) : fluidAt(i, k + side);
                        const double weight = sqr(finer / step_[d]);
                        diagonal += next < 0 ? 2 * weight : weight; // u = -u_i beyond a wall
                        if (next >= 0) sum += weight * profile[std::size_t(next)];
                    }
                double& u = profile[std::size_t(self)];
                const double by = 1.8 * (sum / diagonal - u);
                u += by;
                change = std::max(change, std::abs(by));
                largest = std::max(largest, u);
            }
    }
    if (!(change <= 1e-12 * largest))
        throw CaseError(where, "the profile of developed flow in this section has not converged; take `profile uniform;`");

    // Bilinear between the centres of cells; on a lattice those are the lines.
    double mean = 0;
    for (auto& line : lines_)
    {
        int cell[2] = {0, 0};
        double share[2] = {0, 0};
        for (int d = 0; d < dimension_ - 1; ++d)
        {
            const double at = (dot(line.foot - point_, across_[d]) - low_[d]) * finer / step_[d] - 0.5;
            cell[d] = int(finer == 1 ? std::lround(at) : std::floor(at));
            share[d] = finer == 1 ? 0 : at - cell[d];
        }
        line.profile = 0;
        for (const int i : {0, 1})
            for (const int k : {0, 1})
                if (const int at = fluidAt(cell[0] + i, cell[1] + k); at >= 0)
                    line.profile += (i == 1 ? share[0] : 1 - share[0]) * (k == 1 ? share[1] : 1 - share[1]) * profile[std::size_t(at)];
        mean += line.profile / double(lines_.size());
    }
    for (auto& line : lines_) line.profile /= mean;
}

}
