/// What a term is, and the loop that runs it. Physics is the functor; looping, vector lanes and memory are here, once.
///
///   pair term   operator()(ij, i, j)   summed over the stencil of i;   Reads at i and j, ReadsOwn at i alone (costs no gather)
///               finish(i, sum)         optional: what the sum means
///               sweeps()               optional: how many sums; then operator()(ij, i, j, sweep), finish(i, sum, sweep), added up
///   local law   operator()(i)          one particle at a time;         ReadsOwn
///   Provides one derived field (its only writer), or Adds to a rate that several terms share
///
/// The type is erased once per particle and term (one virtual call per 80 pairs): compiled variants are the sum of the options.
#pragma once
#include "Coefficients.hpp"
#include "Images.hpp"
#include "Stencil.hpp"
#include "laneSums.hpp"
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
template<class... A, class... B> struct Join<Fields<A...>, Fields<B...>> { using type = Fields<A..., B...>; };

template<class T> struct Reads { using type = Fields<>; };
template<class T> requires requires { typename T::Reads; } struct Reads<T> { using type = typename T::Reads; };
template<class T> struct ReadsOwn { using type = Fields<>; };
template<class T> requires requires { typename T::ReadsOwn; } struct ReadsOwn<T> { using type = typename T::ReadsOwn; };
template<class T> struct Result { using type = typename T::Adds; static constexpr bool provided = false; };
template<class T> requires requires { typename T::Provides; } struct Result<T> { using type = typename T::Provides; static constexpr bool provided = true; };
}

template<class T> using ReadsOf = typename detail::Reads<T>::type;
template<class T> using ReadsOwnOf = typename detail::ReadsOwn<T>::type;
template<class T> using ResultOf = typename detail::Result<T>::type;
template<class T> constexpr bool provides = detail::Result<T>::provided;
template<class T> constexpr bool readsKernel = requires { T::readsKernel; };
/// True for what must see gradW as the kernel has it: the sums that its normalisation is made of.
template<class T> constexpr bool ofRawGradient = requires { T::ofRawGradient; };

template<class T, int dim> using OwnValues = Values<typename detail::Join<ReadsOf<T>, ReadsOwnOf<T>>::type, dim>;
template<class T, int dim> using NeighbourValues = Values<ReadsOf<T>, dim>;
template<class T, int dim> using ResultValue = FieldValue<ResultOf<T>, dim>;

template<class T, int dim> concept Swept = requires(const T t, Pair<dim> ij, OwnValues<T, dim> i, NeighbourValues<T, dim> j, Sweep s) { t(ij, i, j, s); };
template<class T, int dim> concept Summed = requires(const T t, Pair<dim> ij, OwnValues<T, dim> i, NeighbourValues<T, dim> j) { t(ij, i, j); };
template<class T, int dim> concept PairTerm = Swept<T, dim> || Summed<T, dim>;
template<class T, int dim> concept LocalLaw = requires(const T t, OwnValues<T, dim> i) { { t(i) } -> std::same_as<ResultValue<T, dim>>; };

/// The declared values, from component(0), component(1) ... in the order of the list.
template<int dim, class... F> Values<Fields<F...>, dim> read(Values<Fields<F...>, dim>, const auto& component)
{
    Values<Fields<F...>, dim> v;
    [[maybe_unused]] int first = 0;
    ([&] { auto& [q] = static_cast<At<F, dim>&>(v); fetch(q, [&](int c) { return component(first + c); }); first += fieldComponents<F, dim>; }(), ...);
    return v;
}

/// One field that a term reads or writes, without its type: what the planner needs to know.
template<int dim> struct FieldUse
{
    FieldInfo info;
    ValueType type;
    void (*refresh)(const Images<dim>&, FieldStore<dim>&);
};
template<int dim, class... F> std::vector<FieldUse<dim>> uses(Fields<F...>)
{
    return {{F::info, valueType<FieldValue<F, dim>>, &Images<dim>::template refresh<F>}...};
}

