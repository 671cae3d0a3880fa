#include "sampling/Profile.hpp"
#include "parallel/reduce.hpp"
#include "sampling/Interpolator.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace entry
{
const VectorParameter start{"start", units::m, required, "where the line begins"}, end{"end", units::m, required, "where the line ends"};
const Count nPoints{"nPoints", notGiven, atLeast(2), "number of points at which fields are interpolated"},
    bins{"bins", notGiven, atLeast(1), "in place of nPoints: number of slabs across the line whose means are taken"};
}

namespace column
{
const Column distance{"distance", "m", "from `start`; with `bins` to the middle of the slab"},
    onLine{"<field>", "of the field",
           "its value there, or with `bins` the mean of the slab; of a vector or tensor one column a component, U_x"},
    particles{"nParticles", "-", "with `bins`: particles in the slab"};
}

Profile::Profile(const Dictionary& d, const FunctionContext& context)
    : context_(context), start_(entry::start(d)), end_(entry::end(d)), sampled_(d), points_(entry::nPoints(d, 0)), bins_(entry::bins(d, 0))
{
    if (!(mag(end_ - start_) > 0)) entry::end.error(d, "start and end of a profile must differ");
    if (entry::nPoints.given(d) == entry::bins.given(d)) entry::nPoints.error(d, "a profile needs either nPoints or bins");
}

EntryList Profile::entries()
{
    return EntryList{entry::start, entry::end} + SampledValues::entries() + EntryList{entry::nPoints, entry::bins};
}

TableInfo Profile::table()
{
    return {"profile",
            "line_<fields>.xy, bins_<fields>.xy",
            "fields and expressions along a line, one file a time, in the folder of that time",
            {column::distance, column::onLine, column::particles}};
}

void Profile::execute(const ParticleView& view)
{
    std::vector<std::string> columns{column::distance.name};
    const auto values = sampled_(view);
    for (const auto& value : values) columns.insert(columns.end(), value.columns.begin(), value.columns.end());
    if (bins_ > 0) columns.push_back(column::particles.name);
    writeFile(context_.fileOfTime(fmt::format("{}_{}.xy", bins_ > 0 ? "bins" : "line", fmt::join(sampled_.names(), "_"))),
              fmt::format("# {}\n{}", fmt::join(columns, "\t"), bins_ > 0 ? binRows(view, values) : pointRows(view, values)));
}

std::string Profile::pointRows(const ParticleView& view, const std::vector<SampledValues::Value>& values) const
{
    const Interpolator interpolator(view);
    std::string rows;
    for (int k = 0; k < points_; ++k)
    {
        const auto along = double(k) / (points_ - 1) * (end_ - start_);
        const auto weights = interpolator.weights(start_ + along);
        rows += cell(mag(along));
        for (const auto& value : values)
            for (std::size_t c = 0; c < value.columns.size(); ++c) rows += "\t" + cell(weights(value.component(c)));
        rows += "\n";
    }
    return rows;
}

std::string Profile::binRows(const ParticleView& view, const std::vector<SampledValues::Value>& values) const
{
    const double length = mag(end_ - start_);
    const auto direction = (end_ - start_) / length;
    const auto bins = std::size_t(bins_);
    const auto binOf = [&](std::size_t i)
    {
        const double b = std::floor(dot(position(view, i) - start_, direction) / length * bins_);
        return b >= 0 && b < bins_ ? std::size_t(b) : bins;
    };
    const auto particles = groupSums(view.n, bins, binOf, [](std::size_t) { return std::size_t(1); });
    std::vector<std::vector<VolumeMean<>>> means;
    for (const auto& value : values)
        for (std::size_t c = 0; c < value.columns.size(); ++c)
            means.push_back(groupSums(view.n, bins, binOf,
                                      [&, f = value.component(c)](std::size_t i)
                                      { return VolumeMean<>::of(view.volume[i], f ? f[i] : 0); }));
    std::string rows;
    for (std::size_t b = 0; b < bins; ++b)
    {
        rows += cell((double(b) + 0.5) * length / bins_);
        for (const auto& mean : means) rows += "\t" + cell(mean[b].value());
        rows += fmt::format("\t{}\n", particles[b]);
    }
    return rows;
}

}
