#include "models/density/density.hpp"
#include "models/density/DensityDiffusion.hpp"
#include "models/density/DensityRelaxation.hpp"
#include "models/density/DensityScale.hpp"
#include "models/density/densityTerms.hpp"
#include "parallel/reduce.hpp"
#include "scene/DensityOfModel.hpp"
#include "scene/TwoLevels.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Choice density{"density",
                     {{"numberDensity", "rho = m sigma"}, {"continuity", "integrated"}},
                     "numberDensity",
                     "where the density comes from"},
    continuityForm{"continuityForm",
                   {{"volume", "pairs by the neighbour's volume"}, {"mass", "by its mass: Kauzlaric et al. (2011), eq. (3.1)"}},
                   "volume",
                   "of the continuity equation"},
    volume{"volume", {{"numberDensity", "V = 1/sigma"}, {"continuity", "V = m/rho"}}, byScene("as density"), "of the sums over neighbours"},
    normalisation{"normalisation",
                  {{"secondMoment", "gradients are exact for linear fields on the mean"}, "none"},
                  byScene("secondMoment; none with scheme paper or volume continuity"),
                  "of the kernel's gradient"},
    densityDiffusionForm{"densityDiffusionForm",
                         {"molteni", {"antuono", "with the renormalised gradient"}},
                         "molteni",
                         "of the density diffusion"};
const Scalar densityDiffusion{"densityDiffusion", units::none, 0, nonNegative, "delta of the diffusion against pressure noise, about 0.1"},
    densityRelaxation{"densityRelaxation", Unit{units::none, "h/c"}, 0, nonNegative,
                      "time in which an integrated density follows the particles' places where they differ, about 100; 0: never"};
}

