#include "models/openings/Openings.hpp"

namespace sph
{

template<int dim>
Openings<dim>::Openings(const std::vector<Opening>& openings, const Geometry& geometry, const Coefficients& coefficients,
                        const State& state, const std::map<std::string, double>& restored, int supports, bool fillsInPart)
    : scene_{geometry, coefficients, state, supports * coefficients.support + spareDepth * coefficients.spacing, fillsInPart},
      placed_(placeOpenings(openings, scene_)),
      account_(scene_, placed_),
      buffer_(scene_, placed_, account_, restore(restored)),
      fit_(scene_)
{}

template<int dim> void Openings<dim>::eachNumber(auto& self, const auto& visit)
{
    for (auto& placed : self.placed_)
    {
        const auto& name = placed.opening.name;
        for (std::size_t k = 0; k < self.scene_.phases(); ++k)
        {
            visit(self.scene_.named(name + "Pressure", k), placed.pressure[k]);
            visit(self.scene_.named(name + "Slope", k), placed.slope[k]);
        }
        visit(name + "Speed", placed.speed);
    }
}

template<int dim> bool Openings<dim>::restore(const std::map<std::string, double>& numbers)
{
    eachNumber(*this,
               [&](const std::string& name, double& value)
               {
                   if (const auto found = numbers.find(name); found != numbers.end()) value = found->second;
               });
    return account_.restore(numbers);
}

template<int dim> std::map<std::string, double> Openings<dim>::state() const
{
    std::map<std::string, double> numbers;
    account_.save(numbers);
    eachNumber(*this, [&](const std::string& name, double value) { numbers[name] = value; });
    return numbers;
}

template<int dim> void Openings<dim>::hold(FieldStore<dim>& store)
{
    account_.noteRates(store, held());
    buffer_.clearRates(store);
}

template<int dim> void Openings<dim>::drive(FieldStore<dim>& store, double deltaT, double time)
{
    account_.advance(deltaT, time);
    fit_.update(placed_, store, buffer_, deltaT);
    buffer_.impose(store, deltaT);
}

template<int dim> double Openings<dim>::power() const
{
    double sum = 0;
    for (const auto& placed : placed_)
    {
        const std::size_t phase = placed.opening.stream.phase;
        const double Q = placed.opening.inlet      ? placed.speed * placed.section.carried()
                         : placed.opening.backflow ? std::max(0.0, placed.inflows[phase])
                                                   : 0;
        const double u = placed.opening.inlet ? placed.speed : Q / placed.section.area();
        sum += Q * std::max(0.0, placed.pressure[phase] - scene_.coefficients.backgroundPressure + 0.5 * placed.density * sqr(u));
    }
    return sum;
}

template class Openings<2>;
template class Openings<3>;

}
