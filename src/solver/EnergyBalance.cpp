#include "solver/EnergyBalance.hpp"
#include "base/words.hpp"
#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sph
{

namespace
{
constexpr std::pair<const char*, double Vector<3>::*> impulseComponents[]{{"impulseX", &Vector<3>::x},
                                                                          {"impulseY", &Vector<3>::y},
                                                                          {"impulseZ", &Vector<3>::z}};

template<int dim> std::vector<StoredEnergy> storedIn(const Particles<dim>& particles)
{
    std::vector<StoredEnergy> all;
    for (const auto& model : particles.runningModels())
        if (auto stored = model->energy(particles)) all.push_back(std::move(*stored));
    return all;
}
}

std::string sourceInWords(const std::map<std::string, double>& workOfEach)
{
    std::vector<std::pair<double, std::string>> all;
    for (const auto& [operation, work] : workOfEach) all.emplace_back(work, operation);
    std::sort(all.rbegin(), all.rend());
    std::vector<std::string> each;
    for (const auto& [work, operation] : all) each.push_back(fmt::format("{} {:.3g} J", operation, work));
    const bool isFed = !all.empty() && all.front().first > 0;
    return fmt::format("{}: work of {}",
                       isFed ? "what feeds it is " + all.front().second : "no operation feeds it any more, each takes energy", list(each));
}

template<int dim> EnergyBalance<dim>::EnergyBalance(const Particles<dim>& particles, const Summary& summary)
{
    const auto stored = storedIn(particles);
    given_ = summary.kineticEnergy;
    for (const bool held : {true, false})
        for (const auto& of : stored)
            if (of.isHeld == held) given_ += of.value;
    for (const auto& model : particles.runningModels()) given_ += model->supply(particles, summary.mass);
}

template<int dim> Energy EnergyBalance<dim>::at(const Particles<dim>& particles, const Summary& summary) const
{
    return {summary.kineticEnergy, storedIn(particles), given_ + mostWork_, measuredWork_, impulse_};
}

template<int dim> void EnergyBalance<dim>::addWork(double work, double measured)
{
    work_ += work;
    measuredWork_ += measured;
    mostWork_ = std::max(mostWork_, work_);
}

template<int dim> auto EnergyBalance<dim>::numbersOf(auto& self)
{
    return std::array{std::pair{"energyGiven", &self.given_}, std::pair{"work", &self.work_}, std::pair{"mostWork", &self.mostWork_},
                      std::pair{"measuredWork", &self.measuredWork_}};
}

template<int dim> void EnergyBalance<dim>::save(Numbers& numbers) const
{
    for (const auto& [name, number] : numbersOf(*this)) numbers[name] = *number;
    for (const auto& [name, c] : impulseComponents) numbers[name] = impulse_.*c;
}

template<int dim> void EnergyBalance<dim>::restore(const Numbers& numbers)
{
    if (!numbers.contains("energyGiven")) return;
    for (const auto& [name, number] : numbersOf(*this))
        if (const auto found = numbers.find(name); found != numbers.end()) *number = found->second;
    for (const auto& [name, c] : impulseComponents)
        if (const auto found = numbers.find(name); found != numbers.end()) impulse_.*c = found->second;
}

template class EnergyBalance<2>;
template class EnergyBalance<3>;

}
