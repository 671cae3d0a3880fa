/// A simulation made from the texts of a case, its particles on a lattice, or off it by a random displacement, where walls leave room.
#pragma once
#include "case/Case.hpp"
#include "smallCases.hpp"
#include "solver/Simulation.hpp"
#include <cmath>
#include <memory>
#include <omp.h>
#include <random>

namespace sph::test
{

struct CaseScene
{
    TestCase folder;
    Case theCase;
    Geometry geometry;
    Settings settings;
    std::string errors;
    std::unique_ptr<AnySimulation> simulation;

    /// `jitter` in spacings; masses differ by 5 % where there is any. Phase 1 of several lies above y = 0.5. Without mistakes there is a simulation.
    explicit CaseScene(const Files& files, double jitter = 0)
        : folder(files),
          theCase(folder.folder()),
          geometry(readGeometry(theCase.dictionary("constant/geometry"), 0.4)),
          settings(readSettings(theCase, geometry))
    {
        omp_set_num_threads(1); // a few hundred particles are faster by one
        try
        {
            theCase.diagnostics().throwIfAny();
            simulation = makeSimulation(settings, geometry, cloud(jitter), {});
        }
        catch (const CaseError& e)
        {
            errors = e.what();
        }
    }
    Cloud cloud(double jitter) const
    {
        Cloud cloud;
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> any(-1, 1);
        const double spacing = settings.coefficients.spacing;
        auto &phase = cloud.fields["phase"].component, &m = cloud.fields["m"].component;
        phase.resize(1);
        m.resize(1);
        for (double x = 0.5 * spacing; x < geometry.high.x; x += spacing)
            for (double y = 0.5 * spacing; y < geometry.high.y; y += spacing)
            {
                const Vector<3> place{x + jitter * spacing * any(random), y + jitter * spacing * any(random), 0};
                if (geometry.distance(place) < 0.3 * spacing) continue;
                cloud.x.push_back(place.x);
                cloud.y.push_back(place.y);
                cloud.z.push_back(0);
                phase[0].push_back(settings.multiphase() && y > 0.5);
                const double rho = settings.coefficients.restDensity[std::size_t(phase[0].back())];
                m[0].push_back(rho * sqr(spacing) * (1 + (jitter > 0) * 0.05 * any(random)));
            }
        return cloud;
    }
    const double* operator[](const char* field) const { return simulation->field(field).component[0]; }
    /// sum m q
    double total(const char* field) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < simulation->size(); ++i) sum += (*this)["m"][i] * (*this)[field][i];
        return sum;
    }
    /// sum |m q|, of which a total has the round-off.
    double size(const char* field) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < simulation->size(); ++i) sum += std::abs((*this)["m"][i] * (*this)[field][i]);
        return sum;
    }
};

}
