/// The concept of a term, and the loop that runs it. Physics is the functor; looping, vector lanes and memory are here, once.
///
///   pair term   operator()(ij, i, j)     summed over the stencil of i;   Reads at i and j, ReadsOwn at i alone (costs no gather)
///               finish(i, sum)           optional: what the sum means;        isNothingAt(i) optional: 0 by its own values, neighbours are not looked at
///               sweeps()                 optional: how many sums; then operator()(ij, i, j, sweep), finish(i, sum, sweep), added up
///   local law   operator()(i)            one particle at a time;         ReadsOwn
///               operator()(i, dt)        ... that Advances a state by dt [s], in as many substeps as it likes
///   wall law    operator()(soFar, i, foot)  atWalls; over the places of walls within wallReach() [m] of i, nearest place of each patch; ReadsOwn
///   Provides one derived field, or several as Fields<...> (their only writer), or Adds to a rate that several terms share
///
/// A pair term that `bearsSingle` has its operator, written for any Real, run in single precision too, where a pass asks for it; what it returns is summed, and finished, in
/// double.
///
/// The type is erased once per particle and term (one virtual call per 80 pairs): compiled variants are the sum of the options.
#pragma once
#include "images/Images.hpp"
#include "neighbours/Stencil.hpp"
#include "plan/Coefficients.hpp"
#include "plan/laneSums.hpp"
#include <concepts>
#include <map>
#include <memory>

