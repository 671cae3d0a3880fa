/// Gas in a band around the liquid, at a constant pressure: gas joins where the liquid bares its surface, and goes where it has passed.
///
/// Before particles are sorted:
///  * Gas farther from all liquid than the band and a spacing goes. That which liquid and walls enclose (LiquidMap.hpp) stays and has its state equation; all other gas is
///    ambient (AmbientGas.hpp), and stands still in the outer support of the band.
///  * Places of a cubic lattice in the part that stands still are filled where no particle is nearer than 0.9 spacings. A region that liquid has just enclosed is
///    filled likewise, and keeps its gas from then on.
///  * Cells have room where walls leave it; where some move they are asked for anew.
///  * What openings hold is theirs: it goes where it is as far from the liquid, and beyond outlets, out of the scene's sight, gaps are filled as above.
///  * Where pressure is solved for, no gas but what openings hold is faster than 0.9 of what flow allows for the step (scene/flowLimit.hpp), or than the fastest liquid where that is more: single particles that menisci
///    press out between them do not shorten the steps of all. Where gas alone binds the steps it loses up to a tenth of its speed in each. Its momentum is lost, a thousandth of the liquid's at equal speed.
///  * Of ambient gas in the outer three fifths of what moves, blocks of 4 cells a side whose particles are too many or too few for the volume that they fill, by more than 0.75 of one, lose one or get one in a gap.
#pragma once
#include "models/gas/LiquidMap.hpp"
#include "scene/Particles.hpp"
#include <map>
#include <optional>
#include <vector>

namespace sph
{

template<int dim> class GasBand final : public RunningModel<dim>
{
public:
    /// `width` of the band [supports]; `gas`: number of its phase.
    GasBand(Particles<dim>&, const Numbers& restored, std::size_t gas, double width, const SceneEnds&);

    std::vector<Stage<dim>> stages(JoinPoint) override;
    std::string introduction() const override;
    std::string report(const Particles<dim>&) const override;
    void save(Numbers&) const override;
    double letIn(std::size_t phase) const override { return phase == gas_ ? joined_ - gone_ : 0; }
    std::size_t bytes() const override { return map_.bytes() + room_.capacity() * sizeof(int); }

private:
    struct Chains;
    struct Kinds;
    LiquidMap map_;
    std::vector<int> room_; ///< of chains
    std::size_t gas_;
    double spacing_;
    double width_, widthOfMotion_, freeWidth_; ///< of the band, of its part that moves, and of that which is not ambient [spacings]
    double restVolume_;                        ///< of a particle [m^d]
    bool solvesPressure_, hasOpenings_, knowsVolumes_ = false;
    double joined_ = 0, gone_ = 0; ///< mass since the first start [kg]
    std::size_t now_ = 0;          ///< particles of the gas, when last exchanged
    std::optional<double> start_;  ///< mass of the gas after the first exchange, less what has joined and gone before it [kg]
    double mass_ = 0;              ///< of the gas after the last exchange [kg]

    void exchange(Particles<dim>&);
    void slow(Particles<dim>&, double deltaT) const;
    /// Removes gas from beyond the band and where it is crowded, and returns how many particles there are now.
    std::size_t remove(FieldStore<dim>&, std::size_t owned);
    /// Cells for gas that joins, the same on all ranks.
    std::vector<std::size_t> bareCells(const Chains&) const;
    std::vector<std::size_t> sparseCells(const FieldStore<dim>&, const Chains&, std::size_t owned) const;
    std::vector<std::size_t> clear(const std::vector<std::size_t>& cells, const Chains&, double gap) const;
    /// Ambient gas in the outer three fifths of what moves, by blocks of cells: how many particles it has beyond those that fill its volume at rest, and which, with their volumes over that at rest. Where ranks share the particles, each has blocks of its own.
    struct Block
    {
        double excess = 0;
        std::vector<std::pair<double, int>> byVolume = {};
    };
    std::map<std::size_t, Block> blocks(const FieldStore<dim>&, const Chains&, std::size_t owned) const;
    std::size_t join(Particles<dim>&, std::size_t owned);
    /// Says of the particles from `begin` to `end` whether they stand, move or are free.
    void mark(Particles<dim>&, std::size_t begin, std::size_t end) const;
    void hold(Particles<dim>&) const;
};

}
