/// From the selected words to the passes of an evaluation: close, order, merge, allocate, print.
///
/// Close: a field that is read and not given by the scene needs exactly one provider; it is added.
/// Where a term that provides gradientScale is selected, every pair term but those of the raw gradient waits for it, and its pass sees
/// the normalised gradW.
/// Order: local laws as soon as what they read is there; then all pair terms that are ready share one stencil pass.
#pragma once
#include "Catalogue.hpp"
#include <functional>
#include <iosfwd>
#include <set>

namespace sph
{

template<int dim> class Plan
{
public:
    /// `selected` names of terms; `given` names of the fields that the scene brings (its state), `current` those of them whose images need
    /// no refreshing. The catalogue must outlive the plan. Throws CaseError naming the term that lacks a provider, has several, or waits
    /// in a circle.
    Plan(const Catalogue<dim>&, const std::vector<std::string>& selected, std::set<std::string> given, std::set<std::string> current = {});

    void allocate(FieldStore<dim>&) const;
    /// Positions, volume factors and what some pass gathers: all that images need values of.
    std::set<std::string> readAtNeighbours() const;
    /// Again after each change of the arrays or the coefficients.
    void bind(FieldStore<dim>&, const Coefficients&);
    /// The lists keep, for the pair passes behind the first, what lies within the support.
    void evaluate(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists, const Kernel<dim>& kernel)
    {
        evaluate(store, images, lists, kernel, pairPasses() > 1 ? Candidates::listedAndKept : Candidates::listed);
    }
    /// The same, where another plan is evaluated at the same positions: `listedAndKept` keeps the pairs for it, `kept` takes them.
    enum class Candidates { listed, listedAndKept, kept };
    void evaluate(FieldStore<dim>&, const Images<dim>&, NeighbourLists<dim>&, const Kernel<dim>&, Candidates);

    int pairPasses() const;
    /// Of the packed records.
    std::size_t bytes() const { return records_.capacity()*sizeof(double); }
    bool has(const std::string& term) const;
    /// Passes with the terms in them, why each term is there, columns gathered, image fields refreshed; those of another plan that is
    /// evaluated `when`, if there is one; fields; what was left out.
    void print(std::ostream&, const FieldStore<dim>&, const Plan* another = nullptr, const char* when = "") const;
    /// The passes alone, of a plan that another one's evaluation is followed by.
    void printPasses(std::ostream&) const;

private:
    using Entry = CatalogueEntry<dim>;
    struct Pass
    {
        std::vector<const Entry*> entries;
        std::map<std::string, int> firstColumn;            ///< components read at j, each gathered once
        std::vector<FieldUse<dim>> columns, refresh;       ///< refresh: those written since images last saw them
        std::vector<const double*> sources;
        std::vector<std::unique_ptr<Operation<dim>>> operations;
        typename Stencil<dim>::Factors factors;                     ///< their columns, behind those of the terms
        bool readsKernel = false, normalised = false;       ///< normalised: gradW over the mean gradientScale of the pair
        bool pair() const { return entries[0]->pair; }
    };
    const Catalogue<dim>& catalogue_;
    std::set<std::string> given_, current_;
    std::vector<const Entry*> chosen_;
    std::map<const Entry*, std::string> reason_;
    std::vector<Pass> passes_;
    Array records_;                                        ///< positions and first columns of the pass at hand, packed

    void close();
    void order();
    void evaluatePairs(const Pass&, Candidates, FieldStore<dim>&, const Images<dim>&, NeighbourLists<dim>&, const Kernel<dim>&);
    const double* pack(const Pass&, FieldStore<dim>&);
};

}
