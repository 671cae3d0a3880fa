#include "Profile.hpp"
#include "Interpolator.hpp"
#include "SampledField.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

Profile::Profile(const Dictionary& d, const FunctionContext& context)
    : context_(context),
      start_(d.get<Vector<3>>("start")),
      end_(d.get<Vector<3>>("end")),
      fields_(d.get<std::vector<std::string>>("fields")),
      fieldsWhere_(d.where("fields")),
      points_(d.get("nPoints", 0)),
      bins_(d.get("bins", 0))
{
    if (!(mag(end_ - start_) > 0)) d.error("end", "start and end of a profile must differ");
    if (d.found("nPoints") == d.found("bins")) d.error("nPoints", "a profile needs either nPoints or bins");
    if (d.found("nPoints") && points_ < 2) d.error("nPoints", "nPoints must be at least 2");
    if (d.found("bins") && bins_ < 1) d.error("bins", "bins must be at least 1");
}

void Profile::execute(const ParticleView& view)
{
    std::vector<std::string> columns{"distance"};
    for (const auto& name : fields_)
        for (auto& column : columnNames(SampledField(view, name, fieldsWhere_))) columns.push_back(std::move(column));
    if (bins_ > 0) columns.push_back("nParticles");
    writeFile(context_.fileOfTime(fmt::format("{}_{}.xy", bins_ > 0 ? "bins" : "line", fmt::join(fields_, "_"))),
              fmt::format("# {}\n{}", fmt::join(columns, "\t"), bins_ > 0 ? binRows(view) : pointRows(view)));
}

std::string Profile::pointRows(const ParticleView& view) const
{
    const Interpolator interpolator(view);
    std::string rows;
    for (int k = 0; k < points_; ++k)
    {
        const auto along = double(k) / (points_ - 1) * (end_ - start_);
        const auto weights = interpolator.weights(start_ + along);
        rows += cell(mag(along));
        for (const auto& name : fields_)
        {
            const SampledField field(view, name, fieldsWhere_);
            for (int c = 0; c < field.components(); ++c) rows += "\t" + cell(weights(field.array(c)));
        }
        rows += "\n";
    }
    return rows;
}

std::string Profile::binRows(const ParticleView& view) const
{
    const double length = mag(end_ - start_);
    const auto direction = (end_ - start_) / length;
    const auto binOf = [&](std::size_t i) { return std::floor(dot(position(view, i) - start_, direction) / length * bins_); };
    const auto bins = std::size_t(bins_);

    std::vector<double> volume(bins, 0.0);
    std::vector<long> particles(bins, 0);
    for (std::size_t i = 0; i < view.n; ++i)
        if (const double b = binOf(i); b >= 0 && b < bins_)
        {
            volume[std::size_t(b)] += view.volume[i];
            ++particles[std::size_t(b)];
        }
    std::vector<std::vector<double>> means;
    for (const auto& name : fields_)
    {
        const SampledField field(view, name, fieldsWhere_);
        for (int c = 0; c < field.components(); ++c)
        {
            auto& mean = means.emplace_back(bins, 0.0);
            for (std::size_t i = 0; i < view.n; ++i)
                if (const double b = binOf(i); b >= 0 && b < bins_) mean[std::size_t(b)] += view.volume[i] * field(c, i);
        }
    }
    std::string rows;
    for (std::size_t b = 0; b < bins; ++b)
    {
        rows += cell((double(b) + 0.5) * length / bins_);
        for (const auto& mean : means) rows += "\t" + cell(mean[b] / volume[b]);
        rows += fmt::format("\t{}\n", particles[b]);
    }
    return rows;
}

}
