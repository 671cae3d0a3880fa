#include "geometry/GeometryCheck.hpp"
#include "geometry/MovingWalls.hpp"
#include "geometry/ShapeOfRow.hpp"
#include "geometry/TriangleMesh.hpp"
#include "geometry/closestApproach.hpp"
#include "geometry/components.hpp"
#include "geometry/fluidFraction.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace sph
{

namespace
{

std::string text(const Geometry& g, const Vector<3>& x)
{
    return g.dimension == 3 ? fmt::format("({:.6g} {:.6g} {:.6g})", x.x, x.y, x.z) : fmt::format("({:.6g} {:.6g})", x.x, x.y);
}

/// Share of a diameter by which balls that touch may overlap: packers leave a hundredth.
constexpr double mostOverlap = 0.1;

class Check
{
    const Geometry& g_;
    const double H_, tolerance_;
    Diagnostics& diagnostics_;
    Box domain_;
    std::map<int, TriangleSurface> samples_;

    /// Overlaps of all shapes of two walls, with the sharpest wedge among them.
    struct Overlap
    {
        int count = 0;
        double wedge = 180, overlap = 0;
        Vector<3> at;
        bool ofBody = false;
        std::vector<std::pair<double, std::string>> rows; ///< wedge, and the rows of tables that the two shapes stand in, where they do
    };
    std::map<std::pair<int, int>, Overlap> overlaps_;

    /// Balls of tables that reach into one another by more than a contact without a sharp wedge of fluid: parts of one grain, or a mistake of the table.
    struct Merged
    {
        double overlap = 0;                               ///< largest, over the smaller diameter
        std::vector<std::pair<double, std::string>> rows; ///< minus the overlap, and the rows
    };
    std::map<int, Merged> merged_; ///< by the wall of the later ball

    /// Balls that are there twice, with their rows of tables or their walls; periodic copies are of the same.
    struct Twice
    {
        Vector<3> at; ///< of the first
        std::set<std::string> which;
    };
    std::map<int, Twice> twice_; ///< by the wall of the later ball
    GeometryReport report_;

    const TriangleSurface& samples(int patch)
    {
        const auto found = samples_.find(patch);
        if (found != samples_.end()) return found->second;
        return samples_[patch] = triangulate(*g_.patches[patch].shape, domain_, 0.5 * H_);
    }

    /// Bodies that no fluid can touch are mistakes.
    void describeExtent(int w)
    {
        bool any = false, isOutside = true, isHidden = true;
        for (int p = 0; p < int(g_.patches.size()); ++p)
        {
            const auto& shape = *g_.patches[p].shape;
            if (g_.patches[p].wall != w) continue;
            if (shape.enclosesFluid()) return;
            any = true;
            isOutside = isOutside && shape.distanceTo(domain_) > tolerance_;
            isHidden = isHidden && g_.mayBeCovered(p) && isInOthers(p);
        }
        if (!any) return;
        const auto& wall = g_.walls[w];
        if (isOutside)
            diagnostics_.error(wall.where, fmt::format("wall \"{}\" lies outside the domain {} {}: no fluid can reach it", wall.name,
                                                       text(g_, g_.low), text(g_, g_.high)));
        else if (isHidden)
            diagnostics_.error(wall.where,
                               fmt::format("wall \"{}\" lies in other walls, where no fluid can reach it: leave it out", wall.name));
    }

    bool isInOthers(int patch)
    {
        const auto& points = samples(patch).points;
        return std::all_of(points.begin(), points.end(), [&](const auto& x) { return g_.isCovered(patch, x); });
    }

    void describe()
    {
        for (std::size_t w = 0; w < g_.walls.size(); ++w)
        {
            std::set<std::string> types, sides;
            for (const auto& p : g_.originals)
            {
                if (p.wall != int(w)) continue;
                const auto d = p.shape->description();
                types.insert(d.type);
                sides.insert(!d.hasSide ? "normal" : d.fluid == FluidSide::inside ? "inside" : "outside");
                ++report_.walls[w].shapes;
            }
            const auto joined = [](const std::set<std::string>& words)
            {
                std::string all;
                for (const auto& word : words) all += (all.empty() ? "" : ",") + word;
                return all;
            };
            report_.walls[w].type = joined(types);
            report_.walls[w].fluid = joined(sides);
        }
        for (std::size_t w = 0; w < g_.walls.size(); ++w) describeExtent(int(w));
        for (std::size_t w = 0; w < g_.walls.size(); ++w)
            if (std::none_of(g_.patches.begin(), g_.patches.end(), [&](const Patch& p) { return p.wall == int(w); }) &&
                report_.walls[w].shapes > 0)
                diagnostics_.error(g_.walls[w].where, fmt::format("wall \"{}\" coincides with walls given before, or lies out of reach of "
                                                                  "the domain",
                                                                  g_.walls[w].name));
    }

    /// A shape whose tightest curve is wide enough needs no search; the others are looked at where the fluid touches them.
    void curvature()
    {
        for (int p = 0; p < int(g_.patches.size()); ++p)
        {
            const auto& shape = *g_.patches[p].shape;
            if (g_.patches[p].mesh) continue; // its facets need no radius
            auto& wall = report_.walls[g_.patches[p].wall];
            const auto note = [&](double radius, const Vector<3>& at)
            {
                if (!(radius < wall.smallestRadius)) return;
                wall.smallestRadius = radius;
                wall.smallestRadiusAt = at;
            };
            if (shape.smallestRadius() > H_)
            {
                note(shape.smallestRadius(), {});
                continue;
            }
            for (const auto& x : samples(p).points)
            {
                const auto f = shape.foot(x);
                // A little way into the fluid, where no other wall may be.
                if (g_.inFluid(x + 10 * tolerance_ * f.normal)) note(1 / std::max(std::abs(f.k1), std::abs(f.k2)), x);
            }
        }
        for (std::size_t w = 0; w < g_.walls.size(); ++w)
            if (const auto& wall = report_.walls[w]; wall.smallestRadius <= H_)
                diagnostics_.error(
                    g_.walls[w].where,
                    fmt::format("wall \"{}\" curves with a radius of {:.4g} m at {}, less than the kernel support {:.4g} m: "
                                "reflection needs more. Make the spacing less than {:.3g} of what it is, or the wall rounder",
                                g_.walls[w].name, wall.smallestRadius, text(g_, wall.smallestRadiusAt), H_, wall.smallestRadius / H_));
    }

    /// True where no fluid touches the face of a box that looks along `normal`: all of it lies in other solids, or outside the domain.
    bool isHidden(int patch, double Vector<3>::*normal, double level, double side)
    {
        const auto& points = samples(patch).points;
        return std::all_of(points.begin(), points.end(),
                           [&](auto x)
                           {
                               if (std::abs(x.*normal - level) > tolerance_) return true;
                               x.*normal += side * 10 * tolerance_;
                               return g_.foot(patch, x).exposure == 0;
                           });
    }

    /// The images of the fluid on one side of a plate must not reach the fluid on the other: each lie as deep as the support, and are seen from as far.
    void thickness()
    {
        std::set<int> refused; // copies of one box are as thin
        for (std::size_t k = 0; k < g_.patches.size(); ++k)
        {
            const auto& p = g_.patches[k];
            const auto d = p.shape->description();
            if (d.type != "box" || d.fluid == FluidSide::inside) continue;
            if (refused.contains(p.wall)) continue;
            double thinnest = Box::infinity;
            for (int direction = 0; direction < g_.dimension; ++direction)
            {
                const auto c = component(direction);
                const double low = d.vectors[0].second.*c, high = d.vectors[1].second.*c;
                if (high - low >= std::min(thinnest, 2 * H_)) continue;
                if (g_.mayBeCovered(int(k)) && (isHidden(int(k), c, low, -1) || isHidden(int(k), c, high, 1))) continue;
                thinnest = high - low;
            }
            if (thinnest >= 2 * H_ * (1 - 1e-12)) continue;
            refused.insert(p.wall);
            {
                diagnostics_.error(
                    g_.walls[p.wall].where,
                    fmt::format("wall \"{}\" is {:.4g} m thin, less than twice the kernel support {:.4g} m: the images of the fluid on one "
                                "side would reach the other. Make the spacing less than {:.3g} of what it is, or the wall thicker",
                                g_.walls[p.wall].name, thinnest, H_, thinnest / (2 * H_)));
            }
        }
    }

    /// Whether a wall may go where its velocity leads (MovingWalls.hpp): what it covers of others, and its periodic copies, are those of the start.
    bool mayGo(int p) const
    {
        const auto& v = g_.walls[std::size_t(g_.patches[std::size_t(p)].wall)].heading();
        bool leaves = false;
        for (int k = 0; k < g_.dimension; ++k) leaves = leaves || (g_.periodic[std::size_t(k)] && v.*component(k) != 0);
        const auto& patch = g_.patches[std::size_t(p)];
        return movesAcross(g_, patch) && !g_.mayBeCovered(p) && !(leaves && patch.shape->description().hasSide);
    }

    /// All other walls stay where they are while the fluid moves: their velocity may only be along themselves.
    void motion()
    {
        for (int p = 0; p < int(g_.patches.size()); ++p)
        {
            const int w = g_.patches[p].wall;
            if (const auto& wall = g_.walls[w]; wall.load)
            {
                if (!mayGo(p))
                    diagnostics_.error(
                        wall.where,
                        fmt::format(
                            "wall \"{}\" is under load, and cannot go along ({:.4g} {:.4g} {:.4g}): walls that touch another solid, "
                            "turn, would leave by a periodic face or are planes along that direction stay where they are",
                            wall.name, wall.load->direction.x, wall.load->direction.y, wall.load->direction.z));
                continue;
            }
            if (g_.patches[p].mesh)
            {
                motionOfMesh(g_.patches[p]);
                continue;
            }
            if (g_.walls[w].velocity == Vector<3>{} && g_.walls[w].omega == Vector<3>{}) continue;
            if (mayGo(p)) continue;
            Vector<3> worst;
            double fastest = 0, into = 0;
            for (const auto& x : samples(p).points)
            {
                const auto v = g_.wallVelocity(w, x);
                fastest = std::max(fastest, mag(v));
                const double normal = std::abs(dot(v, g_.patches[p].shape->foot(x).normal));
                if (normal <= into) continue;
                into = normal;
                worst = x;
            }
            if (into > slidingTolerance * fastest) movesThroughItself(w, into, worst);
        }
    }

    void movesThroughItself(int w, double into, const Vector<3>& at)
    {
        diagnostics_.error(
            g_.walls[w].where,
            fmt::format(
                "wall \"{}\" is to move through its own surface, with {:.4g} m/s at {}: walls that touch another solid, turn, are meshes or "
                "would leave by a periodic face stay where they are, and a velocity only along them, as of a belt or a shaft, is possible",
                g_.walls[w].name, into, text(g_, at)));
    }

    /// Facets stand for a curved surface: each may be turned against it by half an edge.
    void motionOfMesh(const Patch& patch)
    {
        const auto& body = patch.mesh->body();
        std::map<int, std::pair<double, Vector<3>>> worst; // of each wall, share of its speed
        for (const auto& f : body.facets())
        {
            const int w = patch.wallAt(f.region);
            Vector<3> middle;
            for (const int p : f.points) middle += body.points()[std::size_t(p)] / 3;
            const auto x = middle - patch.mesh->local({});
            const auto v = g_.wallVelocity(w, x);
            const double through = std::abs(dot(v, f.normal));
            const double allowed = std::max(slidingTolerance, f.planar ? 0.0 : std::sin(body.mostTurned())) * mag(v);
            if (auto& most = worst[w]; through > allowed && through > most.first) most = {through, x};
        }
        for (const auto& [w, found] : worst)
            if (found.first > 0) movesThroughItself(w, found.first, found.second);
    }

    /// Whether x lies in the domain, and not on a far side that repeats the near one.
    bool isOnce(const Vector<3>& x) const
    {
        for (int k = 0; k < g_.dimension; ++k)
        {
            const auto c = component(k);
            const double slack = 1e-9 * g_.length(k);
            if (x.*c < g_.low.*c - slack || x.*c > g_.high.*c + (g_.periodic[k] ? -slack : slack)) return false;
        }
        return true;
    }

    /// The rows of tables that two shapes stand in; empty where neither is of a table.
    static std::string rowsOf(const Shape& a, const Shape& b)
    {
        const auto *first = rowOf(a), *second = rowOf(b);
        if (first && second) return first->inWordsWith(*second);
        return first ? first->inWords() : second ? second->inWords() : "";
    }

    /// The first of them, the most severe.
    static std::string named(std::vector<std::pair<double, std::string>> rows)
    {
        constexpr std::size_t most = 5;
        std::ranges::sort(rows);
        std::string text;
        for (std::size_t k = 0; k < std::min(most, rows.size()); ++k) text += (k > 0 ? ", " : "") + rows[k].second;
        return rows.size() > most ? fmt::format("{} and {} more", text, rows.size() - most) : text;
    }

    void pair(int p, int q)
    {
        if (g_.patches[p].mesh || g_.patches[q].mesh) return; // what meets at any angle, and its gaps are in the mesh's own report
        const auto &a = *g_.patches[p].shape, &b = *g_.patches[q].shape;
        static const TriangleSurface none;
        const bool bothBalls = isBall(a, g_.dimension) && isBall(b, g_.dimension);
        const auto approach = closestApproach(a, b, g_, bothBalls ? none : samples(p), 0.5 * H_);
        const int wallA = g_.patches[p].wall, wallB = g_.patches[q].wall;

        const auto isContact = [&]
        {
            ++report_.contacts;
            ++report_.walls[wallA].contacts;
            if (wallA != wallB) ++report_.walls[wallB].contacts;
        };
        if (approach.same)
        {
            auto& twice = twice_[std::max(wallA, wallB)];
            if (twice.which.empty()) twice.at = approach.at;
            const auto rows = rowsOf(a, b);
            twice.which.insert(rows.empty() ? fmt::format("walls \"{}\" and \"{}\"", g_.walls[std::min(wallA, wallB)].name,
                                                          g_.walls[std::max(wallA, wallB)].name)
                                            : rows);
            return;
        }
        if (approach.crossing && approach.wedge < 89 && (!bothBalls || isOnce(approach.at)))
        {
            if (approach.overlap > 0 && approach.overlap <= mostOverlap)
            {
                if (approach.overlap > report_.overlap)
                {
                    report_.overlap = approach.overlap;
                    report_.overlapAt = approach.at;
                }
                return isContact();
            }
            auto& overlap = overlaps_[{std::min(wallA, wallB), std::max(wallA, wallB)}];
            ++overlap.count;
            if (const auto rows = rowsOf(a, b); !rows.empty()) overlap.rows.emplace_back(approach.wedge, rows);
            overlap.ofBody = overlap.ofBody || !a.enclosesFluid() || !b.enclosesFluid();
            if (approach.wedge < overlap.wedge)
            {
                overlap.wedge = approach.wedge;
                overlap.overlap = approach.overlap;
                overlap.at = approach.at;
            }
            return;
        }
        if (const auto rows = rowsOf(a, b); bothBalls && approach.overlap > mostOverlap && !rows.empty() && isOnce(approach.at))
        {
            auto& merged = merged_[std::max(wallA, wallB)];
            merged.overlap = std::max(merged.overlap, approach.overlap);
            merged.rows.emplace_back(-approach.overlap, rows);
            return;
        }
        if (approach.crossing || !approach.facing || approach.distance < -tolerance_ || !isOnce(approach.at)) return;
        if (approach.distance <= tolerance_) return isContact();
        if (!g_.inFluid(approach.at)) return;
        const auto note = [&](int wall, int other)
        {
            auto& gap = report_.walls[wall].narrowest;
            if (approach.distance < gap.width) gap = {approach.distance, approach.at, other};
        };
        note(wallA, wallB);
        note(wallB, wallA);
    }

    void pairs()
    {
        // Swept along x: only pairs whose bounds are within two supports of each other.
        const double near = 2 * H_;
        const int n = int(g_.patches.size());
        std::vector<Box> bounds(n);
        std::vector<int> order(n);
        for (int p = 0; p < n; ++p)
        {
            bounds[p] = g_.patches[p].shape->bounds();
            order[p] = p;
        }
        std::sort(order.begin(), order.end(), [&](int p, int q) { return bounds[p].low.x < bounds[q].low.x; });
        for (int i = 0; i < n; ++i)
            for (int k = i + 1; k < n; ++k)
            {
                const auto &a = bounds[order[i]], &b = bounds[order[k]];
                if (b.low.x > a.high.x + near) break;
                if (a.low.y > b.high.y + near || b.low.y > a.high.y + near || a.low.z > b.high.z + near || b.low.z > a.high.z + near)
                    continue;
                // The samples lie on the smaller one.
                const auto extent = [](const Box& box) { return mag(box.high - box.low); };
                if (extent(a) <= extent(b)) pair(order[i], order[k]);
                else pair(order[k], order[i]);
            }
        reportOverlaps();
        reportGaps();
    }

    void reportOverlaps()
    {
        for (const auto& [between, overlap] : overlaps_)
        {
            const auto& last = g_.walls[between.second];
            const auto what =
                fmt::format("wall \"{}\" and wall \"{}\" overlap{} near {}{} and leave a wedge of fluid of {:.0f} degrees: reflection "
                            "needs 90 or more. Let them touch, or keep them apart",
                            g_.walls[between.first].name, last.name,
                            overlap.count > 1 ? fmt::format(" in {} places, most sharply", overlap.count) : "", text(g_, overlap.at),
                            overlap.overlap > 0
                                ? fmt::format(", by {:.2g} of the smaller diameter ({} is the most that counts as a contact),",
                                              overlap.overlap, mostOverlap)
                                : "",
                            overlap.wedge) +
                (overlap.rows.empty() ? "" : ": " + named(overlap.rows));
            if (overlap.ofBody) diagnostics_.error(last.where, what);
            else diagnostics_.warning(last.where, what);
        }
        for (const auto& [wall, twice] : twice_)
        {
            std::vector<std::pair<double, std::string>> which;
            for (const auto& w : twice.which) which.emplace_back(0, w);
            diagnostics_.error(
                g_.walls[wall].where,
                fmt::format("wall \"{}\" has what is already there, in one place and of one radius to a thousandth, at {}: {}{}",
                            g_.walls[wall].name, text(g_, twice.at), named(which),
                            g_.periodic[0] || g_.periodic[1] || g_.periodic[2]
                                ? ". Copies behind periodic faces are made from the ones before them"
                                : ""));
        }
        for (const auto& [wall, merged] : merged_)
            diagnostics_.warning(
                g_.walls[wall].where,
                fmt::format("spheres of wall \"{}\" reach into others by up to {:.2g} of the smaller diameter, which leaves no sharp "
                            "wedge of fluid: are they parts of one grain? {}",
                            g_.walls[wall].name, merged.overlap, named(merged.rows)));
    }

    void reportGaps()
    {
        for (std::size_t w = 0; w < g_.walls.size(); ++w)
            if (const auto& gap = report_.walls[w].narrowest; gap.width < H_ && gap.wall >= int(w))
                diagnostics_.warning(g_.walls[w].where,
                                     fmt::format("the gap between \"{}\" and \"{}\" narrows to {:.4g} m, {:.2g} of the kernel "
                                                 "support, at {}: the flow through it is not resolved",
                                                 g_.walls[w].name, g_.walls[gap.wall].name, gap.width, gap.width / H_, text(g_, gap.at)));
    }

    /// The standard error of random points is reported as a bound of the error.
    void volume()
    {
        const int n = 100000;
        const double f = fluidFraction(g_, n);
        report_.fluidFraction = f;
        report_.fluidFractionError = std::sqrt(f * (1 - f) / n);
        if (f > 0 || g_.walls.empty()) return;
        std::set<int> bodies;
        for (const auto& p : g_.patches)
            if (!p.shape->enclosesFluid()) bodies.insert(p.wall);
        std::string names;
        for (const int w : bodies) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", g_.walls[w].name);
        diagnostics_.error(g_.walls[bodies.empty() ? 0 : *bodies.begin()].where,
                           "the walls leave no fluid in the domain: see on which side of each the fluid is" +
                               (names.empty() ? "" : ", and how much of it the solids take: " + names));
    }

public:
    Check(const Geometry& g, double H, Diagnostics& diagnostics)
        : g_(g), H_(H), tolerance_(g.tolerance()), diagnostics_(diagnostics), domain_{g.low, g.high}
    {
        if (g.dimension == 2)
        {
            domain_.low.z = -0.5 * H;
            domain_.high.z = 0.5 * H;
        }
        report_.walls.resize(g.walls.size());
    }

    GeometryReport operator()()
    {
        describe();
        volume();
        curvature();
        thickness();
        motion();
        pairs();
        return report_;
    }
};

}

GeometryReport checkGeometry(const Geometry& g, double H, Diagnostics& diagnostics) { return Check(g, H, diagnostics)(); }

}
