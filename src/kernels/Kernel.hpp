/// The choice of a kernel by name. A loop over many pairs visits the variant once and inlines the kernel; single values (packing,
/// probes, surfaces) call W and dWdrOverR here.
#pragma once
#include "kernels/CubicSpline.hpp"
#include "kernels/QuinticSpline.hpp"
#include "kernels/WendlandC2.hpp"
#include "kernels/WendlandC4.hpp"
#include "kernels/WendlandC6.hpp"
#include <string>
#include <variant>
#include <vector>

namespace sph
{

template<int dim> class Kernel
{
public:
    using Choice = std::variant<WendlandC2<dim>, WendlandC4<dim>, WendlandC6<dim>, CubicSpline<dim>, QuinticSpline<dim>>;

    /// `name` is one of kernelNames(); support radius H [m].
    Kernel(const std::string& name, double H);

    double support() const { return H_; }
    /// [1/m^dim]
    double W(double r) const
    {
        return std::visit([&](const auto& k) { return k.W(r); }, choice_);
    }
    /// (dW/dr)/r [1/m^(dim + 2)], finite at r = 0
    double dWdrOverR(double r) const
    {
        return std::visit([&](const auto& k) { return k.dWdrOverR(r); }, choice_);
    }
    const Choice& choice() const { return choice_; }

private:
    double H_;
    Choice choice_;
};

const std::vector<std::string>& kernelNames();

}
