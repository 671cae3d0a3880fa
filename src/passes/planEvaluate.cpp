/// Allocating, binding, evaluating and printing a plan.
#include "Plan.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <ostream>

namespace sph
{

template<int dim> void Plan<dim>::allocate(FieldStore<dim>& store) const
{
    store.allocate(Position{});
    for (const auto* e : chosen_)
    {
        store.allocate(e->result.info, e->result.components);
        for (const auto* list : {&e->reads, &e->readsOwn})
            for (const auto& f : *list) store.allocate(f.info, f.components);
    }
}

template<int dim> std::set<std::string> Plan<dim>::readAtNeighbours() const
{
    std::set<std::string> read{Position::info.name, ImageWeight::info.name};
    for (const auto& pass : passes_)
    {
        for (const auto& f : pass.columns) read.insert(f.info.name);
        if (pass.normalised) read.insert(GradientScale::info.name);
    }
    return read;
}

template<int dim> void Plan<dim>::bind(FieldStore<dim>& store, const Coefficients& coefficients)
{
    std::set<std::string> written = given_; // what adds to a state changes it, and never overwrites it
    for (auto& pass : passes_)
    {
        pass.sources.clear();
        pass.operations.clear();
        for (const auto& f : pass.columns)
            for (int c = 0; c < f.components; ++c) pass.sources.push_back(store.component(f.info.name, c));
        const auto factor = [&](bool needed, const FieldInfo& info)
        {
            if (needed) pass.sources.push_back(store.component(info.name, 0));
            return needed ? int(pass.sources.size()) - 1 : -1;
        };
        pass.factors = {factor(pass.pair() && store.has(ImageWeight{}), ImageWeight::info), factor(pass.normalised, GradientScale::info)};
        for (const auto* e : pass.entries)
            pass.operations.push_back(e->bind({store, coefficients, pass.firstColumn, !written.insert(e->result.info.name).second}));
    }
}

/// Positions and columns of every particle, eight doubles to a cache line.
template<int dim> const double* Plan<dim>::pack(const Pass& pass, FieldStore<dim>& store)
{
    const std::size_t n = store.size();
    const int arrays = Stencil<dim>::recordArrays(int(pass.sources.size()));
    if (records_.size() < arrays*n*recordSize)
    {
        records_ = Array();
        records_.resize(arrays*(n + n/50)*recordSize);
    }
    std::vector<const double*> from;
    for (const double* p : store.pointers(Position{})) from.push_back(p);
    from.insert(from.end(), pass.sources.begin(), pass.sources.end());
    from.resize(std::max<std::size_t>(from.size(), arrays*recordSize), from[0]);
    const long block = 1024, blocks = long((n + block - 1)/block);
    for (int a = 0; a < arrays; ++a)
    {
        double* const to = records_.data() + a*n*recordSize;
        #pragma omp parallel for schedule(static)
        for (long b = 0; b < blocks; ++b)
        {
            const double* part[recordSize];
            for (int c = 0; c < recordSize; ++c) part[c] = from[a*recordSize + c] + b*block;
            packRecords(part, std::min<std::size_t>(block, n - b*block), to + b*block*recordSize);
        }
    }
    return records_.data();
}

template<int dim>
void Plan<dim>::evaluatePairs(const Pass& pass, Candidates candidates, FieldStore<dim>& store, const Images<dim>& images,
                              NeighbourLists<dim>& lists, const Kernel<dim>& kernel)
{
    const bool within = candidates == Candidates::kept, keeps = candidates == Candidates::listedAndKept;
    if (keeps) lists.makeRoomWithin();
    const double* const records = pack(pass, store);
    const auto pointers = store.pointers(Position{});
    std::array<const double*, dim> x;
    std::copy(pointers.begin(), pointers.end(), x.begin());
    const long null = long(images.nullParticle());
    const long n = long(images.owned());
    const auto* const layers = images.layers();

    std::visit([&](const auto& k)
    {
        #pragma omp parallel
        {
            static thread_local Stencil<dim> stencil;
            #pragma omp for schedule(dynamic, 256)
            for (long i = 0; i < n; ++i)
            {
                stencil.fill(int(i), within ? lists.within(i) : lists.of(i), within, x, records, store.size()*recordSize, pass.sources, k,
                             pass.readsKernel, null);
                if (layers) layers->continueInto(stencil, images.ghostVelocity(), pass.columns, pass.sources, pass.factors.scale);
                stencil.applyFactors(pass.factors, pass.sources, pass.readsKernel);
                if (keeps) lists.keepWithin(i, stencil.j, stencil.n);
                for (const auto& o : pass.operations) o->gather(stencil);
            }
        }
    }, kernel.choice());
}

template<int dim>
void Plan<dim>::evaluate(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists, const Kernel<dim>& kernel,
                         Candidates candidates)
{
    const std::size_t n = images.owned(), block = 4096;
    for (const auto& pass : passes_)
    {
        for (const auto& f : pass.refresh) f.refresh(images, store);
        if (pass.pair())
        {
            evaluatePairs(pass, candidates, store, images, lists, kernel);
            if (candidates == Candidates::listedAndKept) candidates = Candidates::kept;
        }
        else
            #pragma omp parallel for schedule(static)
            for (std::size_t begin = 0; begin < n; begin += block)
                for (const auto& o : pass.operations) o->evaluate(begin, std::min(n, begin + block));
    }
}

template<int dim> int Plan<dim>::pairPasses() const
{
    return int(std::count_if(passes_.begin(), passes_.end(), [](const Pass& p) { return p.pair(); }));
}

template<int dim> bool Plan<dim>::has(const std::string& term) const
{
    return std::any_of(chosen_.begin(), chosen_.end(), [&](const Entry* e) { return e->name == term; });
}

template<int dim> void Plan<dim>::printPasses(std::ostream& out) const
{
    int k = 0;
    for (const auto& pass : passes_)
    {
        out << fmt::format("    pass {} over {}\n", ++k, pass.pair() ? "pairs" : "particles");
        for (const auto* e : pass.entries) out << fmt::format("        {:<32} -> {:<12} ({})\n", e->name, e->result.info.name, reason_.at(e));
        if (pass.pair())
        {
            out << "        gathers    positions";
            for (const auto& f : pass.columns) out << ' ' << f.info.name;
            if (pass.normalised) out << ' ' << GradientScale::info.name;
            out << "\n        images     positions";
            for (const auto& f : pass.refresh) out << ' ' << f.info.name;
            out << '\n';
        }
    }
}

template<int dim> void Plan<dim>::print(std::ostream& out, const FieldStore<dim>& store, const Plan* another, const char* when) const
{
    printPasses(out);
    if (another)
    {
        out << "    " << when << ":\n";
        another->printPasses(out);
    }
    out << "    fields     ";
    for (const auto& [name, field] : store.fields()) out << ' ' << name << (field.component.size() > 1 ? fmt::format("[{}]", field.component.size()) : "");
    out << fmt::format("\n    memory      {} bytes a particle, neighbour lists aside\n    left out   ", store.bytesPerParticle());
    for (const auto& e : catalogue_)
        if (!has(e.name) && !(another && another->has(e.name))) out << ' ' << e.name;
    out << '\n';
}

template class Plan<2>;
template class Plan<3>;

}
