/// Guard that keeps particles out of the solid: at every rebuild of the lists each lies in the domain, and off the union of all solids.
///
/// It wraps positions across periodic faces. A particle nearer to a wall than `closestInSpacings` is put there, and loses what velocity it has into
/// the wall. One deeper in a solid than that has leaked: it is counted, and put back, removed or the end of the run, as the dictionary says. One more
/// than half a spacing deep or outside the domain is removed or an error: from there the way back may lead out on the other side.
#pragma once
#include "dictionary/EntryList.hpp"
#include "fields/FieldStore.hpp"
#include "geometry/NearWalls.hpp"
#include <array>
#include <optional>
#include <vector>

namespace sph
{

/// What becomes of a particle that is found in a solid.
enum class LeakAction
{
    putBack,
    remove,
    stop
};

/// leakedParticles  putBack | remove | stop;      default putBack
LeakAction readLeakGuard(const Dictionary& sphSchemes);
EntryList leakGuardEntries();

/// Account of leaked particles since the start of the run.
struct Leaks
{
    long putBack = 0, removed = 0;
    double removedMass = 0; ///< [kg], per metre of depth in 2-D
    double deepest = 0;     ///< [m]
    Vector<3> at;           ///< of the deepest
    int patch = -1;         ///< likewise; -1 of what was removed for being outside the domain

    long count() const { return putBack + removed; }
    /// Adds the leaks of another rank.
    Leaks& operator+=(const Leaks& other)
    {
        const auto& deeper = other.deepest > deepest ? other : *this;
        *this = {
            putBack + other.putBack, removed + other.removed, removedMass + other.removedMass, deeper.deepest, deeper.at, deeper.patch};
        return *this;
    }
};

template<int dim> class LeakGuard
{
public:
    static constexpr double closestInSpacings = 0.02;

private:
    const Geometry& geometry_;
    double spacing_, support_; ///< [m]
    LeakAction action_;
    Leaks leaks_;

    struct Found
    {
        bool lost = false;
        double depth = 0; ///< in a solid [m], before it was put back
        int patch = -1;
    };
    using Velocities = std::vector<std::array<double*, dim>>;
    Found keep(const std::array<double*, dim>& x, const Velocities&, std::size_t i, const NearWalls&) const;
    template<class Depth> std::optional<Vector<dim>> nearestWayOut(const Vector<dim>& x, const Depth& depth) const;
    void note(const Found&, const Vector<3>& at);
    std::size_t remove(FieldStore<dim>&, std::size_t owned, std::vector<std::size_t>& which);
    [[noreturn]] void refuse(std::size_t i, const Vector<3>& x, const Found&) const;

public:
    LeakGuard(const Geometry& geometry, double spacing, double support, LeakAction action)
        : geometry_(geometry), spacing_(spacing), support_(support), action_(action)
    {}
    /// Guards the first `owned` particles, and returns how many are left; throws CaseError where one is beyond help.
    std::size_t operator()(FieldStore<dim>&, std::size_t owned, const NearWalls&);
    const Leaks& leaks() const { return leaks_; }
};

}
