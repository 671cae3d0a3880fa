#include "geometry/makeWallLayers.hpp"
#include "geometry/components.hpp"
#include "geometry/forEachFoot.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>

namespace sph
{

namespace entry
{
const Choice wallKind{"walls",
                      {{"reflected", "fluid mirrored at the wall"}, {"layers", "layers of particles in the solid"}},
                      "reflected",
                      "how walls act on the fluid"};
}

namespace
{
/// Evenly spaced places along one direction.
struct Row
{
    double first = 0, step = 1;
    long n = 1;
    double at(long k) const { return first + k * step; }
};

/// Fills walls with particles.
class Layering
{
    const Geometry& g_;
    double H_, spacing_, margin_; ///< margin: beyond faces of the domain that are not periodic
    double cell_ = 1;             ///< of the fluid's lattice [m^dim]
    std::vector<LayerParticle> particles_;
    std::vector<std::size_t> bisectors_; ///< particles that lie as deep behind two surfaces: each makes them, one is taken

    bool isFlat(int c) const { return c == 2 && g_.dimension == 2; }

    /// The layers of the domain's lattice, stretched a little so that a whole number fits.
    Row across(int c) const
    {
        if (isFlat(c)) return {};
        const double L = g_.length(c), low = g_.low.*component(c);
        const long n = std::max(1l, std::lround(L / spacing_));
        const double step = L / double(n);
        const long more = g_.periodic[c] ? 0 : long(std::ceil(margin_ / step));
        return {low + (0.5 - double(more)) * step, step, n + 2 * more};
    }
    /// A row of places: from face to face of a box, from the one face that is within sight of the domain, or the domain's layers.
    Row along(int c, double low, double high) const
    {
        const Row all = across(c);
        const double first = all.first - 0.5 * all.step, last = first + double(all.n) * all.step;
        if (g_.periodic[c] ? std::isfinite(high - low) : low >= first && high <= last) return between(low, high, spacing_);
        if (g_.periodic[c]) return all;
        if (low >= first) return {low + 0.5 * all.step, all.step, std::max(0l, std::lround(std::ceil((last - low) / all.step)))};
        if (high > last) return all;
        const long n = std::max(0l, std::lround(std::ceil((high - first) / all.step)));
        return {high - (double(n) - 0.5) * all.step, all.step, n};
    }
    static Row between(double low, double high, double spacing)
    {
        const long n = std::max(1l, std::lround((high - low) / spacing));
        const double step = (high - low) / double(n);
        return {low + 0.5 * step, step, n};
    }

    /// Takes a place `depth` behind the patch unless it lies deeper behind another, or is taken.
    void add(const Patch& patch, Vector<3> x, double depth, double volume)
    {
        const double slack = 1e-6 * spacing_;
        for (int c = 0; c < g_.dimension; ++c)
        {
            const auto k = component(c);
            if (g_.periodic[c]) x.*k -= g_.length(c) * std::floor((x.*k - g_.low.*k) / g_.length(c));
            else if (x.*k < g_.low.*k - margin_ || x.*k > g_.high.*k + margin_) return;
        }
        int asDeep = 0; // the patch itself, or its periodic copy, and those that the place lies on the bisector with
        bool liesDeeper = false;
        forEachFootAlone(g_, x, slack,
                         [&](const Foot& foot, int)
                         {
                             asDeep += std::abs(-foot.distance - depth) <= slack;
                             liesDeeper = liesDeeper || -foot.distance > depth + slack;
                         });
        if (liesDeeper) return;
        if (asDeep > 1)
        {
            for (const auto k : bisectors_)
                if (mag(particles_[k].x - x) < 0.25 * spacing_) return;
            bisectors_.push_back(particles_.size());
        }
        particles_.push_back({x, volume / cell_, patch.wall});
    }

    /// Calls f(k, depth, thickness) for the layers behind a surface. `radius`: depth of the solid at most.
    void layers(double thickness, double radius, const std::function<void(long, double, double)>& f) const
    {
        if (radius < H_ + 0.5 * thickness) thickness = radius / std::floor(radius / thickness);
        for (long k = 0; (double(k) + 0.5) * thickness < std::min(H_, radius); ++k) f(k, (double(k) + 0.5) * thickness, thickness);
    }

