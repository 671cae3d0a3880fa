#include "fields/FieldStore.hpp"
#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

namespace sph
{

// The system may decline, and nobody need know.
void askForHugePages(void* memory, std::size_t bytes)
{
    constexpr std::size_t large = 4 << 20; // two huge pages: what is smaller may lie in none
    if (bytes < large) return;
    const auto page = std::size_t(sysconf(_SC_PAGESIZE)), beyond = std::size_t(std::bit_cast<std::uintptr_t>(memory) % page),
               first = beyond == 0 ? 0 : page - beyond;
    madvise(static_cast<std::byte*>(memory) + first, (bytes - first) / page * page, MADV_HUGEPAGE);
}

template<int dim> void FieldStore<dim>::allocate(const std::string& name, const FieldInfo& info, const ValueType& type)
{
    fields_.try_emplace(name, Field{info, type, std::vector<Array>(std::size_t(type.components), Array(size_, 0.0))});
}

template<int dim> double* FieldStore<dim>::component(const std::string& name, int c)
{
    const auto field = fields_.find(name);
    if (field == fields_.end()) throw std::logic_error("field \"" + name + "\" is not part of this scene's plan");
    return field->second.component[c].data();
}

template<int dim> void FieldStore<dim>::keepImagesOf(const std::set<std::string>& fields)
{
    for (auto& [name, field] : fields_) field.imaged = fields.contains(name);
    resize(size_, owned_);
}

template<int dim> void FieldStore<dim>::resizeIf(const auto& concerns, std::size_t n)
{
    std::vector<std::span<double>> added;
    for (auto& [name, field] : fields_)
        for (auto& a : field.component)
        {
            if (!concerns(name)) continue;
            const std::size_t length = field.imaged ? n : owned_, before = std::min(a.size(), length);
            // The number of images changes a little at each rebuild, and so does that of particles where some come and go: some room spares most reallocations.
            const std::size_t spare = field.imaged ? n - owned_ : a.empty() ? 0 : owned_;
            if (length > a.capacity()) a.reserve(length + spare / 20);
            a.resize(length);
            added.push_back(std::span(a).subspan(before));
        }
#pragma omp parallel
    for (const auto part : added)
    {
#pragma omp for simd schedule(static) nowait
        for (std::size_t k = 0; k < part.size(); ++k) part[k] = 0;
    }
}

template<int dim> void FieldStore<dim>::resize(std::size_t n, std::size_t owned)
{
    size_ = n;
    owned_ = owned;
    resizeIf([](const auto&) { return true; }, n);
}

template<int dim> void FieldStore<dim>::makeRoom(const std::set<std::string>& fields, std::size_t n)
{
    resizeIf([&](const auto& name) { return fields.contains(name); }, n);
}

template<int dim> void FieldStore<dim>::sortState(const std::vector<int>& order, std::span<double> room)
{
    Array own(room.size() < order.size() ? order.size() : 0);
    double* const sorted = own.empty() ? room.data() : own.data();
    for (auto& [_, field] : fields_)
    {
        if (!field.state) continue;
        for (auto& a : field.component)
        {
#pragma omp parallel for schedule(static)
            for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = a[order[k]];
#pragma omp parallel for simd schedule(static)
            for (std::size_t k = 0; k < order.size(); ++k) a[k] = sorted[k];
        }
    }
}

template<int dim> std::size_t FieldStore<dim>::bytesPerParticle() const
{
    std::size_t n = 0;
    for (const auto& [_, field] : fields_) n += field.component.size() * sizeof(double);
    return n;
}

template<int dim> std::size_t FieldStore<dim>::bytes() const
{
    std::size_t n = 0;
    for (const auto& [_, field] : fields_)
        for (const auto& a : field.component) n += a.capacity() * sizeof(double);
    return n;
}

template class FieldStore<2>;
template class FieldStore<3>;

}
