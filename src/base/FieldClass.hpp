/// The classes of field that a cloud has on disk, with OpenFOAM's names of their components in OpenFOAM's order.
#pragma once
#include <span>
#include <string_view>

namespace sph
{

enum class FieldClass
{
    label,
    scalar,
    vector,
    symmTensor,
    tensor
};

namespace detail
{
inline constexpr std::string_view one[]{""}, ofVector[]{"x", "y", "z"}, ofSymmTensor[]{"xx", "xy", "xz", "yy", "yz", "zz"},
    ofTensor[]{"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
}
/// "" of a scalar or label, "x" "y" "z" of a vector, "xx" "xy" ... of a tensor.
constexpr std::span<const std::string_view> componentNames(FieldClass c)
{
    switch (c)
    {
    case FieldClass::vector:
        return detail::ofVector;
    case FieldClass::symmTensor:
        return detail::ofSymmTensor;
    case FieldClass::tensor:
        return detail::ofTensor;
    default:
        return detail::one;
    }
}

/// Numbers per particle on disk: 1, 1, 3, 6 or 9.
constexpr int componentsOf(FieldClass c) { return int(componentNames(c).size()); }

}