/// Where bound terms find their numbers: arrays of the store, and the stencil column of each component read at j. `adds`: something
/// has written to the result before in this evaluation.
template<int dim> struct Binding
{
    FieldStore<dim>& store;
    const Coefficients& coefficients;
    const std::map<std::string, int>& firstColumn;
    bool adds;
};

template<int dim> struct Operation
{
    virtual ~Operation() = default;
    virtual void gather(const Stencil<dim>&) const {}                        ///< pair term: the particle stencil.i
    virtual void evaluate(std::size_t /*begin*/, std::size_t /*end*/) const {} ///< local law: particles begin .. end - 1
};

template<class T, int dim> class Bound final : public Operation<dim>
{
    using Own = OwnValues<T, dim>;
    using Neighbour = NeighbourValues<T, dim>;
    using Result = ResultValue<T, dim>;
    static constexpr int nOwn = valueComponents<Own>, nNeighbour = valueComponents<Neighbour>;

    T term_;
    bool adds_;
    std::array<double*, nOwn> own_;
    std::array<int, nNeighbour> column_;
    std::array<double*, fieldComponents<ResultOf<T>, dim>> result_;

    static T make(const Coefficients& c)
    {
        if constexpr (std::constructible_from<T, const Coefficients&>) return T(c);
        else return T{};
    }

public:
    explicit Bound(const Binding<dim>& b) : term_(make(b.coefficients)), adds_(b.adds), result_(b.store.pointers(ResultOf<T>{}))
    {
        int n = 0, k = 0;
        const auto bindOwn = [&]<class... F>(Fields<F...>)
        { ([&] { for (double* p : b.store.pointers(F{})) own_[n++] = p; }(), ...); };
        bindOwn(ReadsOf<T>{});
        bindOwn(ReadsOwnOf<T>{});
        if constexpr (PairTerm<T, dim>)
            for (const auto& f : uses<dim>(ReadsOf<T>{}))
                for (int c = 0; c < f.type.components; ++c) column_[k++] = b.firstColumn.at(f.info.name) + c;
    }

    [[gnu::flatten]] void gather(const Stencil<dim>& stencil) const override
    {
        if constexpr (PairTerm<T, dim>)
        {
            const T term = term_;
            std::array<const double*, nNeighbour> column;
            for (int k = 0; k < nNeighbour; ++k) column[k] = stencil.field[column_[k]];
            const auto i = read<dim>(Own{}, [&](int k) { return own_[k][stencil.i]; });
            const auto j = [&](int t) { return read<dim>(Neighbour{}, [&](int k) { return column[k][t]; }); };
            Result total{};
            if constexpr (Swept<T, dim>)
                for (int s = 0; s < term.sweeps(); ++s)
                {
                    const Sweep sweep{s};
                    using Sum = decltype(term(stencil.pair(0), i, j(0), sweep));
                    total += term.finish(i, sum<Sum>(stencil.n, [&](int t) { return term(stencil.pair(t), i, j(t), sweep); }), sweep);
                }
            else
            {
                using Sum = decltype(term(stencil.pair(0), i, j(0)));
                const Sum all = sum<Sum>(stencil.n, [&](int t) { return term(stencil.pair(t), i, j(t)); });
                if constexpr (requires { term.finish(i, all); }) total = term.finish(i, all);
                else total = all;
            }
            store(total, [&](int c, double q) { result_[c][stencil.i] = adds_ ? result_[c][stencil.i] + q : q; });
        }
    }

    [[gnu::flatten]] void evaluate(std::size_t begin, std::size_t end) const override
    {
        if constexpr (LocalLaw<T, dim>)
        {
            const T law = term_;
            const auto own = own_;
            const auto result = result_;
            const auto each = [&](auto adds)
            {
                #pragma GCC ivdep
                for (std::size_t i = begin; i < end; ++i)
                    store(law(read<dim>(Own{}, [&](int k) { return own[k][i]; })),
                          [&](int c, double q) { result[c][i] = adds() ? result[c][i] + q : q; });
            };
            if (adds_) each(std::true_type{});
            else each(std::false_type{});
        }
    }
};

}
