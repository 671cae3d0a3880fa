#include "models/tension/YoungsLaw.hpp"
#include "base/words.hpp"
#include "models/tension/Tensions.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

namespace sph
{

namespace
{
constexpr double tolerance = 0.5; // [degrees]: of angles that are printed as whole numbers

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

/// Tensions of the phases that angles connect with one another, each relative to one of its group.
class Connected
{
    std::vector<std::size_t> group_;
    std::vector<double> tension_; ///< [N/m]

public:
    explicit Connected(std::size_t n) : group_(n), tension_(n, 0.0) { std::iota(group_.begin(), group_.end(), std::size_t(0)); }
    bool are(std::size_t a, std::size_t b) const { return group_[a] == group_[b]; }
    /// gamma_sb - gamma_sa of two that are
    double difference(std::size_t a, std::size_t b) const { return tension_[b] - tension_[a]; }
    void connect(std::size_t a, std::size_t b, double difference)
    {
        const auto joins = group_[b];
        const double offset = tension_[a] + difference - tension_[b];
        for (std::size_t k = 0; k < group_.size(); ++k)
            if (group_[k] == joins)
            {
                group_[k] = group_[a];
                tension_[k] += offset;
            }
    }
};

/// Angle of a pair of phases that those of others imply.
struct Implied
{
    double gamma, difference, cosine;
    Implied(double g, double d) : gamma(g), difference(d), cosine(d / g) {}
    /// Half a degree beyond 0 or 180 degrees is a rounded angle.
    bool possible() const { return std::abs(difference) <= gamma * (2 - sph::cosine(tolerance)); }
    double angle() const { return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi; }
};

std::string nameOf(const Coefficients& c, std::size_t a, std::size_t b) { return fmt::format("({} {})", c.phases[a], c.phases[b]); }

std::string impossible(const Coefficients& c, std::size_t a, std::size_t b, const Implied& implied)
{
    const auto cosine =
        implied.gamma > 0 ? fmt::format(": by Young's law its cosine is {:.4g},", implied.cosine) : std::string(" by Young's law,");
    return fmt::format(
        "no angle of {} goes with the others{} the wall's tensions with the two being {:.4g} N/m apart and their own only {:.4g}. Possible with a sigma of "
        "{} of at least {:.4g} N/m, or with other angles",
        nameOf(c, a, b), cosine, std::abs(implied.difference), implied.gamma, nameOf(c, a, b), std::abs(implied.difference));
}

void checkConnected(const Connected& tensions, const Coefficients& c, const Complain& complain)
{
    std::vector<std::string> groups;
    std::vector<bool> seen(c.phases.size(), false);
    std::string example;
    for (std::size_t k = 0; k < c.phases.size(); ++k)
    {
        if (seen[k]) continue;
        std::string group;
        for (std::size_t l = k; l < c.phases.size(); ++l)
            if (tensions.are(k, l))
            {
                seen[l] = true;
                group += (group.empty() ? "" : " ") + c.phases[l];
            }
        groups.push_back(fmt::format("({})", group));
        if (k > 0 && example.empty()) example = nameOf(c, 0, k);
    }
    if (groups.size() > 1)
        complain(
            fmt::format("its contact angles do not connect the phases {}: with {} phases {} angles tell all others; {} is missing, for one",
                        list(groups), c.phases.size(), c.phases.size() - 1, example));
}
}

double cosineThroughFirst(const PhaseAngle& pair) { return pair.a < pair.b ? cosine(pair.angle) : -cosine(pair.angle); }

std::vector<PhaseAngle> phaseAngles(const WallProperties& wall, const Coefficients& c, const Complain& complain)
{
    std::vector<PhaseAngle> angles;
    if (wall.wets && wall.contactAngles.empty())
    {
        if (c.phases.size() == 2) return {{0, 1, wall.contactAngle}};
        std::string pairs;
        for (std::size_t k = 1; k < c.phases.size(); ++k) pairs += fmt::format(" {} {}", nameOf(c, 0, k), wall.contactAngle);
        complain(fmt::format(
            "contactAngle {} is of two phases, and here are {}. Which pairs have what angle is said by contactAngles, for example contactAngles ({} );",
            wall.contactAngle, c.phases.size(), pairs));
    }
    for (const auto& [first, second, angle] : wall.contactAngles)
    {
        const auto a = std::find(c.phases.begin(), c.phases.end(), first), b = std::find(c.phases.begin(), c.phases.end(), second);
        for (const auto& [found, word] : {std::pair(a, first), std::pair(b, second)})
            if (found == c.phases.end())
                complain(fmt::format("contactAngles: phase \"{}\" is unknown. {}", word, suggestion(word, "phases", c.phases)));
        if (a != c.phases.end() && b != c.phases.end())
            angles.push_back({std::size_t(a - c.phases.begin()), std::size_t(b - c.phases.begin()), angle});
    }
    return angles;
}

std::vector<double> wallTensions(const std::vector<PhaseAngle>& angles, const Coefficients& c, const Complain& complain)
{
    const std::size_t n = c.phases.size();
    std::vector<double> tension(n, 0.0);
    if (angles.empty()) return tension;
    const auto gamma = [&](std::size_t a, std::size_t b) { return tensionsOf(c).between[a * n + b]; };
    if (n == 2)
    {
        const double all = c.restDensity[0] + c.restDensity[1], cosTheta = cosineThroughFirst(angles.front());
        return {-(c.restDensity[0] / all) * gamma(0, 1) * cosTheta, c.restDensity[1] / all * gamma(0, 1) * cosTheta};
    }
    bool good = true;
    const auto fail = [&](const std::string& what)
    {
        complain(what);
        good = false;
    };
    Connected relative(n);
    for (const auto& [a, b, angle] : angles)
    {
        if (!relative.are(a, b))
        {
            relative.connect(a, b, gamma(a, b) * cosine(angle));
            continue;
        }
        const Implied implied(gamma(a, b), relative.difference(a, b));
        if (implied.possible() && !(std::abs(implied.angle() - angle) <= tolerance) && implied.gamma > 0)
            fail(fmt::format(
                "the angle of {} cannot be {}: by Young's law those before it imply {:.4g} degrees. Write that, or leave it out",
                nameOf(c, a, b), angle, implied.angle()));
    }
    checkConnected(relative, c, fail);
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b)
            if (const Implied implied(gamma(a, b), relative.are(a, b) ? relative.difference(a, b) : 0); !implied.possible())
                fail(impossible(c, a, b, implied));
    if (!good) return tension;

    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < n; ++k)
    {
        sum += relative.difference(0, k) / c.restDensity[k];
        weights += 1 / c.restDensity[k];
    }
    for (std::size_t k = 0; k < n; ++k) tension[k] = relative.difference(0, k) - sum / weights;
    return tension;
}

}
