#include "models/openings/BoundaryFit.hpp"
#include "parallel/reduce.hpp"
#include <limits>
#include <tuple>

namespace sph
{

template<int dim> typename BoundaryFit<dim>::Sums& BoundaryFit<dim>::Sums::operator+=(const Sums& b)
{
    count += b.count;
    n += b.n;
    v0 += b.v0;
    s1 += b.s1;
    s2 += b.s2;
    p0 += b.p0;
    p1 += b.p1;
    flow += b.flow;
    return *this;
}

template<int dim> typename BoundaryFit<dim>::LineSums& BoundaryFit<dim>::LineSums::operator+=(const LineSums& b)
{
    n += b.n;
    v0 += b.v0;
    others += b.others;
    held += b.held;
    heldV += b.heldV;
    return *this;
}

template<int dim>
typename BoundaryFit<dim>::Sums BoundaryFit<dim>::sumsOf(const FieldStore<dim>& store, const Opening& opening, std::span<const int> near,
                                                         const auto& counts) const
{
    const auto x = store.pointers(Position{}), v = store.pointers(Velocity{});
    const double *const p = store.component(Pressure::info.name, 0), *const m = store.component(Mass::info.name, 0);
    std::size_t count = 0;
    double n = 0, v0 = 0, s1 = 0, s2 = 0, p0 = 0, p1 = 0, flow = 0;
    for (const int i : near)
    {
        if (!counts(std::size_t(i))) continue;
        const double s = opening.distance(in3D(valueAt<Vector<dim>>(x, std::size_t(i)))), w = weight(s);
        const double v_n = dot(in3D(valueAt<Vector<dim>>(v, std::size_t(i))), opening.normal);
        ++count;
        n += w;
        v0 += w * v_n;
        flow += w * v_n * m[i];
        s1 += w * s;
        s2 += w * s * s;
        p0 += w * p[i];
        p1 += w * s * p[i];
    }
    return {n, v0, s1, p0, s2, double(count), p1, flow};
}

template<int dim>
std::vector<typename BoundaryFit<dim>::Sums> BoundaryFit<dim>::sumsNear(const std::vector<PlacedOpening>& all, const FieldStore<dim>& store,
                                                                        const BufferZone<dim>& buffer) const
{
    const auto phase = scene_.phasesOf(store);
    std::vector<Sums> sums;
    for (std::size_t g = 0; g < all.size(); ++g)
    {
        const auto sumOver = [&](const auto& counts) { sums.push_back(sumsOf(store, all[g].opening, buffer.near(g), counts)); };
        sumOver([](std::size_t) { return true; });
        for (std::size_t k = 0; k + 1 < sumsOfOpening(); ++k) sumOver([&](std::size_t i) { return phase(i) == k; });
    }
    return ofAllRanks(sums, std::vector<Sums>(sums.size()), AddEach{});
}

template<int dim>
std::vector<typename BoundaryFit<dim>::LineSums> BoundaryFit<dim>::sumsOfLines(const std::vector<PlacedOpening>& all,
                                                                               const FieldStore<dim>& store,
                                                                               const BufferZone<dim>& buffer) const
{
    const auto x = store.pointers(Position{}), v = store.pointers(Velocity{});
    const double* const m = scene_.phases() > 1 ? store.component(Mass::info.name, 0) : nullptr;
    const double* const holder = store.component(Holder::info.name, 0);
    const auto phase = scene_.phasesOf(store);
    std::vector<LineSums> sums;
    for (std::size_t g = 0; g < all.size(); ++g)
    {
        const auto& [opening, section] = std::tie(all[g].opening, all[g].section);
        if (opening.inlet) continue;
        const std::size_t first = sums.size();
        sums.resize(first + section.lines().size());
        for (const int near : buffer.near(g))
        {
            const auto i = std::size_t(near);
            const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
            const int line = section.lineAt(x_i);
            if (line < 0) continue;
            auto& along = sums[first + std::size_t(line)];
            const double w = weight(opening.distance(x_i)) * (m ? m[i] : 1);
            along.v0 += w * dot(in3D(valueAt<Vector<dim>>(v, i)), opening.normal);
            along.n += w;
            along.others += phase(i) != opening.stream.phase;
        }
        // A line that keeps what it has is filled up all the same.
        for (const int held : buffer.held())
        {
            const auto i = std::size_t(held);
            if (!opening.backflow || std::size_t(holder[i]) != g + 1) continue;
            const int line = section.lineAt(in3D(valueAt<Vector<dim>>(x, i)));
            if (line < 0) continue;
            sums[first + std::size_t(line)].heldV += dot(in3D(valueAt<Vector<dim>>(v, i)), opening.normal);
            ++sums[first + std::size_t(line)].held;
        }
    }
    return ofAllRanks(sums, std::vector<LineSums>(sums.size()), AddEach{});
}

/// p = a + b s by least squares.
template<int dim> typename BoundaryFit<dim>::Fit BoundaryFit<dim>::fit(const Opening& opening, double a, const Sums& near) const
{
    const auto& [n, v0, s1, p0, s2, count, p1, flow] = near;
    Fit fit{near, a, 0, false};
    const double spread = n * s2 - s1 * s1;
    fit.enough = count > 2 && spread > sqr(0.25 * scene_.coefficients.spacing * n); // more than a row
    if (opening.inlet)
    {
        fit.slope = fit.enough ? (n * p1 - s1 * p0) / spread : 0;
        fit.pressure = n > 0 ? (p0 - fit.slope * s1) / n : scene_.coefficients.backgroundPressure;
    }
    else fit.slope = fit.enough ? (p1 - a * s1) / s2 : 0;
    return fit;
}

/// A phase of which there is not enough before the plane has the pressure of all fluid there. At an outlet beside the phase that may come back others
/// have its pressure and, as a constant, what they have more than it in the mean: the jump across their surface, which is not the outlet's to give. What comes
/// back starts from rest at the outlet's pressure: a = p - rho u^2/2, u its mean velocity inwards.
template<int dim> void BoundaryFit<dim>::measure(PlacedOpening& placed, std::span<const Sums> near) const
{
    const auto& opening = placed.opening;
    const double area = placed.section.area();
    const auto& ofAll = near[0];
    const auto ofPhase = [&](std::size_t k) -> const Sums& { return near[std::min(1 + k, near.size() - 1)]; };
    double given = opening.inlet ? 0 : scene_.coefficients.backgroundPressure + opening.pressure.value_or(0);
    if (opening.backflow)
    {
        const auto& back = ofPhase(opening.stream.phase);
        given -= 0.5 * placed.density * sqr(back.n > 0 ? std::max(0.0, back.v0 / back.n) : 0);
    }
    const auto all = fit(opening, given, ofAll);
    const auto inflow = [&](const Sums& of)
    {
        return scene_.fillsInPart ? of.flow / (scene_.coefficients.restDensity.front() * wholeWeight())
               : ofAll.n > 0      ? area * of.v0 / ofAll.n
                                  : 0;
    };
    placed.inflow = inflow(ofAll);
    std::vector<Fit> fits;
    for (std::size_t k = 0; k < scene_.phases(); ++k) fits.push_back(fit(opening, given, ofPhase(k)));
    const auto& gas = fits[opening.stream.phase];
    for (std::size_t k = 0; k < scene_.phases(); ++k)
    {
        const auto& own = fits[k];
        const auto& used = own.enough ? own : all;
        placed.inflows[k] = inflow(own.of);
        placed.pressure[k] = used.pressure;
        placed.slope[k] = opening.letsFall() ? 0 : used.slope;
        if (!opening.backflow || k == opening.stream.phase || !gas.enough || own.of.n == 0) continue;
        placed.slope[k] = gas.slope;
        placed.pressure[k] = (own.of.p0 - gas.slope * own.of.s1) / own.of.n;
    }
}

/// Along the normal, of each line of an outlet [m/s]; infinite where its particles keep what they have, for none comes along behind them. Of several phases
/// the mean is by mass: liquid decides. Inwards goes what comes back in alone: a line along which another phase comes stands still.
template<int dim> std::vector<double> BoundaryFit<dim>::velocities(const Opening& opening, std::span<const LineSums> lines) const
{
    if (opening.letsFall()) return std::vector<double>(lines.size(), std::numeric_limits<double>::infinity());
    std::vector<double> velocities;
    for (const auto& along : lines)
    {
        const double u = along.n > 0      ? along.v0 / along.n
                         : along.held > 0 ? along.heldV / along.held
                                          : std::numeric_limits<double>::infinity();
        const bool mayReturn = opening.backflow && along.others == 0;
        velocities.push_back(along.n > 0 && !mayReturn ? std::min(0.0, u) : u);
    }
    return velocities;
}

template<int dim>
void BoundaryFit<dim>::update(std::vector<PlacedOpening>& all, const FieldStore<dim>& store, const BufferZone<dim>& buffer,
                              double deltaT) const
{
    const auto near = sumsNear(all, store, buffer);
    const auto alongLines = sumsOfLines(all, store, buffer);
    std::size_t ofOpening = 0, firstLine = 0;
    for (auto& placed : all)
    {
        const auto& opening = placed.opening;
        measure(placed, std::span(near).subspan(ofOpening, sumsOfOpening()));
        ofOpening += sumsOfOpening();
        if (!opening.inlet)
        {
            const auto lines = placed.section.lines().size();
            placed.velocity = velocities(opening, std::span(alongLines).subspan(firstLine, lines));
            firstLine += lines;
            continue;
        }
        if (opening.pressure)
        {
            const double behind = *opening.pressure + scene_.coefficients.backgroundPressure;
            const double p = placed.pressure[opening.stream.phase];
            placed.speed = std::clamp(placed.speed + deltaT * (behind - p) / (placed.density * scene_.bufferDepth), 0.0, placed.most);
        }
        std::ranges::transform(placed.section.lines(), placed.velocity.begin(),
                               [&](const auto& line) { return placed.speed * line.profile; });
    }
}

template class BoundaryFit<2>;
template class BoundaryFit<3>;

}