    void fillPlane(const Patch& patch, Vector<3> point, Vector<3> n)
    {
        // Two directions along the plane: coordinate directions where it runs along them, whose layers are the domain's.
        int along = -1, normal = -1;
        for (int c = 0; c < 3; ++c)
        {
            if (std::abs((n.*component(c))) == 1) normal = c;
            if (std::abs((n.*component(c))) < 1e-12) along = c;
        }
        std::array<Vector<3>, 2> e;
        std::array<Row, 2> rows;
        double thickness = spacing_;
        const auto unit = [](int c)
        {
            Vector<3> q;
            q.*component(c) = 1;
            return q;
        };
        const auto extent = [&](Vector<3> direction)
        {
            double low = Box::infinity, high = -low;
            for (int corner = 0; corner < 8; ++corner)
            {
                Vector<3> x;
                for (int c = 0; c < 3; ++c)
                    x.*component(c) = isFlat(c) ? 0 : corner >> c & 1 ? g_.high.*component(c) + margin_ : g_.low.*component(c) - margin_;
                low = std::min(low, dot(x - point, direction));
                high = std::max(high, dot(x - point, direction));
            }
            return Row{spacing_ * (std::floor(low / spacing_) + 0.5), spacing_, std::lround(std::ceil((high - low) / spacing_)) + 1};
        };
        if (normal >= 0)
        {
            const int a = (normal + 1) % 3, b = (normal + 2) % 3;
            e = {unit(a), unit(b)};
            rows = {across(a), across(b)};
            thickness = across(normal).step;
        }
        else if (along >= 0)
        {
            e = {unit(along), cross(n, unit(along))};
            rows = {across(along), extent(e[1])};
        }
        else
        {
            e = crossSection(n);
            rows = {extent(e[0]), extent(e[1])};
        }
        // Rows of the domain count from its origin, others from the plane's point.
        for (int k = 0; k < 2; ++k)
            if (normal >= 0 || (along >= 0 && k == 0)) rows[k].first -= dot(point, e[k]);
        layers(thickness, Box::infinity,
               [&](long, double depth, double h)
               {
                   for (long a = 0; a < rows[0].n; ++a)
                       for (long b = 0; b < rows[1].n; ++b)
                           add(patch, point + rows[0].at(a) * e[0] + rows[1].at(b) * e[1] - depth * n, depth,
                               rows[0].step * rows[1].step * h);
               });
    }

    void fillBox(const Patch& patch, Vector<3> low, Vector<3> high, const Location& where, Diagnostics& diagnostics)
    {
        std::array<Row, 3> row;
        double volume = 1;
        for (int c = 0; c < 3; ++c)
        {
            const double a = low.*component(c), b = high.*component(c);
            if (isFlat(c)) continue;
            if (b - a < 2 * H_)
                diagnostics.error(
                    where, fmt::format("the box is {:.4g} m thick, less than two kernel supports, {:.4g} m: layers of particles behind its "
                                       "faces overlap. Refine, or take `walls reflected;`",
                                       b - a, 2 * H_));
            row[c] = along(c, a, b);
            volume *= row[c].step;
        }
        for (long i = 0; i < row[0].n; ++i)
            for (long j = 0; j < row[1].n; ++j)
                for (long k = 0; k < row[2].n; ++k)
                {
                    const Vector<3> x{row[0].at(i), row[1].at(j), row[2].at(k)};
                    if (const double depth = -patch.shape->foot(x).distance; depth > 0 && depth < H_) add(patch, x, depth, volume);
                }
    }

    void fillCylinder(const Patch& patch, Vector<3> point, Vector<3> axis, double R, FluidSide fluid)
    {
        const auto [e1, e2] = crossSection(axis);
        int along = -1;
        for (int c = 0; c < 3; ++c)
            if (std::abs((axis.*component(c))) == 1) along = c;
        Row row{};
        if (along >= 0)
        {
            row = across(along);
            point.*component(along) = 0;
            if (axis.*component(along) < 0) row = {-row.at(row.n - 1), row.step, row.n};
        }
        else
        {
            const double reach = mag(g_.high - g_.low) + margin_;
            const double middle = dot(0.5 * (g_.low + g_.high) - point, axis);
            row = between(middle - reach, middle + reach, spacing_);
        }
        const bool inside = fluid == FluidSide::inside;
        layers(spacing_, inside ? Box::infinity : R,
               [&](long layer, double depth, double h)
               {
                   const double r = inside ? R + depth : R - depth, length = 2 * std::numbers::pi * r;
                   const long n = std::max(1l, std::lround(length / spacing_));
                   for (long k = 0; k < row.n; ++k)
                       for (long q = 0; q < n; ++q)
                       {
                           const double angle = 2 * std::numbers::pi * (double(q) + 0.5 * double((layer + k) % 2)) / double(n);
                           add(patch, point + row.at(k) * axis + r * std::cos(angle) * e1 + r * std::sin(angle) * e2, depth,
                               length * h / double(n) * (isFlat(2) ? 1 : row.step));
                       }
               });
    }

