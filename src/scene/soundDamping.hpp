/// Damping of sound where the density is integrated: numbers of the rooms density and viscosity, which the step's limit by sound (room pressure) asks for.
#pragma once

namespace sph
{

/// Number of the density diffusion: delta, and whether it leaves out what a linear density would diffuse.
struct DiffusionNumber
{
    double delta = 0;
    bool renormalised = false;
};

/// The artificial viscosity alpha h c rho_0 [Pa s]
struct ArtificialNumber
{
    double mu = 0;
};

}
