/// Gravity and a uniform force per volume:
///
///   dv/dt = g + f/rho
///
/// g [m/s^2], which Shaking.hpp may vary; f [N/m^3], the pressure gradient that drives a periodic flow. Erratum of Barker et al. (2012), eq. (1): gravity acts on
/// the momentum of a volume as rho g, not g.
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

struct Gravity
{
    static constexpr auto name = "gravity";
    using Adds = Acceleration;
    using ReadsOwn = Fields<Velocity>;
    const Vector<3>& g;

    explicit Gravity(const Coefficients& c) : g(c.g) {}
    auto operator()(const auto& i) const { return in<dimensions(decltype(i.v){})>(g); }
};

struct BodyForce
{
    static constexpr auto name = "bodyForce";
    using Adds = Acceleration;
    using ReadsOwn = Fields<Velocity, Density>;
    Vector<3> f;

    explicit BodyForce(const Coefficients& c) : f(c.bodyForce) {}
    auto operator()(const auto& i) const { return 1 / i.rho * in<dimensions(decltype(i.v){})>(f); }
};

}
