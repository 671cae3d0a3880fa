/// The numbers that terms are built from, those that several models share and those that one keeps to itself, read once from the dictionaries of a case. Plain data: terms copy what they need, and
/// point at the tables, which outlive them.
#pragma once
#include "base/Vector.hpp"
#include "stateEquation/StateEquation.hpp"
#include <any>
#include <map>
#include <stdexcept>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace sph
{

struct Coefficients
{
    int dimension = 3;
    double spacing = 0; ///< mean particle spacing [m]
    double support = 0; ///< kernel support radius H [m]

    std::vector<std::string> phases;
    std::vector<double> restDensity; ///< rho_0 of each phase [kg/m^3]
    std::vector<double> viscosity;   ///< mu [Pa s]
    std::vector<double> soundSpeed;  ///< c [m/s]
    std::vector<StateEquation> stateEquation;
    double backgroundPressure = 0; ///< p_b [Pa], the same in all phases
    double leastPressure = -1e300; ///< p_min [Pa], at which a fluid that is pulled parts

    Vector<3> g;         ///< [m/s^2] of the moment, where it varies: who needs it in a run refers to it
    Vector<3> bodyForce; ///< [N/m^3]

    double densityScale = 1; ///< makes the mean of sigma V_0 exact

    std::map<std::string, std::vector<double>> constants; ///< of models, that function objects may ask for, by the keyword of their entry

    /// Numbers of a model, which it alone knows; throws std::logic_error where there are none.
    template<class T> const T& of() const
    {
        const auto found = ofModels_.find(std::type_index(typeid(T)));
        if (found == ofModels_.end()) throw std::logic_error(std::string("the scene has no numbers of ") + typeid(T).name());
        return *std::any_cast<T>(&found->second);
    }
    template<class T> T& of() { return const_cast<T&>(std::as_const(*this).template of<T>()); }
    template<class T> bool has() const { return ofModels_.contains(std::type_index(typeid(T))); }
    template<class T> void set(T numbers) { ofModels_.insert_or_assign(std::type_index(typeid(T)), std::move(numbers)); }

private:
    std::map<std::type_index, std::any> ofModels_;
};

}
