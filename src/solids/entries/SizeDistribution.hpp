/// Distribution of the sizes of grains: the diameter d [m] of the sphere of equal volume.
///
/// The share of the grains, or of their mass, that is finer than d, before what lies outside `low` and `high` is cut off:
///
///     uniform        (d - low)/(high - low)
///     normal         Phi((d - mean)/deviation)               Phi that of the standard normal distribution
///     lognormal      Phi(ln(d/median)/ln s)                  s geometric standard deviation
///     RosinRammler   1 - exp(-(d/d_0)^n)                     Rosin & Rammler (1933): 63.2 % of the mass is finer than d_0
///     sieves         a table, linear in ln d from one sieve to the next, as grading curves are drawn
///
/// A share of the mass M becomes one of the number by dN = dM/d^3 / int dM/d^3.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

struct SizeDistribution
{
    enum class Kind
    {
        fixed,
        uniform,
        normal,
        lognormal,
        list,
        RosinRammler,
        sieves
    };
    Kind kind = Kind::fixed;
    double low = 1, high = 1;        ///< no size is outside
    double middle = 1, width = 0;    ///< mean and standard deviation; of a lognormal distribution those of ln d; of RosinRammler d_0 and n
    std::vector<double> sizes, upTo; ///< of a list and of sieves, and the shares up to and with each: of a list by number
    bool byMass = false;             ///< what the shares are of; a list's are of the number
    Location where;

    /// Sizes of n grains, the smallest first: each stands for the n-th part of them. By number it is the size in the middle of its part; by mass the one of the mean volume of its
    /// part, so that the mass finer than each size between two parts is that of the distribution.
    std::vector<double> ofGrains(int n) const;
    double mean(int n) const;       ///< of these sizes
    double meanVolume(int n) const; ///< pi/6 of the mean of d^3
    /// Share of the mass that is finer than d.
    double passing(double d) const;
    /// What is left of the distribution between `low` and `high`.
    double share() const;

private:
    double finer(double d) const;
    double quantile(double p) const;
    std::vector<double> ofGrainsByMass(int n) const;
};

/// Reads section `size`.
SizeDistribution readSizes(const Dictionary&);
EntryList sizeEntries();

}
