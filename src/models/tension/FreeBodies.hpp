/// Liquid bodies that touch no wall, and their momentum: surface tension has no sum over a closed surface,
///
///   dv_i/dt -= sum_(k in body) m_k a_k/sum_(k in body) m_k
///
/// a [m/s^2] acceleration by the free surface's tension (FreeSurfaceCurvature.hpp), which pairs do not share alike: the curvatures of a hundred to some thousand particles at a surface are each about 1 % off, and what
/// their sum leaves made a disc of 16 spacings to the radius move by itself, at 5 % (support 3) and 26 % (2.6) of sqrt(gamma/(rho R)) after 16 capillary times. A body is what lies within one another's lists; one that
/// sees a ghost of a wall is left as it is, since the wall takes its momentum. Bodies are found behind the first evaluation after lists have been built: those of each rank first, which are then joined where one sees particles of another.
/// Angular momentum is not balanced. Verified by test/unit/gas and test/ranks.
#pragma once
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class FreeBodies final : public RunningModel<dim>
{
    std::vector<int> body_;    ///< of each particle, by number
    std::vector<int> touches_; ///< of each body, those of all ranks: on how many of them it sees a wall
    std::size_t before_ = 0;   ///< particles of the ranks before this one: those of this rank are numbered from there

    bool isFound_ = false; ///< since lists were built

    /// Particle `i` of this rank sees the particle of that number, of another one.
    struct Link
    {
        std::size_t i, number;
    };

    void count(Particles<dim>&);
    void find(const Particles<dim>&);
    /// Bodies of this rank, so many, become those of all ranks. Returns how many there are.
    std::size_t joinAcrossRanks(const std::vector<Link>&, std::size_t bodies);
    void balance(Particles<dim>&) const;

public:
    FreeBodies(Particles<dim>&, const Numbers&) {}
    std::vector<Stage<dim>> stages(JoinPoint) override;
    std::size_t bytes() const override { return (body_.capacity() + touches_.capacity()) * sizeof(int); }
};

}
