#include "models/openings/OpeningAccount.hpp"
#include "parallel/reduce.hpp"
#include <numeric>
#include <tuple>
#include <utility>

namespace sph
{

template<int dim>
OpeningAccount<dim>::OpeningAccount(const OpenScene& scene, const std::vector<PlacedOpening>& placed) : scene_(scene), placed_(placed)
{
    for (const auto& evolving : scene.state)
        if (!evolving.amount.empty())
        {
            counted_.push_back(&evolving);
            amountNames_.push_back(evolving.amount);
        }
    marks_ = std::ranges::any_of(placed, [](const PlacedOpening& each) { return each.opening.markFrom.has_value(); });
    startMass_.resize(scene.phases());
    for (auto* amounts : {&startAmounts_, &intoHeld_, &sums_.heldAmounts}) amounts->resize(counted_.size());
    sums_.of.assign(placed.size(), {startMass_, startAmounts_});
    taken_.assign(placed.size(), {startMass_, startAmounts_});
}

template<int dim> void OpeningAccount<dim>::pass(FieldStore<dim>& store, std::size_t i, std::size_t opening, double sign, bool predicted)
{
    auto& to = sums_.of[opening];
    to.mass[scene_.phasesOf(store)(i)] += sign * store.component(Mass::info.name, 0)[i];
    if (marks_) mark(store, i, placed_[opening].opening, to.marked, sign);
    for (std::size_t q = 0; q < counted_.size(); ++q) to.amounts[q] += sign * amountsOf(store, *counted_[q], predicted)(i);
    if (countsEnergy_) sums_.energy += sign * energyOf(store, i);
}

/// m (v^2/2 + e(rho))
template<int dim> double OpeningAccount<dim>::energyOf(const FieldStore<dim>& store, std::size_t i) const
{
    const double m = store.component(Mass::info.name, 0)[i], rho = store.component(Density::info.name, 0)[i];
    const auto v = valueAt<Vector<dim>>(store.pointers(Velocity{}), i);
    return m * (0.5 * dot(v, v) + scene_.coefficients.stateEquation[scene_.phasesOf(store)(i)].energy(rho));
}

template<int dim>
double OpeningAccount<dim>::rateInto(const FieldStore<dim>& store, const Evolving& fraction, std::span<const int> held) const
{
    const double *m = store.component(Mass::info.name, 0), *rate = store.component(fraction.rate->name, 0);
    const auto phase = scene_.phasesOf(store);
    double into = 0;
    for (const int i : held) into += rate[i] * m[i] / scene_.coefficients.restDensity[phase(std::size_t(i))];
    return into;
}

/// What comes in is marked by the time, what leaves tells how long it was there.
template<int dim>
void OpeningAccount<dim>::mark(FieldStore<dim>& store, std::size_t i, const Opening& opening, Transit& marked, double sign)
{
    double& enteredAt = store.component(EntryTime::info.name, 0)[i];
    const double m = store.component(Mass::info.name, 0)[i];
    if (!opening.inlet)
    {
        if (enteredAt >= 0) marked.add(-sign * m, time_ - enteredAt);
        return;
    }
    if (sign > 0 && opening.markFrom && time_ >= *opening.markFrom && opening.brings(scene_.phasesOf(store)(i))) enteredAt = time_;
    if (enteredAt >= 0) marked.add(sign * m, 0);
    if (sign < 0) enteredAt = EntryTime::notMarked;
}

template<int dim> void OpeningAccount<dim>::countStart(const FieldStore<dim>& store, std::size_t owned, const std::vector<int>& takenBy)
{
    const double *holder = store.component(Holder::info.name, 0), *m = store.component(Mass::info.name, 0);
    const auto of = [&](const auto& amount)
    {
        return groupSums(
            owned, placed_.size() + 1, [&](std::size_t i) { return std::size_t(takenBy[i]); },
            [&](std::size_t i) { return takenBy[i] == 0 && holder[i] > 0 ? 0.0 : amount(i); });
    };
    const auto phase = scene_.phasesOf(store);
    for (std::size_t p = 0; p < startMass_.size(); ++p)
    {
        const auto mass = of([&](std::size_t i) { return phase(i) == p ? m[i] : 0.0; });
        startMass_[p] = std::accumulate(mass.begin(), mass.end(), 0.0);
        for (std::size_t k = 0; k < taken_.size(); ++k) taken_[k].mass[p] = mass[k + 1];
    }
    for (std::size_t q = 0; q < counted_.size(); ++q)
    {
        const auto amount = of(amountsOf(store, *counted_[q]));
        startAmounts_[q] = std::accumulate(amount.begin(), amount.end(), 0.0);
        for (std::size_t k = 0; k < taken_.size(); ++k) taken_[k].amounts[q] = amount[k + 1];
    }
}

template<int dim> void OpeningAccount<dim>::countHeld(const std::vector<std::size_t>& numbers)
{
    for (std::size_t k = 0; k < numbers.size(); ++k) sums_.of[k].held = double(numbers[k]);
}

template<int dim> void OpeningAccount<dim>::noteRates(const FieldStore<dim>& store, std::span<const int> held)
{
    for (std::size_t q = 0; q < counted_.size(); ++q)
        if (counted_[q]->rate && !counted_[q]->advancedByModel) intoHeld_[q] = rateInto(store, *counted_[q], held);
}

template<int dim> void OpeningAccount<dim>::advance(double deltaT, double time)
{
    time_ = time;
    powerOfPassing_ = std::exchange(sums_.energy, 0) / deltaT;
    for (std::size_t q = 0; q < counted_.size(); ++q) sums_.heldAmounts[q] += deltaT * intoHeld_[q];
}

template<int dim>
void OpeningAccount<dim>::withholdRate(FieldStore<dim>& store, const std::string& field, double deltaT, std::span<const int> held)
{
    for (std::size_t q = 0; q < counted_.size(); ++q)
    {
        if (counted_[q]->value.name != field) continue;
        sums_.heldAmounts[q] += deltaT * rateInto(store, *counted_[q], held);
        for (const int i : held) store.component(counted_[q]->rate->name, 0)[i] = 0;
    }
}

template<int dim> void OpeningAccount<dim>::eachShare(auto& sums, const auto& visit)
{
    const auto each = [&](auto& numbers)
    {
        for (auto& q : numbers) visit(q);
    };
    each(sums.heldAmounts);
    visit(sums.energy);
    for (auto& passed : sums.of)
    {
        each(passed.mass);
        each(passed.amounts);
        for (auto* q : {&passed.marked.mass, &passed.marked.time, &passed.marked.square, &passed.held}) visit(*q);
    }
}

template<int dim> typename OpeningAccount<dim>::Sums OpeningAccount<dim>::ofAll() const
{
    std::vector<double> own;
    eachShare(sums_, [&](double q) { own.push_back(q); });
    const auto sums = ofAllRanks(own, std::vector<double>(own.size(), 0.0), AddEach{});
    Sums all = sums_;
    auto next = sums.begin();
    eachShare(all, [&](double& q) { q = *next++; });
    return all;
}

template<int dim> void OpeningAccount<dim>::eachNumber(auto& self, auto& sums, const auto& visit)
{
    const auto& scene = self.scene_;
    for (std::size_t k = 0; k < scene.phases(); ++k) visit(scene.named("openingsStartMass", k), self.startMass_[k], false);
    if (self.marks_) visit("openingsTime", self.time_, false);
    visit("openingsEnergy", sums.energy, true);
    for (std::size_t q = 0; q < self.counted_.size(); ++q)
    {
        visit("openingsStart" + self.amountNames_[q], self.startAmounts_[q], false);
        visit("openingsHeld" + self.amountNames_[q], sums.heldAmounts[q], false);
    }
    for (std::size_t g = 0; g < self.placed_.size(); ++g)
    {
        auto& passed = sums.of[g];
        auto& taken = self.taken_[g];
        const auto& name = self.placed_[g].opening.name;
        for (std::size_t k = 0; k < scene.phases(); ++k)
        {
            visit(scene.named(name + "Mass", k), passed.mass[k], false);
            visit(scene.named(name + "Taken", k), taken.mass[k], true);
        }
        for (std::size_t q = 0; q < self.counted_.size(); ++q)
        {
            visit(name + self.amountNames_[q], passed.amounts[q], false);
            visit(name + "Taken" + self.amountNames_[q], taken.amounts[q], true);
        }
        visit(name + "Marked", passed.marked.mass, true);
        visit(name + "MarkedTime", passed.marked.time, true);
        visit(name + "MarkedSquare", passed.marked.square, true);
    }
}

template<int dim> void OpeningAccount<dim>::save(std::map<std::string, double>& numbers) const
{
    const auto whole = ofAll();
    eachNumber(*this, whole,
               [&](const std::string& name, double value, bool unlessZero)
               {
                   if (value != 0 || !unlessZero) numbers[name] = value;
               });
}

template<int dim> bool OpeningAccount<dim>::restore(const std::map<std::string, double>& numbers)
{
    auto whole = sums_;
    eachNumber(*this, whole,
               [&](const std::string& name, double& value, bool)
               {
                   if (const auto found = numbers.find(name); found != numbers.end()) value = found->second;
               });
    if (isFirstRank()) sums_ = whole;
    return numbers.contains(scene_.named("openingsStartMass", 0));
}

template<int dim> std::vector<Flow> OpeningAccount<dim>::flows() const
{
    std::vector<Flow> flows;
    const auto all = ofAll();
    for (std::size_t g = 0; g < placed_.size(); ++g)
    {
        const auto& [placed, passed, taken] = std::tie(placed_[g], all.of[g], taken_[g]);
        const auto& opening = placed.opening;
        const double let = placed.speed * placed.section.carried();
        auto ofPhases = placed.inflows;
        if (opening.inlet)
        {
            std::ranges::fill(ofPhases, 0.0);
            double sum = 0;
            for (const auto& line : placed.section.lines()) sum += line.profile;
            for (const auto& line : placed.section.lines()) ofPhases[opening.streamAt(line.foot, dim).phase] += let * line.profile / sum;
        }
        flows.push_back({opening.name, opening.inlet, placed.section.area(), std::size_t(passed.held), passed.mass, passed.amounts,
                         taken.mass, opening.inlet ? let : placed.inflow, placed.asked, ofPhases,
                         placed.pressure[opening.stream.phase] - scene_.coefficients.backgroundPressure,
                         marks_ ? std::optional(passed.marked) : std::nullopt});
    }
    return flows;
}

template<int dim> std::vector<double> OpeningAccount<dim>::freeMass(const FieldStore<dim>& store) const
{
    const double *m = store.component(Mass::info.name, 0), *holder = store.component(Holder::info.name, 0);
    return groupSums(store.owned(), scene_.phases(), scene_.phasesOf(store), [&](std::size_t i) { return holder[i] > 0 ? 0.0 : m[i]; });
}

template<int dim> double OpeningAccount<dim>::freeAmount(const FieldStore<dim>& store, const Evolving& fraction) const
{
    const double* const holder = store.component(Holder::info.name, 0);
    return sum(store.owned(), [&, amount = amountsOf(store, fraction)](std::size_t i) { return holder[i] > 0 ? 0.0 : amount(i); });
}

template<int dim> Imbalance OpeningAccount<dim>::imbalance(const FieldStore<dim>& store, const std::vector<double>& letIn) const
{
    const auto all = ofAll();
    const auto relative = [&](double now, double start, const auto& passed)
    {
        double expected = start, largest = std::max(start, now);
        for (std::size_t g = 0; g < placed_.size(); ++g)
        {
            const double through = passed(all.of[g], taken_[g]);
            expected += through;
            largest = std::max(largest, std::abs(through));
        }
        return largest > 0 ? (now - expected) / largest : 0;
    };
    Imbalance off;
    const auto free = freeMass(store);
    for (std::size_t k = 0; k < free.size(); ++k)
        off.mass.push_back(relative(free[k], startMass_[k] + (letIn.empty() ? 0 : letIn[k]),
                                    [&](const Passed& passed, const Taken& taken) { return passed.mass[k] - taken.mass[k]; }));
    for (std::size_t q = 0; q < counted_.size(); ++q)
        off.amounts.push_back(relative(freeAmount(store, *counted_[q]), startAmounts_[q] - all.heldAmounts[q],
                                       [&](const Passed& passed, const Taken& taken) { return passed.amounts[q] - taken.amounts[q]; }));
    return off;
}

template<int dim> double OpeningAccount<dim>::volume() const
{
    double sum = 0;
    const auto all = ofAll();
    for (const auto& passed : all.of)
        for (std::size_t k = 0; k < passed.mass.size(); ++k) sum += passed.mass[k] / scene_.coefficients.restDensity[k];
    return sum;
}

template class OpeningAccount<2>;
template class OpeningAccount<3>;

}
