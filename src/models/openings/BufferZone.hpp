/// Buffer particles beyond the planes of open boundaries: which particles they are, and how buffers are filled and emptied.
///
/// A particle is free from the evaluation on that finds it past an inlet's plane, and held from that on which finds it past an outlet's. Lines are filled up
/// from behind, and what comes to the end of an outlet is removed, when neighbour lists are rebuilt: both out of the scene's sight, so that the
/// time of it changes nothing. A packing farther beyond a plane than the buffer reaches is removed at the start.
///
/// Where ranks share the particles, all find the same places to fill; the first rank fills them, and from there particles go to the rank in whose box they lie.
#pragma once
#include "models/openings/OpeningAccount.hpp"

namespace sph
{

template<int dim> class BufferZone
{
public:
    /// `restored`: the run goes on from a restart, and buffers are filled. The scene, the openings and the account must outlive this.
    BufferZone(const OpenScene&, const std::vector<PlacedOpening>&, OpeningAccount<dim>&, bool restored);

    /// Removes and inserts particles before the sorting, and returns how many there are now. `predicted`: the call lies between prediction
    /// and correction, where the amounts that pass are those of a particle at the start of the step.
    std::size_t exchange(FieldStore<dim>&, std::size_t owned, bool predicted);
    /// Finds the buffer particles, and the free ones near a plane, after the sorting.
    void locate(FieldStore<dim>&, std::size_t owned);
    /// Updates who is in the buffer at new positions between two sortings: a particle that has passed a plane is held, or free, from now on.
    void follow(FieldStore<dim>&, bool predicted);
    /// Sets the rates of the buffer particles to 0.
    void clearRates(FieldStore<dim>&) const;
    /// Sets the stiffness of those beyond outlets to 0.
    void soften(FieldStore<dim>&) const;
    /// Prescribes velocities and pressures of the buffer particles; `deltaT` [s]: what falls beyond an outlet has fallen for so long.
    void impose(FieldStore<dim>&, double deltaT) const;

    /// Indices of the buffer particles.
    std::span<const int> held() const { return held_; }
    /// Free particles within the kernel's support before the plane of an opening.
    std::span<const int> near(std::size_t opening) const { return near_[opening]; }

private:
    const OpenScene& scene_;
    const std::vector<PlacedOpening>& placed_;
    OpeningAccount<dim>& account_;
    bool integrates_, restored_; ///< integrates_: density evolves
    bool counts_ = false;        ///< the holder of each particle is known from before
    std::vector<int> close_;     ///< all particles that may come near or be held before the next sorting
    std::vector<int> held_;
    std::vector<std::vector<int>> near_; ///< by opening

    int holderOf(const Vector<3>& x) const;
    int farBeyond(const Vector<3>& x) const;
    /// Sets the holder of a particle at x_i from now on, 1 + the opening or 0 for a free one, and returns it; counts the particle where it passes a plane.
    int assign(FieldStore<dim>&, double& holder, std::size_t i, const Vector<3>& x_i, bool predicted);
    /// Divides `close_` into the buffer particles and the free ones near a plane.
    void list(FieldStore<dim>&);
    void replace(FieldStore<dim>&, std::size_t i, const PlacedOpening&, const Vector<3>& x_i) const;
    void imposePressure(FieldStore<dim>&, std::size_t i, const Vector<3>& x_i) const;

    // Filling, in fillBuffer.cpp
    /// A place for a particle that comes in.
    struct Place
    {
        Vector<3> x;
        std::size_t line;
    };
    double firstRow(const FieldStore<dim>&, std::size_t owned, const PlacedOpening&) const;
    std::vector<bool> linesToFill(const FieldStore<dim>&, std::size_t owned, std::size_t opening) const;
    void fillFirst(FieldStore<dim>&, std::size_t& owned) const;
    void refill(FieldStore<dim>&, std::size_t& owned, std::size_t opening) const;
    void insert(FieldStore<dim>&, std::size_t& owned, std::size_t opening, const std::vector<Place>&) const;
    std::vector<Place> clearOf(const std::vector<Vector<3>>& others, const std::vector<Place>&) const;
    void bring(FieldStore<dim>&, std::size_t i, const Stream&) const;
};

/// A particle that lies so near to a plane is on it, and in the scene [spacings].
inline constexpr double onPlane = 1e-6;

/// Whether a line of an outlet moves inwards, so that it brings fluid back.
inline bool comesBack(double velocity) { return velocity > 0 && std::isfinite(velocity); }

}
