/// Numbers of a scalar, and the tags of its fields, which in a scene have the scalar's own name.
#pragma once
#include "fields/fieldTags.hpp"
#include <optional>
#include <string>
#include <vector>

namespace sph
{

// clang-format off
struct ScalarValue { static constexpr FieldInfo info{"scalar", "1"};      template<int dim, class Real = double> struct At { Real c; }; };
struct ScalarRate  { static constexpr FieldInfo info{"dscalardt", "1/s"}; template<int dim, class Real = double> struct At { Real dcdt; }; };
// clang-format on

struct TransportedScalar
{
    std::string name;
    std::vector<double> diffusivity;              ///< D of each phase [m^2/s]
    std::vector<std::string> initial;             ///< of each phase, an expression of the position
    std::vector<std::optional<double>> wallValue; ///< at each wall; nothing passes those without

    std::string rateName() const { return "d" + name + "dt"; }
};

}
