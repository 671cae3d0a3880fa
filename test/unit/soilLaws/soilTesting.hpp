/// Loose Karlsruhe sand, tables of the independent integrator, and strains.
#pragma once
#include "base/csv.hpp"
#include "soilLaws/soilLaws.hpp"
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace sph::test
{

inline constexpr WuBauer karlsruhe{-69.4, -673.1, -655.9, 699.6};
/// Medium Karlsruhe sand with void ratio, and with intergranular strain.
inline const auto karlsruheOfVoidRatio = VonWolffersdorff::of(30, 5.8e9, 0.28, 0.53, 0.84, 1, 0.13, 1.05);
inline const IntergranularStrain<VonWolffersdorff> karlsruheIntergranular{karlsruheOfVoidRatio, 1e-4, 5, 2, 0.5, 6};

/// Columns by name; words are left out. `name` may have the tutorial before it, whose table it is.
inline std::map<std::string, std::vector<double>> table(const std::string& name, const std::string& onlyWith = "")
{
    const auto slash = name.find('/');
    const auto tutorial = slash == std::string::npos ? "elementTests" : name.substr(0, slash);
    std::ifstream file(std::string(SPH_GEOMECHANICS) + "/" + tutorial + "/reference/" + name.substr(slash + 1) + ".csv");
    std::vector<std::string> names;
    std::map<std::string, std::vector<double>> columns;
    for (std::string line; std::getline(file, line);)
    {
        if (line.starts_with('#')) continue;
        const auto cells = csvCells(line);
        if (names.empty()) names = cells;
        else if (onlyWith.empty() || line.find(onlyWith) != std::string::npos)
            for (std::size_t k = 0; k < cells.size(); ++k)
                if (const auto value = finiteNumber(cells[k])) columns[names[k]].push_back(*value);
    }
    EXPECT_FALSE(columns.empty()) << name;
    return columns;
}

/// Tight: what is left is the reference's own error. The floor is out of the way.
inline StressIntegration tight(double tolerance = 1e-11)
{
    StressIntegration how;
    how.tolerance = tolerance;
    how.turning = Turning::within;
    how.floorPressure = 1e-60;
    return how;
}

inline Tensor<3> diagonal(double xx, double yy, double zz) { return {xx, 0, 0, 0, yy, 0, 0, 0, zz}; }
inline SymmTensor<3> principal(double xx, double yy, double zz) { return {xx, 0, 0, yy, 0, zz}; }

/// The whole deformation in steps of `step`, the last one shorter.
template<ConstitutiveLaw Law>
SymmTensor<3> inSteps(const Law& law, SymmTensor<3> stress, Tensor<3> unit, double whole, double step, const StressIntegration& how)
{
    const int n = int(std::ceil(whole / step - 1e-9));
    for (int k = 0; k < n; ++k)
    {
        const auto one = integrateStress(law, stress, std::min(step, whole - k * step) * unit, how);
        EXPECT_EQ(one.state, StressState::regular);
        stress = one.stress;
    }
    return stress;
}

inline double relative(double value, double exact) { return std::abs(value / exact - 1); }

}
