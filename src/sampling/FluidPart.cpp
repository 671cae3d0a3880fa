#include "sampling/FluidPart.hpp"
#include "geometry/components.hpp"
#include "kernels/Kernel.hpp"
#include "sampling/planesOfSymmetry.hpp"

namespace sph
{

namespace
{

bool inDomain(const Vector<3>& y, const Geometry& geometry)
{
    for (int k = 0; k < geometry.dimension; ++k)
        if (const auto c = component(k); !geometry.periodic[std::size_t(k)] && (y.*c < geometry.low.*c || y.*c > geometry.high.*c))
            return false;
    return true;
}

}

FluidPart::FluidPart(const ParticleView& view, Mirrored mirrored) : support_(view.support)
{
    constexpr int steps = 4; // to the radius of the sphere
    const bool flat = view.dimension == 2;
    const auto W = [&](double r) { return flat ? Kernel<2>(view.kernel, view.support).W(r) : Kernel<3>(view.kernel, view.support).W(r); };
    double whole = 0;
    for (int k = flat ? 0 : -steps; k < (flat ? 1 : steps); ++k)
        for (int j = -steps; j < steps; ++j)
            for (int i = -steps; i < steps; ++i)
            {
                const Vector<3> r = view.support / steps * Vector<3>{i + 0.5, j + 0.5, flat ? 0 : k + 0.5};
                if (mag(r) >= view.support) continue;
                parts_.push_back({r, W(mag(r))});
                whole += parts_.back().weight;
            }
    for (auto& part : parts_) part.weight /= whole;
    if (mirrored == Mirrored::atSymmetryPlanes) mirrors_ = planesOfSymmetry(*view.geometry);
}

double FluidPart::operator()(const Vector<3>& x, const Geometry& geometry) const
{
    double part = 0;
    for (const auto& [offset, weight] : parts_)
    {
        auto y = x + offset;
        for (const auto* mirror : mirrors_)
            if (const auto foot = mirror->foot(y); foot.distance < 0 && foot.distance > -support_) y = mirrorImage(y, foot);
        if (inDomain(y, geometry) && geometry.inFluid(y)) part += weight;
    }
    return part;
}

}
