#include "solver/Simulation.hpp"
#include "base/CaseError.hpp"
#include "base/StepTooLong.hpp"
#include "integrators/Integrator.hpp"
#include "parallel/reduce.hpp"
#include "solver/EnergyBalance.hpp"
#include "solver/TimeStepLimits.hpp"
#include "solver/models.hpp"
#include "solver/summarise.hpp"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// Name of a number that was measured in the last step, in the state that a restart begins with: "lastPower".
std::string lastName(std::string name)
{
    name[0] = char(std::toupper(name[0]));
    return "last" + name;
}

/// Parts of an implicit step at most: one that is refused at a 64th of its length is so for another reason than its length.
constexpr int mostParts = 64;

template<int dim> class Simulation final : public AnySimulation
{
    const Settings& settings_;
    Catalogue<dim> terms_;
    Particles<dim> particles_;
    Schedule<dim> schedule_;
    bool goesOn_ = false; ///< a restart with the forces that its time folder was written with
    Summary summary_;
    EnergyBalance<dim> energy_;
    typename Plan<dim>::Counts operations_;
    long inParts_ = 0; ///< steps that were made in parts, since their whole was refused

    /// Terms of all models, and those that the scene defines under names of their own.
    static Catalogue<dim> termsOf(const Settings& settings)
    {
        auto terms = allTerms<dim>();
        const auto& own = settings.ownTerms<dim>();
        terms.insert(terms.end(), own.begin(), own.end());
        return terms;
    }
    /// Summary at the start; at a restart that of the last step, whose values were measured at its middle and cannot be seen at its end. Where the forces
    /// at its end have changed since it was written some dictionary has, and present values count.
    Summary firstSummary(const Numbers& restored)
    {
        if (!settings_.integration.moves && restored.empty())
        {
            for (const auto& stage : particles_.stages(JoinPoint::solve)) stage.run(particles_, {});
            particles_.run(JoinPoint::complete);
        }
        auto summary = measured();
        const auto restore = [&](const std::string& name, double& value)
        {
            if (const auto found = restored.find(lastName(name)); found != restored.end()) value = found->second;
        };
        const double observed = particles_.observedAcceleration();
        double written = observed;
        restore("observedAcceleration", written);
        if (written != observed)
        {
            Larger{}(summary.maxAcceleration, observed);
            return summary;
        }
        goesOn_ = !restored.empty();
        restore("maxAcceleration", summary.maxAcceleration);
        restore("maxSlowAcceleration", summary.maxSlowAcceleration);
        restore("power", summary.power);
        for (auto& [name, value] : summary.columns) restore(name, value);
        return summary;
    }
    Summary measured()
    {
        auto summary = summarise(particles_);
        particles_.setMaxSpeed(summary.maxSpeed);
        return summary;
    }
    void measure(double deltaT)
    {
        const double power = summary_.power;
        summary_ = measured();
        const double work = 0.5 * (power + summary_.power) * deltaT;
        energy_.addWork(work, work);
        energy_.addImpulse(deltaT * summary_.force);
        for (const auto& model : particles_.runningModels()) energy_.addWork(model->power() * deltaT, model->measuredPower() * deltaT);
    }

public:
    Simulation(const Settings& settings, const Geometry& geometry, Cloud cloud, const StateNumbers& restored)
        : settings_(settings),
          terms_(termsOf(settings)),
          particles_(settings, geometry, terms_, std::move(cloud), restored),
          schedule_(particles_, [this](double deltaT) { measure(deltaT); }),
          summary_(firstSummary(restored)),
          energy_(particles_, summary_)
    {
        if (goesOn_) energy_.restore(restored);
        integratorOf(settings.integration.scheme).stages(schedule_);
    }

    /// A step in several substeps makes each a step of its own, but what acts once a step does so by the whole of it and at the middle of the middle
    /// part: the impulse method of Tuckerman, Berne & Martyna (1992), reversible in time where forces depend on positions.
    void step(double time, double deltaT) override
    {
        if (settings_.integration.solvesPressure) return stepInHalves(time, deltaT);
        const int parts = settings_.integration.maxSubSteps > 1 ? partsOf(deltaT, settings_, stepLimits()) : 1;
        for (int part = 0; part < parts; ++part)
            schedule_.run({time + part * deltaT / parts, deltaT / parts, deltaT}, 2 * part + 1 == parts);
    }

    StepLimit stepLimit() const override { return leastOf(stepLimits()); }
    std::vector<StepLimit> stepLimits() const override
    {
        Measured measured{summary_.maxSpeed, summary_.maxAcceleration, summary_.maxSlowAcceleration, {}, {}};
        const auto& columns = summary_.columns;
        if (const auto least = columns.find("minViscosity"), largest = columns.find("maxViscosity");
            least != columns.end() && largest != columns.end())
        {
            measured.leastViscosity = least->second;
            measured.largestViscosity = largest->second;
        }
        std::vector<StepLimit> ofRunningModels;
        for (const auto& model : particles_.runningModels())
            for (const auto& limit : model->limits()) ofRunningModels.push_back(limit);
        return sph::stepLimits(settings_, measured, ofRunningModels);
    }
    Summary summary() const override { return summary_; }
    Vector<3> gravity() const override { return particles_.coefficients().g; }
    Energy energy() const override { return energy_.at(particles_, summary_); }

    std::map<std::string, double> powers() override { return particles_.powers(); }
    void observe() override { particles_.observe(); }
    void settle() override { particles_.settle(); }

    std::size_t total() const override { return particles_.total(); }
    std::size_t size() const override { return particles_.size(); }
    FieldView positions() const override { return field(Position::info.name); }

    FieldView field(const std::string& name) const override
    {
        const auto& fields = particles_.store().fields();
        const auto found = fields.find(name);
        if (found == fields.end()) return {name, name == Phase::info.name ? FieldClass::label : FieldClass::scalar, {nullptr}};
        std::vector<const double*> component;
        for (const auto& a : found->second.component) component.push_back(a.data());
        return fieldView(name, found->second.type, component);
    }

    std::vector<FieldView> fields() const override
    {
        std::vector<FieldView> views;
        for (const auto& [name, onDisk] : settings_.written())
        {
            views.push_back(field(name));
            views.back().name = onDisk;
        }
        return views;
    }

    StateNumbers state() const override
    {
        StateNumbers numbers;
        particles_.movingWalls().save(particles_.geometry(), numbers);
        numbers[lastName("maxAcceleration")] = summary_.maxAcceleration;
        numbers[lastName("observedAcceleration")] = particles_.observedAcceleration();
        if (summary_.maxSlowAcceleration > 0) numbers[lastName("maxSlowAcceleration")] = summary_.maxSlowAcceleration;
        numbers[lastName("power")] = summary_.power;
        if (settings_.integration.moves) energy_.save(numbers);
        for (const auto& [name, value] : summary_.columns) numbers[lastName(name)] = value;
        for (const auto& model : particles_.runningModels()) model->save(numbers);
        return numbers;
    }

    void printPlan(std::ostream& out) const override { schedule_.print(out); }
    void count() override { particles_.plan().countInto(&operations_); }
    std::map<std::string, long> counts() const override
    {
        auto all = operations_;
        all.insert(schedule_.counts().begin(), schedule_.counts().end());
        return all;
    }
    const std::map<std::string, long>& countsWithin() const override { return particles_.joinedRuns(); }
    std::string introduction() const override
    {
        return ofRunningModels([](const auto& model) { return model.introduction(); });
    }
    std::string report() const override
    {
        return ofRunningModels([&](const auto& model) { return model.report(particles_); });
    }
    std::string note() const override
    {
        const auto ofModels = ofRunningModels([](const auto& model) { return model.note(); });
        return inParts_ > 0 ? fmt::format("{}  steps in parts {}", ofModels, inParts_) : ofModels;
    }
    std::vector<std::string> warnings() override
    {
        std::vector<std::string> all;
        for (const auto& model : particles_.runningModels())
            if (auto warning = model->warning(particles_); !warning.empty()) all.push_back(std::move(warning));
        return all;
    }
    long pairPassesRun() const override { return particles_.plan().pairPassesRun(); }
    double meanNeighbours() const override
    {
        const std::size_t pairs = ofAllRanks(particles_.lists().pairs(), std::size_t(0), Add{});
        return double(pairs) / double(std::max<std::size_t>(1, particles_.total())) - 1;
    }
    std::size_t images() const override { return ofAllRanks(particles_.images().count(), std::size_t(0), Add{}); }
    long rebuilds() const override { return particles_.rebuilds(); }
    std::string reportRanks() const override
    {
        const auto* const halo = particles_.images().halo();
        if (!halo) return "";
        struct Share
        {
            std::size_t particles, images, sent;
            double busy, waited;
        };
        const auto& all = halo->all();
        const auto shares =
            OfRanks<Share>::gather(all, {particles_.size(), particles_.images().count(), halo->bytesSent(), busyTime(), all.waited().wall});
        std::string lines;
        double total = 0, largest = 0;
        for (std::size_t r = 0; r < shares.size(); ++r)
        {
            const auto& [particles, images, sent, busy, waited] = shares[r];
            lines += fmt::format("Rank {:<4}: {} particles, {} images, busy for {:.4g} s, waited for {:.4g} s, {:.4g} MB sent\n", r,
                                 particles, images, busy, waited, 1e-6 * double(sent));
            total += busy;
            largest = std::max(largest, busy);
        }
        const auto& cuts = halo->cuts();
        lines += fmt::format("Imbalance: {:.3f}", largest * double(shares.size()) / total);
        if (halo->imbalance() > 0) lines += fmt::format(", lately {:.3f}", halo->imbalance());
        lines += fmt::format(", space cut {} times", cuts.count);
        if (cuts.count > 1) lines += fmt::format(", after the first in {:.3g} s", cuts.seconds);
        if (cuts.known > 0)
            lines += fmt::format(", which left {:.3f} in the mean and at most {:.3f}", cuts.sumLeft / double(cuts.known), cuts.mostLeft);
        return lines + '\n';
    }
    Leaks leaks() const override { return ofAllRanks(particles_.leaks(), Leaks{}, Add{}); }
    double bytesPerParticle() const override { return double(particles_.bytes()) / double(std::max<std::size_t>(1, size())); }

private:
    /// A step that its solve refuses has been taken back, and is made in twice as many parts.
    void stepInHalves(double time, double deltaT)
    {
        int parts = 1;
        for (int made = 0; made < parts;)
        {
            try
            {
                schedule_.run({time + made * deltaT / parts, deltaT / parts, deltaT / parts}, true);
                ++made;
            }
            catch (const StepTooLong&)
            {
                if (parts == mostParts) throw;
                parts *= 2;
                made *= 2;
            }
        }
        inParts_ += parts > 1;
    }

    std::string ofRunningModels(const auto& words) const
    {
        std::string all;
        for (const auto& model : particles_.runningModels()) all += words(*model);
        return all;
    }
};
}

std::unique_ptr<AnySimulation> makeSimulation(const Settings& settings, const Geometry& geometry, Cloud cloud, const StateNumbers& restored)
{
    if (!settings.facts.get<OpenBoundary>().exists && ofAllRanks(cloud.size(), std::size_t(0), Add{}) == 0)
        throw CaseError("there are no particles: has packParticles been run?");
    if (geometry.dimension == 2) return std::make_unique<Simulation<2>>(settings, geometry, std::move(cloud), restored);
    return std::make_unique<Simulation<3>>(settings, geometry, std::move(cloud), restored);
}

}
