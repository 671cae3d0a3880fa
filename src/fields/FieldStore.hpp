/// The arrays of a scene: only those that its plan asked for, one array per component, owned particles first, then images, then
/// the null particle that pads neighbour lists. Fields without room for images end with the owned particles.
#pragma once
#include "fields/fieldTags.hpp"
#include <array>
#include <concepts>
#include <map>
#include <new>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sph
{

/// Has the system keep memory in huge pages where it is large and the system has some: to fill it takes less, and so does to look anywhere in it.
void askForHugePages(void* memory, std::size_t bytes);

/// Begins arrays at cache lines, and leaves numbers that nobody gives a value as they are: who makes room lets the thread that will use it touch it first.
template<class T> struct AlignedAllocator
{
    using value_type = T;
    static constexpr std::align_val_t alignment{64};
    AlignedAllocator() = default;
    template<class U> AlignedAllocator(const AlignedAllocator<U>&) {}
    T* allocate(std::size_t n)
    {
        void* const memory = ::operator new(n * sizeof(T), alignment);
        askForHugePages(memory, n * sizeof(T));
        return static_cast<T*>(memory);
    }
    void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
    template<class U> void construct(U* p) { ::new (static_cast<void*>(p)) U; }
    template<class U, class... Values> void construct(U* p, Values&&... values)
    {
        ::new (static_cast<void*>(p)) U(std::forward<Values>(values)...);
    }
    friend bool operator==(AlignedAllocator, AlignedAllocator) { return true; }
};
using Array = std::vector<double, AlignedAllocator<double>>;
using SingleArray = std::vector<float, AlignedAllocator<float>>;
using IndexArray = std::vector<int, AlignedAllocator<int>>;

template<int dim> class FieldStore
{
public:
    struct Field
    {
        FieldInfo info;
        ValueType type;
        std::vector<Array> component;
        bool state = false; ///< travels with the particles when they are sorted; derived fields are recomputed instead
        bool imaged = true; ///< has room for images
    };

    /// An array of the current size for each component, filled with 0; asking twice is harmless.
    void allocate(const std::string& name, const FieldInfo& info, const ValueType& type);
    template<class F> void allocate(F) { allocate(F::info.name, F::info, valueType<FieldValue<F, dim>>); }
    /// Allocates a field that keeps its values from step to step.
    void allocateState(const std::string& name, const FieldInfo& info, const ValueType& type)
    {
        allocate(name, info, type);
        fields_.at(name).state = true;
    }
    template<class F> void allocateState(F) { allocateState(F::info.name, F::info, valueType<FieldValue<F, dim>>); }

    bool has(const std::string& name) const { return fields_.contains(name); }
    template<class F>
    requires requires { F::info; }
    bool has(F) const { return has(std::string(F::info.name)); }

    double* component(const std::string& name, int c);
    const double* component(const std::string& name, int c) const { return const_cast<FieldStore&>(*this).component(name, c); }
    template<class F> std::array<double*, fieldComponents<F, dim>> pointers(const std::string& name)
    {
        std::array<double*, fieldComponents<F, dim>> p;
        for (int c = 0; c < int(p.size()); ++c) p[c] = component(name, c);
        return p;
    }
    template<class F> std::array<double*, fieldComponents<F, dim>> pointers(F) { return pointers<F>(F::info.name); }
    template<class F> std::array<const double*, fieldComponents<F, dim>> pointers(F) const
    {
        std::array<const double*, fieldComponents<F, dim>> p;
        for (int c = 0; c < int(p.size()); ++c) p[c] = component(F::info.name, c);
        return p;
    }

    /// Gives up the room of images in every field but the named ones.
    void keepImagesOf(const std::set<std::string>& fields);
    bool imaged(const std::string& name) const { return fields_.at(name).imaged; }

    /// `n` owned particles + images + null particle, `owned` of them without images.
    void resize(std::size_t n, std::size_t owned);
    void resize(std::size_t n) { resize(n, n); }
    /// Room for `n` particles in these fields alone, of those that have room for images, until the next `resize` (owned particles are as many as before): what is known of images before it is known which of them anybody sees.
    void makeRoom(const std::set<std::string>& fields, std::size_t n);
    std::size_t size() const { return size_; }
    std::size_t owned() const { return owned_; }

    /// Brings owned particle order[k] to place k in every state field. `room` is memory that nobody else uses meanwhile, and may be too small.
    void sortState(const std::vector<int>& order, std::span<double> room = {});

    const std::map<std::string, Field>& fields() const { return fields_; }
    std::size_t bytesPerParticle() const;
    /// Allocated in all, images and spare room included.
    std::size_t bytes() const;

private:
    std::map<std::string, Field> fields_;
    std::size_t size_ = 0, owned_ = 0;

    /// Gives the arrays of fields for which `concerns(name)` holds the room of `n` particles, those without images that of the owned ones.
    void resizeIf(const auto& concerns, std::size_t n);
};

}