    /// Shells of points on a spiral from pole to pole, each of the same area (Saff & Kuijlaars 1997; Fibonacci's angle).
    void fillSphere(const Patch& patch, Vector<3> centre, double R, FluidSide fluid)
    {
        if (g_.dimension == 2) return fillCylinder(patch, centre, {0, 0, 1}, R, fluid);
        const bool inside = fluid == FluidSide::inside;
        const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
        layers(spacing_, inside ? Box::infinity : R,
               [&](long layer, double depth, double h)
               {
                   const double r = inside ? R + depth : R - depth;
                   const double shell = 4 * std::numbers::pi / 3 * (std::pow(r + 0.5 * h, 3) - std::pow(r - 0.5 * h, 3));
                   const long n = std::max(1l, std::lround(4 * std::numbers::pi * sqr(r / spacing_)));
                   for (long q = 0; q < n; ++q)
                   {
                       const double z = 1 - (2 * double(q) + 1) / double(n), s = std::sqrt(1 - z * z),
                                    angle = turn * double(q) + double(layer);
                       add(patch, centre + r * Vector<3>{s * std::cos(angle), s * std::sin(angle), z}, depth, shell / double(n));
                   }
               });
    }

public:
    Layering(const Geometry& g, double H, double spacing) : g_(g), H_(H), spacing_(spacing), margin_(H + spacing)
    {
        for (int c = 0; c < g.dimension; ++c) cell_ *= across(c).step;
    }

    void fill(const Patch& patch, Diagnostics& diagnostics)
    {
        const auto d = patch.shape->description();
        const auto vector = [&](const char* key)
        { return std::find_if(d.vectors.begin(), d.vectors.end(), [&](const auto& entry) { return entry.first == key; })->second; };
        const auto& where = g_.walls[std::size_t(patch.wall)].where;
        if (d.type == "plane") fillPlane(patch, vector("point"), vector("normal"));
        else if (d.type == "box") fillBox(patch, vector("min"), vector("max"), where, diagnostics);
        else if (d.type == "cylinder") fillCylinder(patch, vector("point"), vector("axis"), d.scalars[0].second, d.fluid);
        else if (d.type == "sphere") fillSphere(patch, vector("centre"), d.scalars[0].second, d.fluid);
        else
            diagnostics.error(where,
                              fmt::format("there are no layers of particles behind a {}: they are made of planes, boxes, cylinders and "
                                          "spheres. Take `walls reflected;` in system/sphSchemes",
                                          d.type));
    }
    std::vector<LayerParticle> particles() { return std::move(particles_); }
};
}

bool wallsAreLayers(const Dictionary& sphSchemes) { return entry::wallKind(sphSchemes) == "layers"; }
EntryList wallLayersEntries() { return {entry::wallKind}; }

std::vector<LayerParticle> makeWallLayers(const Geometry& g, double H, double spacing, Diagnostics& diagnostics)
{
    Layering layering(g, H, spacing);
    for (const auto& original : g.originals)
    {
        // A box that stands on a plane is filled as deep as it has been sunk into it.
        const auto given = original.shape->bounds();
        const auto sunk =
            std::find_if(g.patches.begin(), g.patches.end(),
                         [&](const Patch& p)
                         {
                             const auto b = p.shape->bounds();
                             return p.wall == original.wall && original.shape->hasEdges() && p.shape != original.shape &&
                                    std::all_of(std::begin(coordinates), std::end(coordinates),
                                                [&](auto c) { return b.low.*c <= given.low.*c && b.high.*c >= given.high.*c; });
                         });
        layering.fill(sunk != g.patches.end() ? *sunk : original, diagnostics);
    }
    return layering.particles();
}

}
