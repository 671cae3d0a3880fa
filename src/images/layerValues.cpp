/// Values that particles of wall layers have of their own, summed over the fluid:
///
///   p_j = sum_i W_ij p_g(p_i, d_i, d_j)/sum_i W_ij            and any field whose tag says `extrapolated`
///   q_j = sum_i w_ij q_g(q_i, d_i, d_j)                       of fields that a scene interpolates; w_ij as in LayerFit.hpp
///
/// The first sum is that of Adami, Hu & Adams (2012), eq. (27).
#include "images/LayerFit.hpp"
#include "images/layerPairs.hpp"

namespace sph
{

template<int dim> template<class Sums> void WallLayers<dim>::addOtherRanks(std::vector<Sums>& sums) const
{
    if (!halo_) return;
    static_assert(std::is_trivially_copyable_v<Sums>);
    std::vector<std::vector<Sums>> mine, others;
    for (const auto& [_, originals] : sharers_)
    {
        auto& part = mine.emplace_back();
        for (const int k : originals) part.push_back(sums[std::size_t(k)]);
        others.emplace_back(originals.size());
    }
    std::vector<Ranks::Message> send, receive;
    for (std::size_t s = 0; s < sharers_.size(); ++s)
    {
        send.push_back({sharers_[s].rank, std::as_writable_bytes(std::span(mine[s]))});
        receive.push_back({sharers_[s].rank, std::as_writable_bytes(std::span(others[s]))});
    }
    halo_->all().exchange(send, receive);
    for (std::size_t s = 0; s < sharers_.size(); ++s)
        for (std::size_t q = 0; q < others[s].size(); ++q) sums[std::size_t(sharers_[s].originals[q])] += others[s][q];
}

template<int dim>
void WallLayers<dim>::extrapolate(FieldStore<dim>& store, const std::string& field, const AnyGhostRule* rule, Extrapolation how) const
{
    const auto& type = store.fields().at(field).type;
    const auto as = [&]<class Value>(Value) { extrapolateAs<Value>(store, field, dynamic_cast<const GhostRule<Value, dim>*>(rule), how); };
    if (type == valueType<double>) as(0.0);
    else withDirectedValue<dim>(type, as);
}

template<int dim>
template<class Value>
void WallLayers<dim>::extrapolateAs(FieldStore<dim>& store, const std::string& field, const GhostRule<Value, dim>* rule,
                                    Extrapolation how) const
{
    const auto x = store.pointers(Position{});
    std::array<double*, std::size_t(components<Value>)> q;
    for (std::size_t c = 0; c < q.size(); ++c) q[c] = store.component(field, int(c));
    const auto& particles = placed();
    const auto originals = firstPair_.size() - 1;
    std::vector<LayerFit<dim>> fits(how == Extrapolation::fit ? originals : 0);
    std::vector<Value> sums(originals);
    std::vector<double> weights(originals);
    std::visit(
        [&](const auto& kernel)
        {
            const auto forEachSeen = [&](std::size_t k, const auto& f)
            {
                for (std::size_t pair = firstPair_[k]; pair < firstPair_[k + 1]; ++pair)
                {
                    const auto [i, j] = pairs_[pair];
                    const Particle& particle = particles[std::size_t(j)];
                    const auto x_i = valueAt<Vector<dim>>(x, i);
                    if (const double r = mag(x_i - particle.x); r < kernel.H) f(std::size_t(i), x_i, particle, kernel.W(r));
                }
            };
#pragma omp parallel for schedule(static)
            for (std::size_t k = 0; k < fits.size(); ++k)
            {
                LayerFit<dim> fit;
                for (const Behind& behind : wallsOf(particles_[k])) fit.addWall(in<dim>(behind.foot.normal));
                forEachSeen(k, [&](std::size_t, Vector<dim> x_i, const Particle& particle, double W) { fit.add(W, x_i - particle.x); });
                fits[k] = fit;
            }
            if (how == Extrapolation::fit) addOtherRanks(fits);
#pragma omp parallel for schedule(static)
            for (std::size_t k = 0; k < originals; ++k)
            {
                std::optional<LayerFit<dim>> fit;
                if (how == Extrapolation::fit)
                {
                    fit = fits[k];
                    fit->solve(kernel.H);
                }
                Value sum{};
                double weight = 0;
                forEachSeen(k,
                            [&](std::size_t i, Vector<dim> x_i, const Particle& particle, double W)
                            {
                                auto q_j = valueAt<Value>(q, i);
                                if (rule)
                                    for (const Behind& behind : wallsOf(particle))
                                        q_j =
                                            (*rule)(q_j, i,
                                                    reflection(behind, Feet(*this, x_i).on(behind).distance, std::size_t(particle.walls)));
                                if (fit) W *= (*fit)(x_i - particle.x);
                                sum += W * q_j;
                                weight += W;
                            });
                sums[k] = sum;
                weights[k] = weight;
            }
            addOtherRanks(sums);
            addOtherRanks(weights);
        },
        kernel_.choice());
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < particles.size(); ++k)
    {
        const auto original = std::size_t(particles[k].original);
        const double weight = weights[original];
        sph::store(sums[original], [&](int c, double a) { q[std::size_t(c)][first_ + k] = weight > 0 ? a / weight : 0; });
    }
}

template void WallLayers<2>::extrapolate(FieldStore<2>&, const std::string&, const AnyGhostRule*, Extrapolation) const;
template void WallLayers<3>::extrapolate(FieldStore<3>&, const std::string&, const AnyGhostRule*, Extrapolation) const;

}
