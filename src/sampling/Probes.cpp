#include "sampling/Probes.hpp"
#include "sampling/Interpolator.hpp"
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const ListOf<Vector<3>> probeLocations{"probeLocations", units::m, required, "points, inside the domain"};
}

namespace
{

bool inside(const Geometry& g, const Vector<3>& x)
{
    const auto within = [&](int k, double low, double value, double high)
    { return g.periodic[std::size_t(k)] || (value >= low && value <= high); };
    return within(0, g.low.x, x.x, g.high.x) && within(1, g.low.y, x.y, g.high.y) &&
           (g.dimension == 2 || within(2, g.low.z, x.z, g.high.z));
}

}

namespace column
{
const Column probe{"<k>", "of the field", "the field at the k-th point; (x y z) of a vector"};
}

Probes::Probes(const Dictionary& d, const FunctionContext& context) : context_(context), sampled_(d), locations_(entry::probeLocations(d))
{
    for (std::size_t k = 0; k < locations_.size(); ++k)
        if (!inside(context.geometry, locations_[k]))
            entry::probeLocations.error(d, fmt::format("probe {} at {} lies outside the domain from {} to {}", k, cell(locations_[k]),
                                                       cell(context.geometry.low), cell(context.geometry.high)));
}

EntryList Probes::entries() { return SampledValues::entries() + EntryList{entry::probeLocations}; }

TableInfo Probes::table() { return {"probes", "<field>", "a field or expression at points, one file each", {column::probe}}; }

void Probes::execute(const ParticleView& view)
{
    const Interpolator interpolator(view);
    std::vector<PointWeights> weights;
    for (const auto& x : locations_) weights.push_back(interpolator.weights(x));

    for (const auto& value : sampled_(view))
    {
        const auto& name = value.name;
        if (!files_.contains(name))
        {
            std::vector<std::string> header;
            std::vector<Column> columns;
            for (std::size_t k = 0; k < locations_.size(); ++k)
            {
                header.push_back(fmt::format("Probe {} {}", k, cell(locations_[k])));
                columns.push_back({fmt::format("{}", k), "", ""}); // OpenFOAM's layout has the line above alone
            }
            files_.try_emplace(name, context_.file(name), header, columns);
        }
        std::vector<std::string> cells;
        for (const auto& w : weights)
        {
            std::string values;
            for (std::size_t c = 0; c < value.columns.size(); ++c) values += (c ? " " : "") + cell(w(value.component(c)));
            cells.push_back(value.columns.size() == 1 ? values : "(" + values + ")");
        }
        files_.at(name).row(view.time, cells);
    }
}

}
