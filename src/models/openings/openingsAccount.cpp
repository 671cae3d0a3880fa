/// The account of openings: the amounts that have passed and are there, and the mass-balance error.
#include "Openings.hpp"
#include "reduce.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sph
{

/// Amounts of the free and the removed particles at the start; of the latter by the opening that removes them.
template<int dim> void Openings<dim>::countStart(const FieldStore<dim>& store, std::size_t owned, const std::vector<int>& takenBy)
{
    const double *holder = store.component(Holder::info.name, 0), *m = store.component(Mass::info.name, 0);
    const auto of = [&](const auto& amount)
    {
        return groupSums(
            owned, gates_.size() + 1, [&](std::size_t i) { return std::size_t(takenBy[i]); },
            [&](std::size_t i) { return takenBy[i] == 0 && holder[i] > 0 ? 0.0 : amount(i); });
    };
    const auto phase = phasesOf(store);
    for (std::size_t p = 0; p < phases_; ++p)
    {
        const auto mass = of([&](std::size_t i) { return phase(i) == p ? m[i] : 0.0; });
        startMass_[p] = std::accumulate(mass.begin(), mass.end(), 0.0);
        for (std::size_t k = 0; k < gates_.size(); ++k) gates_[k].taken[p] = mass[k + 1];
    }
    for (std::size_t q = 0; q < counted_.size(); ++q)
    {
        const auto amount = of(amounts(store, *counted_[q]));
        startAmounts_[q] = std::accumulate(amount.begin(), amount.end(), 0.0);
        for (std::size_t k = 0; k < gates_.size(); ++k) gates_[k].takenAmounts[q] = amount[k + 1];
    }
}

template<int dim> void Openings<dim>::eachShare(auto& account, const auto& visit)
{
    const auto each = [&](auto& numbers)
    {
        for (auto& q : numbers) visit(q);
    };
    each(account.heldAmounts);
    for (auto& passed : account.gates)
    {
        each(passed.mass);
        each(passed.amounts);
        for (auto* q : {&passed.marked.mass, &passed.marked.time, &passed.marked.square, &passed.held}) visit(*q);
    }
}

template<int dim> typename Openings<dim>::Account Openings<dim>::account() const
{
    std::vector<double> own;
    eachShare(account_, [&](double q) { own.push_back(q); });
    const auto sums = ofAllRanks(own, std::vector<double>(own.size(), 0.0), AddEach{});
    Account all = account_;
    auto next = sums.begin();
    eachShare(all, [&](double& q) { q = *next++; });
    return all;
}

template<int dim> std::vector<Flow> Openings<dim>::flows() const
{
    std::vector<Flow> flows;
    const auto all = account();
    for (const auto& gate : gates_)
    {
        const auto& passed = all.gates[flows.size()];
        const double let = gate.speed * gate.section.carried();
        auto ofPhases = gate.inflows;
        if (gate.opening.inlet)
        {
            std::ranges::fill(ofPhases, 0.0);
            double sum = 0;
            for (const auto& line : gate.section.lines()) sum += line.profile;
            for (const auto& line : gate.section.lines()) ofPhases[gate.opening.streamAt(line.foot, dim).phase] += let * line.profile / sum;
        }
        flows.push_back({gate.opening.name, gate.opening.inlet, gate.section.area(), std::size_t(passed.held), passed.mass, passed.amounts,
                         gate.taken, gate.opening.inlet ? let : gate.inflow, gate.asked, ofPhases,
                         gate.pressure[gate.opening.stream.phase] - coefficients_.backgroundPressure,
                         marks_ ? std::optional(passed.marked) : std::nullopt});
    }
    return flows;
}

template<int dim> void Openings<dim>::withholdRate(FieldStore<dim>& store, const std::string& field, double deltaT)
{
    const double* const m = store.component(Mass::info.name, 0);
    const auto phase = phasesOf(store);
    for (std::size_t q = 0; q < counted_.size(); ++q)
    {
        if (counted_[q]->value.name != field) continue;
        double* const rate = store.component(counted_[q]->rate->name, 0);
        double intoHeld = 0;
        for (const int i : held_)
        {
            intoHeld += deltaT * rate[i] * m[i] / coefficients_.restDensity[phase(std::size_t(i))];
            rate[i] = 0;
        }
        account_.heldAmounts[q] += intoHeld;
    }
}

template<int dim> std::vector<double> Openings<dim>::freeMass(const FieldStore<dim>& store) const
{
    const double *m = store.component(Mass::info.name, 0), *holder = store.component(Holder::info.name, 0);
    return groupSums(store.owned(), phases_, phasesOf(store), [&](std::size_t i) { return holder[i] > 0 ? 0.0 : m[i]; });
}

template<int dim> double Openings<dim>::freeAmount(const FieldStore<dim>& store, const Evolving& fraction) const
{
    const double* const holder = store.component(Holder::info.name, 0);
    return sum(store.owned(), [&, amount = amounts(store, fraction)](std::size_t i) { return holder[i] > 0 ? 0.0 : amount(i); });
}

template<int dim> Imbalance Openings<dim>::imbalance(const FieldStore<dim>& store) const
{
    const auto all = account();
    const auto relative = [&](double now, double start, const auto& passed)
    {
        double expected = start, largest = std::max(start, now);
        for (std::size_t g = 0; g < gates_.size(); ++g)
        {
            const double through = passed(all.gates[g], gates_[g]);
            expected += through;
            largest = std::max(largest, std::abs(through));
        }
        return largest > 0 ? (now - expected) / largest : 0;
    };
    Imbalance off;
    const auto free = freeMass(store);
    for (std::size_t k = 0; k < phases_; ++k)
        off.mass.push_back(
            relative(free[k], startMass_[k], [&](const Passed& passed, const Gate& gate) { return passed.mass[k] - gate.taken[k]; }));
    for (std::size_t q = 0; q < counted_.size(); ++q)
        off.amounts.push_back(relative(freeAmount(store, *counted_[q]), startAmounts_[q] - all.heldAmounts[q],
                                       [&](const Passed& passed, const Gate& gate) { return passed.amounts[q] - gate.takenAmounts[q]; }));
    return off;
}

template<int dim> double Openings<dim>::volume() const
{
    double sum = 0;
    const auto all = account();
    for (const auto& passed : all.gates)
        for (std::size_t k = 0; k < phases_; ++k) sum += passed.mass[k] / coefficients_.restDensity[k];
    return sum;
}

template<int dim> double Openings<dim>::power() const
{
    double sum = 0;
    for (const auto& gate : gates_)
    {
        const std::size_t phase = gate.opening.stream.phase;
        const double Q = gate.opening.inlet      ? gate.speed * gate.section.carried()
                         : gate.opening.backflow ? std::max(0.0, gate.inflows[phase])
                                                 : 0;
        const double u = gate.opening.inlet ? gate.speed : Q / gate.section.area();
        sum += Q * std::max(0.0, gate.pressure[phase] - coefficients_.backgroundPressure + 0.5 * gate.density * sqr(u));
    }
    return sum;
}

template class Openings<2>;
template class Openings<3>;

}
