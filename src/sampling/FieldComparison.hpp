/// A field against an exact solution or a table, in norms over the particles or over the rows of a table.
#pragma once
#include "sampling/FunctionContext.hpp"
#include "sampling/Norms.hpp"
#include <functional>
#include <memory>
#include <optional>

namespace sph
{

class SampledField;

/// A row of errors.dat.
struct ErrorRow
{
    std::string field;
    Norms error;
    std::size_t particles = 0; ///< that the value rests on
    double value = 0, reference = 0;
    std::string note;
};

/// The reference at x [m] and t [s], a scalar in the first component; nothing where the reference does not reach.
using ReferenceField = std::function<std::optional<Vector<3>>(const Vector<3>& x, double t)>;

class FieldComparison
{
    std::string field_, component_;
    bool relative_, removeMean_;
    std::optional<double> scale_;
    Vector<3> cell_; ///< direction that the reference is averaged along; 0 without
    std::optional<std::size_t> phase_;
    std::optional<Box> region_;
    Location where_;
    ReferenceField reference_;
    std::vector<Vector<3>> rows_;    ///< empty: particles
    std::optional<double> meanFrom_; ///< [s]
    std::shared_ptr<std::vector<double>> sums_ =
        std::make_shared<std::vector<double>>(); ///< how many, and over them the components of each row

    struct Sample
    {
        double volume;
        Vector<3> value, exact;
    };
    int component(const SampledField&) const;
    bool within(const Vector<3>&, int dimension) const;
    std::optional<Vector<3>> referenceAt(const Vector<3>&, const ParticleView&) const;
    std::vector<Sample> atParticles(const ParticleView&, const SampledField&, int component) const;
    std::vector<Sample> atRows(const ParticleView&, const SampledField&, int component) const;
    void takeMean(std::vector<Sample>&) const;

public:
    static EntryList entries();
    /// `rows`: where the reference has its own values, which `points rows` asks for; empty of a formula.
    FieldComparison(const Dictionary&, const FunctionContext&, ReferenceField, const std::vector<Vector<3>>& rows = {});

    /// Nothing where no point has a reference at this time, or before `meanFrom`. Throws CaseError if the view has no such field. NaN where there is no
    /// particle around a row.
    std::optional<ErrorRow> operator()(const ParticleView&) const;
    /// Sums that a restart goes on from; shared by all copies.
    std::vector<double>& history() const { return *sums_; }
};

/// `norm relative|absolute;`, relative by default.
bool readsRelative(const Dictionary&);
/// "x" to "zz", empty where none is given.
std::string readComponent(const Dictionary&);

}
