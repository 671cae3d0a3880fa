#include "solver/WholeCloud.hpp"
#include "parallel/reduce.hpp"

namespace sph
{

WholeCloud::WholeCloud(std::size_t own) : own_(own), size_(own)
{
    if (!ranks()) return;
    const auto all = ofAllRanks(own, std::size_t(0), Add{});
    size_ = ranks()->rank() == 0 ? all : 0;
}

const double* WholeCloud::whole(const double* own)
{
    if (!ranks()) return own;
    // A rank without particles may have no room for a field that others have.
    if (ofAllRanks(std::size_t(own != nullptr), std::size_t(0), Add{}) == 0) return nullptr;
    return arrays_.emplace_back(gatherOnFirst<double>(*ranks(), {own, own_})).data();
}

FieldView WholeCloud::whole(FieldView own)
{
    for (auto& component : own.component) component = whole(component);
    return own;
}

}
