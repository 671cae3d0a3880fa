/// Isotropic linear elasticity, Hooke's law in rates:
///
///   sigma^ = 2 G D + (K - 2 G/3) tr(D) I,     G = E/(2 (1 + nu)),  K = E/(3 (1 - 2 nu))
///
/// sigma^ [Pa/s] Jaumann rate, D [1/s] strain rate, E [Pa] Young's modulus, nu [1] Poisson's ratio. No range: every stress is admissible. Verified by
/// test/unit/soilLaws (Hooke's law under uniaxial stress and strain).
#pragma once
#include "soilLaws/ConstitutiveLaw.hpp"

namespace sph
{

namespace entry::elastic
{
inline const Scalar E{"E", units::pressure, required, positive, "Young's modulus"};
inline const Scalar nu{"nu", units::none, required, Range{-1, 0.5, false, false}, "Poisson's ratio"};
}

struct ElasticLaw
{
    static constexpr auto name = "elastic", meaning = "isotropic, linear, for tests";
    static constexpr bool tensionless = false;
    double G = 0, K = 0; ///< shear and bulk modulus [Pa]

    static constexpr ElasticLaw of(double E, double nu) { return {E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu))}; }
    constexpr SymmTensor<3> rate(SymmTensor<3>, SymmTensor<3> D) const { return 2 * G * D + (K - 2 * G / 3) * trace(D) * identity(D); }
    /// The strain that the stress is of.
    constexpr SymmTensor<3> strain(SymmTensor<3> sigma) const
    {
        return 1 / (2 * G) * deviator(sigma) + trace(sigma) / (9 * K) * identity(sigma);
    }
    double stiffness(SymmTensor<3> = {}) const { return K + 4 * G / 3; }
    bool admits(SymmTensor<3>) const { return true; }
    SymmTensor<3> returned(SymmTensor<3> sigma) const { return sigma; }

    static EntryList entries() { return {entry::elastic::E, entry::elastic::nu}; }
    static ElasticLaw read(const Dictionary& d)
    {
        const double E = entry::elastic::E(d), nu = entry::elastic::nu(d);
        return of(E, nu);
    }
};

}
