/// Allocating, binding, evaluating and printing a plan.
#include "images/layerPairs.hpp"
#include "parallel/Stretches.hpp"
#include "plan/Plan.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ostream>

namespace sph
{

namespace
{
/// Adds a run of each operation of a pass, where they are counted.
void countRuns(std::map<std::string, long>* counts, const std::string& group, const auto& entries)
{
    if (!counts) return;
    for (const auto* e : entries) ++(*counts)[group + "/" + e->name];
}
}

template<int dim> void Plan<dim>::allocate(FieldStore<dim>& store) const
{
    store.allocate(Position{});
    for (const auto& g : groups_)
    {
        for (const auto* e : g.chosen)
        {
            for (const auto& f : e->results) store.allocate(g.resultName(f), f.info, f.type);
            forEachRead(*e, [&](const FieldUse<dim>& f) { store.allocate(f.name, f.info, f.type); });
        }
        if (g.group.sharesBy.empty()) continue;
        store.allocate(BoundaryShare{});
        store.allocate(GhostWall{});
    }
}

template<int dim> std::set<std::string> Plan<dim>::readAtNeighbours() const
{
    std::set<std::string> read{Position::info.name, ImageWeight::info.name};
    for (const auto& g : groups_)
    {
        for (const auto& pass : g.passes)
        {
            for (const auto& f : pass.columns) read.insert(f.name);
            if (pass.normalised) read.insert(GradientScale::info.name);
        }
        if (g.group.sharesBy.empty()) continue;
        read.insert(BoundaryShare::info.name);
        read.insert(g.group.sharesBy.begin(), g.group.sharesBy.end());
    }
    return read;
}

template<int dim> std::set<std::string> Plan<dim>::readOfCopies() const
{
    auto read = readAtNeighbours();
    for (const auto& g : groups_)
        for (const auto& pass : g.passes)
            for (const auto* e : pass.entries)
            {
                for (const auto& f : e->reads)
                    if (f.info.ofGhosts) read.insert(f.info.ofGhosts);
                if (pass.pair()) forEachRead(*e, [&](const FieldUse<dim>& f) { read.insert(f.name); });
            }
    return read;
}

template<int dim> std::set<std::string> Plan<dim>::imaged(const Images<dim>& images) const
{
    if (images.halo()) return readOfCopies();
    if (images.layers()) return readAtNeighbours();
    std::set<std::string> own{Position::info.name, ImageWeight::info.name};
    for (const auto& g : groups_)
    {
        for (const auto& pass : g.passes)
            for (const auto& f : pass.columns)
                if (f.info.image == Image::placed) own.insert(f.name);
        if (g.group.sharesBy.empty()) continue;
        own.insert(BoundaryShare::info.name);
        own.insert(g.group.sharesBy.begin(), g.group.sharesBy.end());
    }
    return own;
}

template<int dim> std::vector<std::string> Plan<dim>::copiedFor(const Pass& pass, const FieldStore<dim>& store) const
{
    std::set<std::string> fields;
    for (const auto& f : pass.refresh)
    {
        if (f.info.image == Image::placed) continue;
        fields.insert(f.name);
        if (f.info.ofGhosts && store.has(f.info.ofGhosts)) fields.insert(f.info.ofGhosts);
        if (const auto rule = ruleReads_.find(f.info.ofRule ? f.info.ofRule : ""); rule != ruleReads_.end())
            for (const auto& source : rule->second) fields.insert(source.name);
    }
    return {fields.begin(), fields.end()};
}

template<int dim> void Plan<dim>::bind(FieldStore<dim>& store, const Coefficients& coefficients)
{
    computed_.clear();
    for (auto& g : groups_)
    {
        std::set<std::string> written = state_; // what adds to a state changes it, and never overwrites it
        for (auto& pass : g.passes)
        {
            pass.sources.clear();
            pass.computed.clear();
            pass.operations.clear();
            for (const auto& f : pass.columns)
                for (int c = 0; c < f.type.components; ++c) pass.sources.push_back(store.component(f.name, c));
            const auto factor = [&](bool needed, const FieldInfo& info)
            {
                if (needed) pass.sources.push_back(store.component(info.name, 0));
                return needed ? int(pass.sources.size()) - 1 : -1;
            };
            const bool given = !g.group.sharesBy.empty();
            const bool weighs = pass.pair() && (!pass.slopes || pass.readsKernel);
            pass.factors = {factor(weighs && (given || store.has(ImageWeight{})), given ? BoundaryShare::info : ImageWeight::info),
                            factor(pass.normalised && !pass.slopes, GradientScale::info)};
            bool lastIsComputed = false;
            const auto computeIf = [&](const FieldUse<dim>& f, int column)
            {
                if (column < 0 || store.imaged(f.name)) return;
                pass.computed.push_back({f, std::size_t(column)});
                computed_.insert(f.name);
                lastIsComputed = lastIsComputed || std::size_t(column + f.type.components) == pass.sources.size();
            };
            for (const auto& f : pass.columns) computeIf(f, pass.firstColumn.at(f.name));
            computeIf(uses<dim>(Fields<GradientScale>{})[0], pass.factors.scale);
            // What is packed alone has values of images: a last column that would be gathered by index is packed in a pair.
            if (lastIsComputed && !pass.single && Stencil<dim>::lastByIndex(int(pass.sources.size())))
                pass.sources.push_back(store.component(Position::info.name, 0));
            for (const auto* e : pass.entries)
            {
                auto names = e->names;
                names.insert(g.group.names.begin(), g.group.names.end());
                const bool adds = !written.insert(g.resultName(e->results[0])).second && !e->provides && !e->advances;
                pass.operations.push_back(e->bind(coefficients, {store, names, pass.firstColumn, adds}));
            }
        }
    }
}

template<int dim>
void Plan<dim>::pack(const Pass& pass, FieldStore<dim>& store, const Images<dim>& images, std::size_t begin, std::size_t end)
{
    const std::size_t n = store.size();
    const int columns = int(pass.sources.size()), single = pass.single ? singleRecordSize<dim>(columns) : 0;
    const auto bytes =
        n * (single ? std::size_t(single) * sizeof(float) : std::size_t(Stencil<dim>::recordsWidth(columns)) * sizeof(double));
    if (records_.size() < bytes)
    {
        records_ = {};
        records_.resize(bytes + bytes / 50);
    }
    std::vector<const double*> from;
    for (const double* p : store.pointers(Position{})) from.push_back(p);
    from.insert(from.end(), pass.sources.begin(), pass.sources.end());
    from.resize(std::size_t(std::max(dim + columns + recordSize, single)), from[0]);
    auto ofImages = from; // what has room for them, in any value else
    for (const auto& [field, column] : pass.computed) std::fill_n(ofImages.begin() + long(dim + column), field.type.components, from[0]);

    using Columns = std::array<const double*, std::bit_ceil(unsigned(dim + Stencil<dim>::maxColumns + recordSize))>; // of a block
    static_assert(singleRecordSize<dim>(Stencil<dim>::maxColumns) <= int(Columns{}.size()));
    const auto units = images.placeUnits();
    const auto packBlock = [&](const Columns& block, std::size_t first, std::size_t count)
    {
        if (single) packSingleRecords(block.data(), columns, units, count, packed<float>() + first * std::size_t(single));
        double* to = packed<double>();
        const double* const* of = block.data();
        for (int a = 0; !single && Stencil<dim>::recordWidth(a, columns) > 0; ++a)
        {
            const int width = Stencil<dim>::recordWidth(a, columns);
            packRecords(of, width, count, to + first * std::size_t(width));
            to += std::size_t(width) * n;
            of += width;
        }
    };
    const auto at = [](const std::vector<const double*>& all, std::size_t first)
    {
        Columns block{};
        for (std::size_t c = 0; c < all.size(); ++c) block[c] = all[c] + first;
        return block;
    };
    constexpr std::size_t size = 512;
    const std::size_t firstImage = std::clamp(store.owned(), begin, end);
    // Each thread packs its share of particles and of images: those that it has computed, and gathers.
#pragma omp parallel
    {
#pragma omp for schedule(static) nowait
        for (std::size_t first = begin; first < firstImage; first += size)
            packBlock(at(from, first), first, std::min(size, firstImage - first));
        static thread_local std::vector<double> computed;
        if (!pass.computed.empty()) computed.resize(from.size() * size);
#pragma omp for schedule(static) nowait
        for (std::size_t first = firstImage; first < end; first += size)
        {
            const std::size_t count = std::min(size, end - first);
            auto block = at(ofImages, first);
            for (const auto& [field, column] : pass.computed)
            {
                std::array<double*, Stencil<dim>::maxColumns> to;
                for (std::size_t c = 0; c < std::size_t(field.type.components); ++c)
                    block[dim + column + c] = to[c] = computed.data() + (column + c) * size;
                field.compute(images, store, field.name, first, count, to.data());
            }
            packBlock(block, first, count);
        }
    }
}

template<int dim>
void Plan<dim>::evaluatePairs(const Pass& pass, FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists,
                              const Kernel<dim>& kernel, std::optional<std::span<const int>> only, std::span<const std::uint8_t> leftOut)
{
    if (pass.keepsWithin) lists.makeRoomWithin();
    if (pass.keepsSlopes) lists.makeRoomForSlopes(keepsSingleSlopes_);
    const auto pointers = store.pointers(Position{});
    std::array<const double*, dim> x;
    std::copy(pointers.begin(), pointers.end(), x.begin());
    const long null = long(images.nullParticle());
    const auto* const layers = images.layers();
    std::vector<InLayersOf> inLayers; // of the columns
    for (const auto& f : pass.columns) inLayers.push_back({images.rules().any(f.info.ofRule), images.rules().interpolates(f.info)});
    const auto* const halo = pass.refresh.empty() ? nullptr : images.halo();
    const auto units = images.placeUnits();

    const auto isNothingAt = [&](std::size_t i)
    {
        return (!leftOut.empty() && leftOut[i]) ||
               (pass.leavesOut && std::ranges::all_of(pass.operations, [&](const auto& o) { return o->isNothingAt(i); }));
    };
    // The lambda runs over so many particles: the owned ones in order, unless `which` names them.
    constexpr std::size_t ahead = 2;
    const auto over = [&](std::size_t n, const int* which, const auto& k)
    {
        const auto gatherInto = [&](auto& stencil, std::size_t begin, std::size_t end, const auto& fill)
        {
            static thread_local typename NeighbourLists<dim>::Room room;
            for (std::size_t place = begin; place < end; ++place)
            {
                const std::size_t i = which ? std::size_t(which[place]) : place;
                if (isNothingAt(i))
                {
                    for (const auto& o : pass.operations) o->clear(i);
                    continue;
                }
                const KnownNeighbours known{pass.within ? lists.within(i) : lists.of(i, room), pass.within,
                                            pass.slopes ? lists.slopes(i) : KeptSlopes{}};
                if (pass.slopes && place + ahead < end) lists.fetchKept(which ? std::size_t(which[place + ahead]) : place + ahead);
                fill(int(i), known);
                if (layers) layers->continueInto(stencil, inLayers, pass.columns, pass.sources, pass.factors.scale);
                stencil.applyFactors(pass.factors, pass.sources, pass.readsKernel, pass.slopes);
                if (pass.keepsWithin) lists.keepWithin(i, stencil.j, stencil.listed);
                if (pass.keepsSlopes) lists.slopes(i).keep(stencil.dWdrOverR, stencil.listed);
                for (const auto& o : pass.operations) o->gather(stencil);
            }
            if (halo && omp_get_thread_num() == 0) halo->progress();
        };
        const auto gather = [&](std::size_t begin, std::size_t end)
        {
            if (pass.single)
            {
                static thread_local Stencil<dim, Single> stencil;
                gatherInto(stencil, begin, end,
                           [&](int i, const KnownNeighbours& known)
                           { stencil.fill(i, known, packed<float>(), int(pass.sources.size()), units, k, pass.readsKernel, null); });
                return;
            }
            static thread_local Stencil<dim> stencil;
            gatherInto(stencil, begin, end,
                       [&](int i, const KnownNeighbours& known)
                       { stencil.fill(i, known, x, packed<double>(), store.size(), pass.sources, k, pass.readsKernel, null); });
        };
        Stretches stretches(n, 64);
#pragma omp parallel
        stretches.forEach(gather);
    };
    std::visit(
        [&](const auto& k)
        {
            const std::size_t owned = images.owned();
            std::size_t firstToPack = 0;
            if (halo)
            {
                halo->start(store, copiedFor(pass, store));
                // Interior particles see these alone: owned ones, and the null particle at the end of each list.
                for (const auto& f : pass.refresh)
                    for (int c = 0; f.info.image != Image::placed && c < f.type.components; ++c)
                        images.setNullParticle(store.component(f.name, c));
                pack(pass, store, images, 0, owned);
                pack(pass, store, images, std::size_t(null), std::size_t(null) + 1);
                if (!only) over(lists.interior().size(), lists.interior().data(), k);
                halo->finish();
                firstToPack = owned;
            }
            for (const auto& f : pass.refresh) f.refresh(images, store, f.name);
            pack(pass, store, images, firstToPack, store.size());
            if (only) over(only->size(), only->data(), k);
            else if (halo) over(lists.border().size(), lists.border().data(), k);
            else over(owned, nullptr, k);
        },
        kernel.choice());
}

template<int dim>
void Plan<dim>::evaluate(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists, const Kernel<dim>& kernel,
                         std::size_t group, double deltaT, std::span<const std::uint8_t> leftOut)
{
    const auto& g = groups_[group];
    const std::size_t n = images.owned(), block = 512;
    for (const auto& pass : g.passes)
    {
        countRuns(counts_, g.group.name, pass.entries);
        if (pass.pair())
        {
            evaluatePairs(pass, store, images, lists, g.kernel ? *g.kernel : kernel, {}, leftOut);
            ++pairPassesRun_;
            continue;
        }
        const bool walls = pass.entries[0]->over == Over::walls;
#pragma omp parallel for schedule(static)
        for (std::size_t begin = 0; begin < n; begin += block)
            for (const auto& o : pass.operations)
            {
                if (walls) o->atWalls(images.nearWalls(), begin, std::min(n, begin + block));
                else o->evaluate(begin, std::min(n, begin + block), deltaT);
            }
    }
}

template<int dim>
void Plan<dim>::evaluateAt(std::span<const int> particles, FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists,
                           const Kernel<dim>& kernel, std::size_t group)
{
    for (const auto& pass : groups_[group].passes)
    {
        countRuns(counts_, groups_[group].group.name, pass.entries);
        evaluatePairs(pass, store, images, lists, kernel, particles, {});
        ++pairPassesRun_;
    }
}

template<int dim> void Plan<dim>::printGroup(std::ostream& out, std::size_t group, int& number, int& operation) const
{
    const auto& g = groups_[group];
    for (const auto& pass : g.passes)
    {
        const auto over = pass.entries[0]->over;
        out << fmt::format("    pass {} over {}{}\n", ++number,
                           over == Over::pairs   ? "pairs"
                           : over == Over::walls ? "walls"
                                                 : "particles",
                           pass.pair() && g.kernel ? fmt::format(", {} of support {:.4g} m", g.group.kernel->name, g.group.kernel->support)
                                                   : "");
        for (const auto* e : pass.entries)
        {
            std::string results;
            for (const auto& f : e->results) results += (results.empty() ? "" : " ") + g.resultName(f);
            out << fmt::format("    {:>4}  {:<32} -> {:<12} ({})\n", ++operation, e->name, results, g.reason.at(e));
        }
        if (pass.pair())
        {
            out << "          gathers    positions";
            for (const auto& f : pass.columns) out << ' ' << f.name;
            if (pass.normalised && !pass.slopes) out << ' ' << GradientScale::info.name;
            if (pass.single) out << " in single precision";
            out << "\n          images     positions";
            for (const auto& f : pass.refresh)
                if (!computed_.contains(f.name)) out << ' ' << f.name;
            if (!pass.computed.empty()) out << "; when packed";
            for (const auto& [field, _] : pass.computed) out << ' ' << field.name;
            if (pass.keepsWithin || pass.keepsSlopes) out << "\n          keeps     ";
            if (pass.keepsWithin) out << " neighbours";
            if (pass.keepsSlopes) out << " (dW/dr)/r" << (keepsSingleSlopes_ ? " in single precision" : "");
            if (pass.leavesOut) out << "\n          leaves out particles where all terms are 0 by their own values";
            out << '\n';
        }
    }
}

template<int dim> void Plan<dim>::printFields(std::ostream& out, const FieldStore<dim>& store) const
{
    out << "    fields     ";
    for (const auto& [name, field] : store.fields())
        out << ' ' << name << (field.component.size() > 1 ? fmt::format("[{}]", field.component.size()) : "");
    out << fmt::format("\n    memory      {} bytes a particle, neighbour lists aside\n    left out   ", store.bytesPerParticle());
    for (const auto& e : catalogue_)
        if (!has(e.name)) out << ' ' << e.name;
    out << '\n';
}

template<int dim> void Plan<dim>::print(std::ostream& out, const FieldStore<dim>& store) const
{
    int pass = 0, operation = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g)
    {
        if (g > 0) out << "    " << groups_[g].group.name << ":\n";
        printGroup(out, g, pass, operation);
    }
    printFields(out, store);
}

template class Plan<2>;
template class Plan<3>;

}