namespace
{
/// Density over that at rest that has the pressure of the time folder's file [Pa, above the background's]; 1 without such a file, or where a law of
/// its own gives the stress of a phase.
double compressionAtStart(std::size_t i, const Loading& loading)
{
    const auto given = loading.cloud.fields.find("p");
    const auto& c = loading.coefficients;
    const auto k = loading.phaseOf(i);
    const auto& equation = c.stateEquation[k];
    if (given == loading.cloud.fields.end() || equation.B == 0) return 1;
    const double p = given->second.component[0][i];
    if (p <= equation.leastPressure())
        throw CaseError(fmt::format("{} has the pressure {:.4g} Pa, and no density gives it in the state equation of {}",
                                    loading.cloud.particle(i), p, c.phases[k]));
    return equation.compression(p);
}

void densityAtStart(const Loading& loading)
{
    for (std::size_t i = 0; i < loading.size(); ++i)
        loading.values[0][i] = loading.coefficients.restDensity[loading.phaseOf(i)] * compressionAtStart(i, loading);
}

/// Masses make the pressure at the start where the positions decide the density: of a folder without rho, which packParticles writes.
void massesAtStart(const Loading& loading, const StartCompression& compression)
{
    *compression.mean = 1;
    if (loading.restarted || loading.cloud.fields.contains("rho")) return;
    double* const m = loading.values[0];
    const std::vector<double> m_0(m, m + loading.size());
    for (std::size_t i = 0; i < loading.size(); ++i) m[i] *= compressionAtStart(i, loading);
    const auto total = ofAllRanks(loading.size(), std::size_t(0), Add{});
    if (total > 0) *compression.mean = sum(loading.size(), [&](std::size_t i) { return m[i] / m_0[i]; }) / double(total);
}

void readDiffusion(const Reading& reading)
{
    const auto& dict = reading.schemes;
    auto& c = reading.settings.coefficients;
    const double delta = entry::densityDiffusion(dict);
    const auto& form = reading.choose(entry::densityDiffusionForm);
    reading.belongs(entry::densityDiffusionForm, entry::densityDiffusion);
    if (!(delta > 0)) return;
    c.set(DiffusionNumber{delta, form == "antuono"});
    if (!reading.settings.facts.get<IntegratedDensity>().exists)
        entry::densityDiffusion.error(dict, "goes with `density continuity;` alone");
    for (const double rho : c.restDensity)
        if (rho != c.restDensity[0])
        {
            entry::densityDiffusion.error(dict, "phases of different rest density cannot diffuse into one another");
            break;
        }
    reading.select(form == "antuono" ? "renormalisedDiffusion" : "densityDiffusion");
}

void readRelaxation(const Reading& reading)
{
    const double soundTimes = entry::densityRelaxation(reading.schemes);
    if (!(soundTimes > 0)) return;
    if (!reading.settings.facts.get<IntegratedDensity>().exists)
        entry::densityRelaxation.error(reading.schemes, "goes with `density continuity;` alone");
    reading.settings.coefficients.set(RelaxationTime{soundTimes});
    reading.select("densityRelaxation");
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    const bool integrated = reading.choose(entry::density) == "continuity";
    settings.facts.give(IntegratedDensity{integrated}, "density of system/sphSchemes");
    const StartCompression compression;
    settings.coefficients.set(compression);
    if (!integrated)
    {
        for (auto& evolving : settings.state)
            if (evolving.value.name == std::string(Mass::info.name))
                evolving.loaded = [compression](const Loading& loading) { massesAtStart(loading, compression); };
        return;
    }
    Evolving rho{stateField(Density{}), stateField(DensityRate{})};
    rho.ofMaterial = true;
    rho.missing = densityAtStart;
    rho.check = [](const Loading& loading)
    {
        loading.checkScale("rho", "kg/m^3", leastCompression, mostCompression,
                           [&](std::size_t i) { return loading.coefficients.restDensity[loading.phaseOf(i)]; });
    };
    rho.inlet = [restDensity = settings.coefficients.restDensity](const Dictionary&, std::size_t phase) { return restDensity[phase]; };
    settings.state.push_back(rho);
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const bool integrated = settings.facts.get<IntegratedDensity>().exists;
    const auto& volume = reading.choose(entry::volume, settings.chosen.at(entry::density.keyword()));
    if (!integrated && volume == "continuity")
        entry::volume.error(reading.schemes, "goes with `density continuity;`: no density is integrated");
    settings.facts.give(VolumeOfPlaces{volume == "numberDensity"}, "volume of system/sphSchemes");
    const bool ends = settings.facts.get<PhaseInPart>().phase >= 0;
    const bool alone = settings.facts.get<GasLeftOut>().isLeftOut;
    reading.select(volume == "continuity" ? "integratedVolume"
                   : ends                 ? "numberDensityOrRest"
                   : alone                ? "completedVolume"
                                          : "numberDensity");
    const bool byMass = reading.choose(entry::continuityForm) == "mass";
    if (!integrated && byMass) entry::continuityForm.error(reading.schemes, "goes with `density continuity;`: no density is integrated");
    if (settings.facts.get<DensityOfModel>().exists)
    {
        for (auto& evolving : settings.state)
            if (evolving.value.name == Density::info.name)
            {
                evolving.rate.reset();
                evolving.advancedByModel = true;
            }
    }
    else reading.select(!integrated ? "summedDensity" : byMass ? "massContinuity" : "continuity");
    if (integrated && volume == "numberDensity") settings.shown.emplace_back(Volume::info.name, Volume::info.name); // not m/rho
    const bool normalises =
        reading.choose(entry::normalisation, reading.paper() || volume == "continuity" ? "none" : "secondMoment") == "secondMoment";
    if (normalises) reading.select(ends ? "gradientNormalisationOrRest" : alone ? "uniformNormalisation" : "gradientNormalisation");
    if (volume == "numberDensity" && normalises) settings.runningModels.push_back(running<DensityScale>());
    readDiffusion(reading);
    readRelaxation(reading);
}

/// s h/(4 delta c) from two levels, s their stable decay; from one, sound binds first.
std::optional<StepLimit> diffusionLimit(const Settings& settings, const Measured&)
{
    const auto& c = settings.coefficients;
    if (!c.has<TwoLevels>() || !c.has<DiffusionNumber>()) return {};
    const double fastest = *std::max_element(c.soundSpeed.begin(), c.soundSpeed.end());
    return StepLimit{c.of<TwoLevels>().stableDecay() * 0.25 * 0.5 * c.support / (c.of<DiffusionNumber>().delta * fastest),
                     "density diffusion", true};
}
}

const Model& densityModel()
{
    static const Model model{"density",
                             "where volume and density come from: number density, or the continuity equation with diffusion",
                             read,
                             densityTerms<2>(),
                             densityTerms<3>(),
                             prepare,
                             {{"density",
                               [](const Settings& s)
                               {
                                   const bool pushes = !s.facts.get<ConstitutiveStress>().exists; // by a state equation
                                   return pushes && s.facts.get<IntegratedDensity>().exists && s.integration.moves &&
                                          !s.integration.predicts && !s.coefficients.has<TwoLevels>();
                               },
                               "continuity needs velocities of the middle of a step, or sound grows; take integration scheme leapfrog, "
                               "predictorCorrector or verlet"}},
                             {diffusionLimit},
                             {{"system/sphSchemes",
                               {entry::density, entry::continuityForm, entry::volume, entry::normalisation, entry::densityDiffusion,
                                entry::densityDiffusionForm, entry::densityRelaxation}}}};
    return model;
}

}
