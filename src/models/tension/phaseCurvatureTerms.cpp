#include "models/tension/phaseCurvatureTerms.hpp"
#include "models/tension/PhaseCurvature.hpp"
#include "models/tension/Tensions.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sph
{

std::vector<double> tensionShares(const Coefficients& c)
{
    const std::size_t n = c.phases.size();
    std::vector<double> sum(n, 0.0);
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t l = 0; l < n; ++l) sum[k] += tensionsOf(c).between[k * n + l];
    const double all = std::accumulate(sum.begin(), sum.end(), 0.0) / double(2 * n - 2);
    std::vector<double> gamma;
    for (double s : sum) gamma.push_back((s - all) / double(n - 2));
    return gamma;
}

double missedByShares(const Coefficients& c)
{
    const auto gamma = tensionShares(c);
    const std::size_t n = c.phases.size();
    double most = 0;
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t l = 0; l < n; ++l)
            if (k != l) most = std::max(most, std::abs(gamma[k] + gamma[l] - tensionsOf(c).between[k * n + l]));
    return most / (*std::max_element(tensionsOf(c).between.begin(), tensionsOf(c).between.end()));
}

std::vector<double> wallCosines(const Coefficients& c)
{
    const std::size_t n = c.phases.size(), walls = tensionsOf(c).ofWalls.size() / n;
    std::vector<double> cosines;
    for (std::size_t w = 0; w < walls; ++w)
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t l = 0; l < n; ++l)
            {
                const double gamma = tensionsOf(c).between[k * n + l],
                             difference = tensionsOf(c).ofWalls[w * n + l] - tensionsOf(c).ofWalls[w * n + k];
                cosines.push_back(gamma > 0 ? std::clamp(difference / gamma, -1.0, 1.0) : 0);
            }
    return cosines;
}

namespace
{
/// Arrays that the terms of a phase point to.
struct Tables
{
    std::vector<double> share;  ///< by the other phase
    std::vector<double> cosine; ///< walls x the other phase
};

std::shared_ptr<const Tables> tablesOf(const Coefficients& c, std::size_t k)
{
    const std::size_t n = c.phases.size(), walls = tensionsOf(c).ofWalls.size() / n;
    const auto gamma = tensionShares(c), cosine = wallCosines(c);
    Tables t;
    for (std::size_t l = 0; l < n; ++l) t.share.push_back(l == k ? 0 : 0.5 * (tensionsOf(c).between[k * n + l] + gamma[k] - gamma[l]));
    for (std::size_t w = 0; w < walls; ++w)
        for (std::size_t l = 0; l < n; ++l) t.cosine.push_back(cosine[(w * n + k) * n + l]);
    return std::make_shared<const Tables>(std::move(t));
}
}

std::vector<std::string> definePhaseCurvature(Settings& settings, PhaseCurvatureForms forms)
{
    const auto& c = settings.coefficients;
    const int n = int(c.phases.size());
    std::vector<std::string> selected;
    for (int k = 0; k < n; ++k)
    {
        const std::string of = " of " + c.phases[std::size_t(k)];
        Names names;
        for (const char* field : {SmoothedColour::info.name, ColourGradient::info.name, RawCurvature::info.name, Curvature::info.name})
            names[field] = std::string(field) + "." + c.phases[std::size_t(k)];
        Names ofForce = names;
        ofForce.insert(settings.separateSums.begin(), settings.separateSums.end());
        const auto tables = tablesOf(c, std::size_t(k));
        const double phase = k;
        const std::string gradient = "colourGradient" + of, force = "curvatureForce" + of;
        settings.define<PhaseColourSmoothing>(
            "colourSmoothing" + of, [=](const Coefficients&) { return PhaseColourSmoothing{phase}; }, names);
        if (forms.adhering)
            settings.define<AdheringPhaseGradient>(
                gradient,
                [=](const Coefficients&) {
                    return AdheringPhaseGradient{tables->cosine.data(), n, phase};
                },
                names);
        else
            settings.define<SmoothedColourGradient>(
                gradient, [](const Coefficients&) { return SmoothedColourGradient{}; }, names);
        settings.define<InterfaceCurvature>(
            "interfaceCurvature" + of, [](const Coefficients& q) { return InterfaceCurvature(q); }, names);
        settings.define<CurvatureSmoothing>(
            "curvatureSmoothing" + of, [](const Coefficients&) { return CurvatureSmoothing{}; }, names);
        if (forms.even)
            settings.define<EvenPhaseCurvatureForce>(
                force,
                [=](const Coefficients&) {
                    return EvenPhaseCurvatureForce{tables->share.data(), phase};
                },
                ofForce);
        else
            settings.define<PhaseCurvatureForce>(
                force,
                [=](const Coefficients&) {
                    return PhaseCurvatureForce{tables->share.data(), phase};
                },
                ofForce);
        selected.push_back(force);
    }
    return selected;
}

}