namespace sph
{

/// One sum of several over the same stencil.
struct Sweep
{
    int number = 0;
};

namespace detail
{
template<class A, class B> struct Join;
template<class... A, class... B> struct Join<Fields<A...>, Fields<B...>>
{
    using type = Fields<A..., B...>;
};

template<class T> struct Reads
{
    using type = Fields<>;
};
template<class T>
requires requires { typename T::Reads; }
struct Reads<T>
{
    using type = typename T::Reads;
};
template<class T> struct ReadsOwn
{
    using type = Fields<>;
};
template<class T>
requires requires { typename T::ReadsOwn; }
struct ReadsOwn<T>
{
    using type = typename T::ReadsOwn;
};
template<class F> struct AsList
{
    using type = Fields<F>;
};
template<class... F> struct AsList<Fields<F...>>
{
    using type = Fields<F...>;
};
template<class T> struct Results
{
    using type = typename AsList<typename T::Adds>::type;
};
template<class T>
requires requires { typename T::Provides; }
struct Results<T>
{
    using type = typename AsList<typename T::Provides>::type;
};
template<class T>
requires requires { typename T::Advances; }
struct Results<T>
{
    using type = typename AsList<typename T::Advances>::type;
};

template<class List, int dim> struct ValueOf
{
    using type = Values<List, dim>;
};
template<class F, int dim> struct ValueOf<Fields<F>, dim>
{
    using type = FieldValue<F, dim>;
};
}

template<class T> using ReadsOf = typename detail::Reads<T>::type;
template<class T> using ReadsOwnOf = typename detail::ReadsOwn<T>::type;
template<class T> using ResultsOf = typename detail::Results<T>::type;
template<class T> constexpr bool provides = requires { typename T::Provides; };
template<class T> constexpr bool advances = requires { typename T::Advances; };
template<class T> constexpr bool readsKernel = requires { T::readsKernel; };
/// True for a wall law.
template<class T> constexpr bool atWalls = requires { T::atWalls; };
/// True for what must see gradW as the kernel has it: the sums that its normalisation is made of.
template<class T> constexpr bool ofRawGradient = requires { T::ofRawGradient; };
template<class T> constexpr bool bearsSingle = requires { T::bearsSingle; };

template<class T, int dim, class Real = double> using OwnValues = Values<typename detail::Join<ReadsOf<T>, ReadsOwnOf<T>>::type, dim, Real>;
template<class T, int dim, class Real = double> using NeighbourValues = Values<ReadsOf<T>, dim, Real>;
template<class T, int dim> constexpr bool mayBeNothing = requires(const T& term, const OwnValues<T, dim>& i) { term.isNothingAt(i); };
/// Value of one result; Values<...> of several.
template<class T, int dim> using ResultValue = typename detail::ValueOf<ResultsOf<T>, dim>::type;

/// The nearest place of a patch of some wall.
template<int dim> struct WallFoot
{
    double distance;      ///< [m], > 0 in the fluid
    Vector<dim> normal;   ///< unit, into the fluid
    double k1, k2;        ///< principal curvatures [1/m] (Shape.hpp)
    int wall;             ///< index into Geometry::walls
    bool smooth;          ///< the place lies on a face: there is a mirror image
    bool uniformlyCurved; ///< the curvatures are the same all over the surface
};

template<class T, int dim>
concept Swept = requires(const T t, Pair<dim> ij, OwnValues<T, dim> i, NeighbourValues<T, dim> j, Sweep s)
{
    t(ij, i, j, s);
};
template<class T, int dim>
concept Summed = requires(const T t, Pair<dim> ij, OwnValues<T, dim> i, NeighbourValues<T, dim> j)
{
    t(ij, i, j);
};
template<class T, int dim>
concept PairTerm = !atWalls<T> && (Swept<T, dim> || Summed<T, dim>);
template<class T, int dim>
concept AdvancingLaw = advances<T> && requires(const T t, OwnValues<T, dim> i, double dt)
{
    {
        t(i, dt)
        } -> std::same_as<ResultValue<T, dim>>;
};
template<class T, int dim>
concept LocalLaw = AdvancingLaw<T, dim> || !advances<T> && requires(const T t, OwnValues<T, dim> i)
{
    {
        t(i)
        } -> std::same_as<ResultValue<T, dim>>;
};

namespace detail
{
template<class T, int dim> struct SoFar
{
    using type = ResultValue<T, dim>;
};
template<class T, int dim>
requires requires { typename T::template SoFar<dim>; }
struct SoFar<T, dim>
{
    using type = typename T::template SoFar<dim>;
};
}
/// State that a wall law carries from place to place: its result, unless it says otherwise.
template<class T, int dim> using SoFarOf = typename detail::SoFar<T, dim>::type;
template<class T, int dim>
concept WallLaw = atWalls<T> && requires(const T t, SoFarOf<T, dim> q, OwnValues<T, dim> i, WallFoot<dim> foot)
{
    {
        t(q, i, foot)
        } -> std::same_as<SoFarOf<T, dim>>;
    {
        t.wallReach()
        } -> std::same_as<double>;
};

/// The declared values, from component(0), component(1) ... in the order of the list.
template<int dim, class Real, class... F> Values<Fields<F...>, dim, Real> read(Values<Fields<F...>, dim, Real>, const auto& component)
{
    Values<Fields<F...>, dim, Real> v;
    [[maybe_unused]] int first = 0;
    (
        [&]
        {
            auto& [q] = static_cast<At<F, dim, Real>&>(v);
            fetch(q, [&](int c) { return component(first + c); });
            first += fieldComponents<F, dim>;
        }(),
        ...);
    return v;
}

/// Names of fields where they are not those of the tags: of one scalar of several, or of a rate that is kept apart.
using Names = std::map<std::string, std::string>;
inline std::string nameIn(const Names& names, const char* tag)
{
    const auto other = names.find(tag);
    return other == names.end() ? tag : other->second;
}

/// One field that a term reads or writes, without its type: what the planner needs to know.
template<int dim> struct FieldUse
{
    FieldInfo info;
    std::string name; ///< in this scene
    ValueType type;
    void (*refresh)(const Images<dim>&, FieldStore<dim>&, const std::string& name) = nullptr;
    void (*compute)(const Images<dim>&, FieldStore<dim>&, const std::string& name, std::size_t first, std::size_t n,
                    double* const* to) = nullptr;
};
template<int dim, class... F> std::vector<FieldUse<dim>> uses(Fields<F...>, const Names& names = {})
{
    return {{F::info, nameIn(names, F::info.name), valueType<FieldValue<F, dim>>, &Images<dim>::template refresh<F>,
             &Images<dim>::template compute<F>}...};
}

/// Arrays in which bound terms find their numbers: those of the store, and the stencil column of each component read at j. `adds`: something
/// has written to the result before in this evaluation.
template<int dim> struct Binding
{
    FieldStore<dim>& store;
    const Names& names;
    const std::map<std::string, int>& firstColumn;
    bool adds;
};

template<int dim> struct Operation
{
    virtual ~Operation() = default;
    virtual void gather(const Stencil<dim>&) const {}                   ///< pair term: the particle stencil.i
    virtual void gather(const Stencil<dim, Single>&) const {}           ///< likewise, of one that bears single precision
    virtual bool isNothingAt(std::size_t /*i*/) const { return false; } ///< pair term: its sum is 0 there without a look at its neighbours
    virtual void clear(std::size_t /*i*/) const {}                      ///< its result is 0 there
    virtual void evaluate(std::size_t /*begin*/, std::size_t /*end*/, double /*deltaT*/) const {} ///< local law: particles begin .. end - 1
    virtual void atWalls(const NearWalls&, std::size_t /*begin*/, std::size_t /*end*/) const {}   ///< wall law: likewise
};

template<class T, int dim> class Bound final : public Operation<dim>
{
    using Own = OwnValues<T, dim>;
    using Result = ResultValue<T, dim>;
    static constexpr int nOwn = valueComponents<Own>, nNeighbour = valueComponents<NeighbourValues<T, dim>>;
    static constexpr int nResult = []<class... F>(Fields<F...>) { return (fieldComponents<F, dim> + ...); }(ResultsOf<T>{});

    T term_;
    bool adds_;
    std::array<double*, nOwn> own_;
    std::array<int, nNeighbour> column_;
    std::array<double*, nResult> result_;
    std::array<double*, dim> position_;

    /// set(c, value) for component c of the result, counted over all its fields.
    static void eachComponent(const Result& result, const auto& set)
    {
        if constexpr (ResultsOf<T>::count == 1) store(result, set);
        else eachOfSeveral(ResultsOf<T>{}, result, set);
    }
    template<class... F> static void eachOfSeveral(Fields<F...>, const Result& result, const auto& set)
    {
        int first = 0;
        (
            [&]
            {
                const auto& [q] = static_cast<const At<F, dim>&>(result);
                store(q, [&](int c, double a) { set(first + c, a); });
                first += fieldComponents<F, dim>;
            }(),
            ...);
    }

public:
    Bound(const T& term, const Binding<dim>& b) : term_(term), adds_(b.adds), position_(b.store.pointers(Position{}))
    {
        const auto bind = [&]<class... F>(Fields<F...>, double** to)
        {
            (
                [&]
                {
                    for (int c = 0; c < fieldComponents<F, dim>; ++c) *to++ = b.store.component(nameIn(b.names, F::info.name), c);
                }(),
                ...);
            return to;
        };
        bind(ReadsOwnOf<T>{}, bind(ReadsOf<T>{}, own_.data()));
        bind(ResultsOf<T>{}, result_.data());
        int k = 0;
        if constexpr (PairTerm<T, dim>)
            for (const auto& f : uses<dim>(ReadsOf<T>{}, b.names))
                for (int c = 0; c < f.type.components; ++c) column_[std::size_t(k++)] = b.firstColumn.at(f.name) + c;
    }

    [[gnu::flatten]] void gather(const Stencil<dim>& stencil) const override
    {
        if constexpr (PairTerm<T, dim>) gatherIn<double>(stencil);
    }
    [[gnu::flatten]] void gather([[maybe_unused]] const Stencil<dim, Single>& stencil) const override
    {
        if constexpr (PairTerm<T, dim> && bearsSingle<T>) gatherIn<Single>(stencil);
    }
    template<class Real> void gatherIn(const Stencil<dim, Real>& stencil) const
    {
        const T term = term_;
        std::array<const Real*, nNeighbour> column;
        for (int k = 0; k < nNeighbour; ++k) column[k] = stencil.field[column_[k]];
        const auto own = read<dim>(Own{}, [&](int k) { return own_[k][stencil.i]; });
        const auto i = read<dim>(OwnValues<T, dim, Real>{}, [&](int k) { return Real(own_[k][stencil.i]); });
        const auto j = [&](int t) { return read<dim>(NeighbourValues<T, dim, Real>{}, [&](int k) { return column[k][t]; }); };
        Result total{};
        if constexpr (Swept<T, dim>)
            for (int s = 0; s < term.sweeps(); ++s)
            {
                const Sweep sweep{s};
                using Sum = decltype(term(stencil.pair(0), i, j(0), sweep));
                total += term.finish(own, sum<Sum>(stencil.n, [&](int t) { return term(stencil.pair(t), i, j(t), sweep); }), sweep);
            }
        else
        {
            using Sum = decltype(term(stencil.pair(0), i, j(0)));
            const auto all = sum<Sum>(stencil.n, [&](int t) { return term(stencil.pair(t), i, j(t)); });
            if constexpr (requires { term.finish(own, all); }) total = term.finish(own, all);
            else total = all;
        }
        eachComponent(total, [&](int c, double q) { result_[c][stencil.i] = adds_ ? result_[c][stencil.i] + q : q; });
    }

    bool isNothingAt([[maybe_unused]] std::size_t i) const override
    {
        if constexpr (mayBeNothing<T, dim>) return term_.isNothingAt(read<dim>(Own{}, [&](int k) { return own_[k][i]; }));
        else return false;
    }
    void clear(std::size_t i) const override
    {
        for (double* const q : result_)
            if (!adds_) q[i] = 0;
    }

    [[gnu::flatten]] void evaluate(std::size_t begin, std::size_t end, [[maybe_unused]] double deltaT) const override
    {
        if constexpr (LocalLaw<T, dim>)
        {
            const T law = term_;
            const auto own = own_;
            const auto result = result_;
            const auto value = [&](const Own& i)
            {
                if constexpr (AdvancingLaw<T, dim>) return law(i, deltaT);
                else return law(i);
            };
            const auto each = [&](auto adds)
            {
#pragma GCC ivdep
                for (std::size_t i = begin; i < end; ++i)
                    eachComponent(value(read<dim>(Own{}, [&](int k) { return own[k][i]; })),
                                  [&](int c, double q) { result[c][i] = adds() ? result[c][i] + q : q; });
            };
            if (adds_) each(std::true_type{});
            else each(std::false_type{});
        }
    }

    void atWalls([[maybe_unused]] const NearWalls& walls, [[maybe_unused]] std::size_t begin,
                 [[maybe_unused]] std::size_t end) const override
    {
        if constexpr (WallLaw<T, dim>)
            for (std::size_t i = begin; i < end; ++i)
            {
                Vector<dim> x;
                fetch(x, [&](int c) { return position_[c][i]; });
                const auto own = read<dim>(Own{}, [&](int k) { return own_[k][i]; });
                SoFarOf<T, dim> soFar{};
                if constexpr (std::same_as<SoFarOf<T, dim>, Result>)
                    if (adds_) fetch(soFar, [&](int c) { return result_[c][i]; });
                walls.forEachFoot(in3D(x), term_.wallReach(),
                                  [&](const Foot& foot, const Patch& patch)
                                  {
                                      soFar = term_(soFar, own,
                                                    WallFoot<dim>{foot.distance, in<dim>(foot.normal), foot.k1, foot.k2,
                                                                  patch.wallAt(foot.region), foot.smooth, patch.shape->uniformlyCurved()});
                                  });
                const auto set = [&](int c, double q) { result_[c][i] = q; };
                if constexpr (requires { term_.finish(soFar); }) eachComponent(term_.finish(soFar), set);
                else eachComponent(soFar, set);
            }
    }
};

}
