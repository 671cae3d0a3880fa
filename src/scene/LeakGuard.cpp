#include "scene/LeakGuard.hpp"
#include "base/CaseError.hpp"
#include "geometry/Walls.hpp"
#include "geometry/components.hpp"
#include "geometry/offWalls.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
constexpr double deepestInSpacings = 0.5;

std::string at(const Vector<3>& x) { return fmt::format("({:.6g} {:.6g} {:.6g})", x.x, x.y, x.z); }
}

static const Choice leakedParticles{"leakedParticles",
                                    {{"putBack", "and counted; one half a spacing deep ends the run"},
                                     {"remove", "however deep, and outside the domain; counted with their mass"},
                                     {"stop", "ends the run"}},
                                    "putBack",
                                    "what becomes of particles in a solid"};

EntryList leakGuardEntries() { return {leakedParticles}; }

LeakAction readLeakGuard(const Dictionary& sphSchemes) { return LeakAction(leakedParticles.index(sphSchemes)); }

/// The nearest of places around x, on rings up to half a spacing wide, that lies in the fluid.
template<int dim>
template<class Depth>
std::optional<Vector<dim>> LeakGuard<dim>::nearestWayOut(const Vector<dim>& x, const Depth& depth) const
{
    const int rings = 20;
    for (int ring = 1; ring <= rings; ++ring)
        for (int a = -1; a <= 1; ++a)
            for (int b = -1; b <= 1; ++b)
                for (int c = dim == 3 ? -1 : 0; c <= (dim == 3 ? 1 : 0); ++c)
                {
                    const Vector<3> direction{double(a), double(b), double(c)};
                    if (a == 0 && b == 0 && c == 0) continue;
                    const auto y = x + deepestInSpacings * spacing_ * ring / rings / mag(direction) * in<dim>(direction);
                    if (depth(y) <= -closestInSpacings * spacing_) return y;
                }
    return {};
}

template<int dim>
typename LeakGuard<dim>::Found LeakGuard<dim>::keep(const std::array<double*, dim>& x, const Velocities& velocities, std::size_t i,
                                                    const NearWalls& walls) const
{
    const double closest = closestInSpacings * spacing_;
    Found found;
    for (int c = 0; c < dim; ++c)
    {
        const double low = geometry_.low.*component(c), high = geometry_.high.*component(c);
        if (geometry_.periodic[std::size_t(c)])
        {
            const double L = high - low;
            if (x[c][i] < low && x[c][i] >= low - L) x[c][i] += L;
            if (x[c][i] >= high && x[c][i] < high + L) x[c][i] -= L;
        }
        // One support beyond an open face is left to the walls to judge.
        const double slack = geometry_.periodic[std::size_t(c)] ? 0 : support_;
        found.lost = found.lost || !(x[c][i] >= low - slack && x[c][i] <= high + slack);
    }
    if (found.lost) return found;
    auto x_i = valueAt<Vector<dim>>(x, i);
    bool buried = false;
    double nearest = closest;
    for (const int p : walls.patches(in3D(x_i)))
    {
        if (isBeyond(geometry_.patches[std::size_t(p)].mesh, in3D(x_i), closest)) continue;
        const Foot f = geometry_.foot(p, in3D(x_i));
        nearest = std::min(nearest, f.distance);
        if (-f.distance > std::max(closest, found.depth))
        {
            found.depth = -f.distance;
            found.patch = p;
        }
        if (f.exposure <= 0) buried = buried || f.distance < -closest;
        else if (f.distance < -deepestInSpacings * spacing_)
        {
            found.lost = true;
            return found;
        }
    }
    if (!(nearest < closest)) return found;
    const auto held = offWalls(walls, x_i, {closest}, Box::infinity,
                               [&](const Vector<dim>& n, int)
                               {
                                   for (const auto& v : velocities)
                                       sph::store(withoutInward(valueAt<Vector<dim>>(v, i), n), [&](int c, double q) { v[c][i] = q; });
                               });
    if (!(held == x_i)) sph::store(x_i = held, [&](int c, double q) { x[c][i] = q; });
    // Where solids overlap there may be no surface that leads out.
    const auto depth = [&](const Vector<dim>& y) { return -geometry_.distance(in3D(y)); };
    if (buried && depth(x_i) > closest)
    {
        const auto out = nearestWayOut(x_i, depth);
        found.lost = !out;
        if (out)
        {
            sph::store(*out, [&](int c, double q) { x[c][i] = q; });
            for (const auto& v : velocities)
                for (int c = 0; c < dim; ++c) v[c][i] = 0;
        }
    }
    return found;
}

