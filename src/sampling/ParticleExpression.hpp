/// An expression of fields, position, time and constants of a case, computed for all particles of a view.
#pragma once
#include "dictionary/ExpressionProgram.hpp"
#include "dictionary/Parameter.hpp"
#include "sampling/ParticleView.hpp"
#include <optional>

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
/// | `$water` | a phase by its name: 1 at its particles, 0 at others |
/// | `grad($p)` | gradient of a field or component, a vector (Interpolator::gradient) |
/// | `smooth($p)`, `$coverage` | sum_j V_j W_j f_j/sum_j V_j W_j, and sum_j V_j W_j, with what is mirrored in planes of symmetry |
/// | `${distance(floor)}`, `$distance` | from a wall, and from the nearest that is no plane of symmetry [m] |
/// | `${contactAngle(floor)}` | of a wall, through the phase that the scene names first [degrees] |
/// | `$restDensity $soundSpeed $viscosity` | of the particle's phase [kg/m^3], [m/s], [Pa s] |
/// | `$spacing $support $deltaT` | of the scene [m], [m], [s] |
/// | `$g` | gravity and body force of the first phase, a vector [m/s^2] |
/// | `$surfaceTension` | of a scene with one [N/m] |
/// | `${power(hot)}` | a number that a model reports |
///
/// and numbers by the names that they were given; a number hides a field of the same name in what stands behind it. What sums over neighbours is found where a text names it, and not before.
class ParticleExpression
{
public:
    /// What a text may give.
    enum class Gives
    {
        number,
        numberOrVector
    };

private:
    using Kind = ExpressionProgram::Kind;
    struct Compiled
    {
        ExpressionProgram program;
        std::vector<Kind> kinds; ///< of its names
    };
    class Names;
    class Bound;

    std::string text_;
    Location where_;
    std::vector<std::string> later_;
    Gives gives_;
    mutable std::optional<Compiled> compiled_; ///< since the first row; again where a name has become of another kind

    template<class Use> auto bound(const ParticleView&, const NamedNumbers&, const Use&) const;

public:
    /// Looks the text through: mistakes that can be seen before there are fields are recorded at the entry. `numbers` are the names of those that the text may have, `later` of those that stand
    /// behind it, for the message about a name that is not known.
    ParticleExpression(const Text& entry, const Dictionary&, const std::string& text, const std::vector<std::string>& numbers = {},
                       const std::vector<std::string>& later = {}, Gives = Gives::number);

    /// Throws CaseError at the entry where the view has no such name, or the text gives a vector.
    std::vector<double> atParticles(const ParticleView&, const NamedNumbers&) const;
    /// One row of a number, three of a vector.
    std::vector<std::vector<double>> componentsAtParticles(const ParticleView&, const NamedNumbers& = {}) const;
    /// The same of a text whose names have one value for all particles. A value that has no meaning (1/0) is NaN or infinite.
    double ofScene(const ParticleView&, const NamedNumbers&) const;
};

}
