/// An expression of fields, position, time and constants of a case, computed for all particles of a view.
#pragma once
#include "dictionary/ExpressionProgram.hpp"
#include "dictionary/Parameter.hpp"
#include "sampling/ParticleView.hpp"

namespace sph
{

/// A number of a view by its name.
struct NamedNumber
{
    std::string name;
    double value = 0;
    std::size_t particles = 0; ///< that it rests on
    bool isThere = true;       ///< false of a mean over time before its time
};
/// In the order in which they were found.
using NamedNumbers = std::vector<NamedNumber>;

/// A text may have these names:
///
/// | name | value |
/// |---|---|
/// | `$x $y $z $t` | position [m], time [s] |
/// | `$p $U $sigma_xx` | a field: a scalar, a vector as a whole, a component (`$U_x`) |
/// | `$mass $volume` | of the particle [kg], [m^3] |
/// | `$restDensity $soundSpeed $viscosity` | of the particle's phase [kg/m^3], [m/s], [Pa s] |
/// | `$spacing $support $deltaT` | of the scene [m], [m], [s] |
/// | `$g` | gravity and body force of the first phase, a vector [m/s^2] |
/// | `$surfaceTension` | of a scene with one [N/m] |
/// | `${power(hot)}` | a number that a model reports |
///
/// and numbers by the names that they were given; a number hides a field of the same name in what stands behind it.
class ParticleExpression
{
    std::string text_;
    Location where_;
    std::vector<std::string> later_;

public:
    /// Looks the text through: mistakes that can be seen before there are fields are recorded at the entry. `numbers` are the names of those that the text may have, `later` of those that stand
    /// behind it, for the message about a name that is not known.
    ParticleExpression(const Text& entry, const Dictionary&, const std::string& text, const std::vector<std::string>& numbers = {},
                       const std::vector<std::string>& later = {});

    /// Throws CaseError at the entry where the view has no such name, or the text gives a vector.
    std::vector<double> atParticles(const ParticleView&, const NamedNumbers&) const;
    /// The same of a text whose names have one value for all particles. A value that has no meaning (1/0) is NaN or infinite.
    double ofScene(const ParticleView&, const NamedNumbers&) const;
};

}