namespace
{
/// The face of the domain that a place outside lies farthest beyond, in words: " through its face x = 1 m"; nothing of a place inside.
std::string faceBehind(const Geometry& g, const Vector<3>& x)
{
    double farthest = 0;
    std::string face;
    const auto consider = [&](char axis, double q, double low, double high)
    {
        const double beyond = std::max(q - high, low - q);
        if (!(beyond > farthest)) return;
        farthest = beyond;
        face = fmt::format(" through its face {} = {:.6g} m", axis, q > high ? high : low);
    };
    consider('x', x.x, g.low.x, g.high.x);
    consider('y', x.y, g.low.y, g.high.y);
    if (g.dimension == 3) consider('z', x.z, g.low.z, g.high.z);
    return face;
}
}

template<int dim> void LeakGuard<dim>::refuse(std::size_t i, const Vector<3>& x, const Found& found) const
{
    const double d = std::max(found.depth, -geometry_.distance(x));
    const auto wall = found.patch >= 0 ? " " + wallInWords(geometry_, found.patch, x) : "";
    throw CaseError(
        fmt::format("particle {} at {} {}", i, at(x),
                    d > 0 ? fmt::format("is {:.3g} m beyond a wall{}{}", d, wall,
                                        found.lost ? "" : ", and `leakedParticles stop;` of system/sphSchemes lets none be put back")
                          : fmt::format("has left the domain {} {}{}", at(geometry_.low), at(geometry_.high), faceBehind(geometry_, x))));
}

/// Notes the deepest leak; among leaks of the same depth always the same one, whatever their order.
template<int dim> void LeakGuard<dim>::note(const Found& found, const Vector<3>& at)
{
    const auto key = [](const Vector<3>& a) { return std::array{a.x, a.y, a.z}; };
    if (found.depth < leaks_.deepest || (found.depth == leaks_.deepest && leaks_.count() > 0 && key(at) >= key(leaks_.at))) return;
    leaks_.deepest = found.depth;
    leaks_.at = at;
    leaks_.patch = found.patch;
}

template<int dim> std::size_t LeakGuard<dim>::remove(FieldStore<dim>& store, std::size_t owned, std::vector<std::size_t>& which)
{
    if (which.empty()) return owned;
    std::ranges::sort(which);
    const double* const m = store.component(Mass::info.name, 0);
    std::vector<int> kept;
    for (std::size_t i = 0, next = 0; i < owned; ++i)
        if (next < which.size() && which[next] == i)
        {
            leaks_.removedMass += m[i];
            ++next;
        }
        else kept.push_back(int(i));
    store.sortState(kept);
    store.resize(kept.size());
    return kept.size();
}

template<int dim> std::size_t LeakGuard<dim>::operator()(FieldStore<dim>& store, std::size_t owned, const NearWalls& walls)
{
    const std::array<double*, dim> x = store.pointers(Position{});
    // Between prediction and correction the velocity at the start of the step counts: the correction begins from it.
    Velocities velocities{store.pointers(Velocity{})};
    if (const std::string start = std::string(Velocity::info.name) + "_0"; store.has(start))
        velocities.push_back(store.template pointers<Velocity>(start));
    const auto place = [&](std::size_t i) { return in3D(valueAt<Vector<dim>>(x, i)); };
    std::size_t first = owned;
    Found worst;
    std::vector<std::size_t> removed;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < owned; ++i)
    {
        const Vector<3> before = action_ == LeakAction::putBack ? Vector<3>{} : place(i);
        const Found found = keep(x, velocities, i, walls);
        if (!found.lost && found.depth == 0) continue;
#pragma omp critical
        {
            if (action_ == LeakAction::remove && std::isfinite(mag(before)))
            {
                note(found, before);
                ++leaks_.removed;
                removed.push_back(i);
            }
            else if (found.lost || action_ == LeakAction::stop)
            {
                if (i < first)
                {
                    first = i;
                    worst = found;
                    if (action_ == LeakAction::stop && !found.lost)
                        sph::store(in<dim>(before), [&](int c, double q) { x[std::size_t(c)][i] = q; });
                }
            }
            else
            {
                note(found, place(i));
                ++leaks_.putBack;
            }
        }
    }
    if (first < owned) refuse(first, place(first), worst);
    return remove(store, owned, removed);
}

template class LeakGuard<2>;
template class LeakGuard<3>;

}
