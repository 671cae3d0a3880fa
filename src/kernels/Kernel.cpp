#include "kernels/Kernel.hpp"
#include <stdexcept>

namespace sph
{

namespace
{
template<int dim, std::size_t k = 0> typename Kernel<dim>::Choice make(const std::string& name, double H)
{
    using Choice = typename Kernel<dim>::Choice;
    if constexpr (k == std::variant_size_v<Choice>) throw std::invalid_argument("no kernel is named " + name);
    else
    {
        using K = std::variant_alternative_t<k, Choice>;
        return name == K::name ? Choice(K{H}) : make<dim, k + 1>(name, H);
    }
}
}

template<int dim> Kernel<dim>::Kernel(const std::string& name, double H) : H_(H), choice_(make<dim>(name, H)) {}

const std::vector<std::string>& kernelNames()
{
    static const std::vector<std::string> names{WendlandC2<3>::name, WendlandC4<3>::name, WendlandC6<3>::name, CubicSpline<3>::name,
                                                QuinticSpline<3>::name};
    return names;
}

template class Kernel<2>;
template class Kernel<3>;

}
