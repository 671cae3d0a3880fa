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
inline const Scalar E{"E", units::pressure, byScene("needed without moduli"), positive, "Young's modulus"};
inline const Scalar nu{"nu", units::none, byScene("needed without moduli"), Range{-1, 0.5, false, false}, "Poisson's ratio"};
inline const Scalar K{"bulkModulus", units::pressure, byScene("of E and nu"), positive, "K, with shearModulus in place of E and nu"};
inline const Scalar G{"shearModulus", units::pressure, byScene("of E and nu"), positive, "G"};
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

    static EntryList entries() { return {entry::elastic::E, entry::elastic::nu, entry::elastic::K, entry::elastic::G}; }
    static ElasticLaw read(const Dictionary& d)
    {
        namespace e = entry::elastic;
        if (e::K.given(d) || e::G.given(d))
        {
            for (const auto* other : {&e::E, &e::nu})
                if (other->given(d)) other->error(d, "the elasticity is said twice: keep E and nu, or bulkModulus and shearModulus");
            const double K = e::K.needed(d), G = e::G.needed(d);
            return {G, K};
        }
        const double E = e::E.needed(d), nu = e::nu.needed(d);
        return of(E, nu);
    }
};

}
