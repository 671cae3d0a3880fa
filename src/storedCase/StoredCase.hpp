/// A case whose time folders are looked at again: its dictionaries as the solver reads them, and its particles as a view.
#pragma once
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "geometry/Geometry.hpp"
#include "geometry/OpenEnds.hpp"
#include "sampling/ParticleView.hpp"
#include "solver/readSettings.hpp"
#include <string>
#include <vector>

namespace sph
{

class StoredCase
{
    const Case& case_;
    Geometry geometry_;
    Settings settings_;
    OpenEnds openEnds_;
    Cloud cloud_;
    std::vector<double> volume_, heldBy_;

public:
    static constexpr const char* cloudName = "sph";

    /// Mistakes go to the case's Diagnostics. The case must outlive this.
    explicit StoredCase(const Case&);

    const Geometry& geometry() const { return geometry_; }
    const Settings& settings() const { return settings_; }
    const std::vector<std::string>& phases() const { return settings_.coefficients.phases; }

    /// Names of the time folders that hold particles; throws CaseError if there is none.
    std::vector<std::string> times() const;

    /// The particles of a time folder, valid until the next call. Needs the fields rho, m and, where there are several phases,
    /// phase. V_i = m_i/rho_i where the folder does not say otherwise. What it cost to compute is not on disk: executionTime is NaN.
    ParticleView load(const std::string& time);
    /// The particles of the last call, as they are on disk.
    const Cloud& cloud() const { return cloud_; }
};

}
