/// A field of a ParticleView by name, whatever its class: numbers by component and particle.
#pragma once
#include "sampling/ParticleView.hpp"
#include <optional>

namespace sph
{

class SampledField
{
    FieldView field_;

public:
    /// Throws CaseError at `where`, with the names of the fields that there are, if the view has none of that name.
    SampledField(const ParticleView&, const std::string& name, const Location& where);

    const std::string& name() const { return field_.name; }
    FieldClass type() const { return field_.type; }
    int components() const { return componentsOf(field_.type); }

    /// A component that the view leaves out (z in 2-D) is zero.
    double operator()(int component, std::size_t i) const
    {
        const double* values = array(component);
        return values ? values[i] : 0;
    }
    const double* array(int component) const { return component < int(field_.component.size()) ? field_.component[component] : nullptr; }
};

/// "p", "U_x U_y U_z": the names of the columns of a field.
std::vector<std::string> columnNames(const SampledField&);

/// The index into the view's phases of particle i; 0 where the view has no phases.
inline std::size_t phaseOf(const ParticleView& view, std::size_t i) { return view.phase ? std::size_t(view.phase[i]) : 0; }

inline Vector<3> position(const ParticleView& view, std::size_t i) { return {view.x[i], view.y[i], view.z ? view.z[i] : 0}; }

}
