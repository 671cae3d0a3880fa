#include "sampling/SurfaceIntegral.hpp"
#include "geometry/wallNames.hpp"
#include "parallel/reduce.hpp"
#include "sampling/Interpolator.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/readBox.hpp"
#include "sampling/sharedEntries.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Word wallOfIntegral{"wall", required, "wall of constant/geometry that the integral is over"};
const Word phaseOfIntegral{"phase", byScene("all"), "its particles alone carry the value to the wall"};
const Text integrand{"value", required, "expression f of fields, position, time and constants"};
const SubDictionary regionOfIntegral{"region", byScene("all of the wall"), "the part of the wall within this box"};
}

namespace column
{
const Column area{"area", "m^2", "of the wall, without what lies in another solid; in 2-D a length [m]"},
    integral{"integral", "of the expression, m^2", "of f over the area"},
    forceOnSurface{"force", "N", "-int f n dA, that of a pressure f on the wall; in 2-D [N/m]"},
    torque{"torque", "N m", "-int (x - origin) x f n dA; in 2-D [N]"};
const std::vector<Column> ofIntegral{area, integral, forceOnSurface, torque};
}

namespace
{

std::size_t indexAmong(const Word& entry, const Dictionary& d, const std::vector<std::string>& words)
{
    return std::size_t(std::ranges::find(words, entry.among(d, words)) - words.begin());
}

}

SurfaceIntegral::Sum& SurfaceIntegral::Sum::operator+=(const Sum& other)
{
    area += other.area;
    integral += other.integral;
    force += other.force;
    torque += other.torque;
    return *this;
}

SurfaceIntegral::SurfaceIntegral(const Dictionary& d, const FunctionContext& context)
    : context_(context),
      wall_(indexAmong(entry::wallOfIntegral, d, wallNames(context.geometry))),
      value_(entry::integrand, d, entry::integrand(d)),
      region_(readBox(entry::regionOfIntegral(d), context.geometry)),
      origin_(entry::origin(d))
{
    if (entry::phaseOfIntegral.given(d)) phase_ = indexAmong(entry::phaseOfIntegral, d, context.phases);
}

EntryList SurfaceIntegral::entries()
{
    return {entry::wallOfIntegral,
            entry::integrand,
            entry::phaseOfIntegral,
            {entry::regionOfIntegral, {entry::min, entry::max}},
            entry::origin};
}

TableInfo SurfaceIntegral::table()
{
    return {"surfaceIntegral", "surfaceIntegral.dat", "integrals of an expression over a wall: flux, force, torque", column::ofIntegral};
}

void SurfaceIntegral::execute(const ParticleView& view)
{
    if (!triangles_) triangles_.emplace(view, region_);
    triangles_->follow(*view.geometry);
    const auto f = value_.atParticles(view, {});
    const Interpolator interpolator(view);
    const Interpolator::Admits ofPhase = [&](std::size_t i, const Vector<3>&) { return phaseOf(view, i) == *phase_; };
    auto& wall = triangles_->walls().at(wall_);
    const auto& s = wall.surface;
    std::vector<double> atPoints(s.points.size());
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t p = 0; p < s.points.size(); ++p)
    {
        const auto weights =
            interpolator.weights(triangles_->inScene(s.points[p]), Interpolation::linear, phase_ ? ofPhase : Interpolator::Admits{});
        if (!weights.empty()) atPoints[p] = weights(f.data()) * triangles_->filled(wall, p, weights.coverage, *view.geometry);
    }
    last_ = sum(s.triangles.size(),
                [&](std::size_t k)
                {
                    const double area = wall.areas[k];
                    if (!(area > 0)) return Sum{};
                    Sum part{area, 0, {}, {}};
                    Vector<3> moment; // int f (x - origin), f linear over the triangle
                    const auto& corners = s.triangles[k];
                    double total = 0;
                    Vector<3> middle;
                    for (const int a : corners)
                    {
                        total += atPoints[std::size_t(a)];
                        middle += triangles_->inScene(s.points[std::size_t(a)]) - origin_;
                    }
                    for (const int a : corners)
                        moment += atPoints[std::size_t(a)] * (middle + (triangles_->inScene(s.points[std::size_t(a)]) - origin_));
                    const auto normal = unitVector(WallTriangles::doubledNormal(s, k));
                    part.integral = area * total / 3;
                    part.force = -part.integral * normal;
                    part.torque = -cross(area / 12 * moment, normal);
                    return part;
                });
    if (!table_) table_.emplace(context_.file("surfaceIntegral.dat"), std::vector<std::string>{}, column::ofIntegral);
    table_->row(view.time, std::vector<std::string>{cell(last_.area), cell(last_.integral), cell(last_.force), cell(last_.torque)});
}

std::string SurfaceIntegral::report() const
{
    return fmt::format("{}: integral {:.6g} over {:.6g}, force ({:.6g} {:.6g} {:.6g})", context_.name, last_.integral, last_.area,
                       last_.force.x, last_.force.y, last_.force.z);
}

}
