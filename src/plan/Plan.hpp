/// The plan of a scene: it turns the selected terms into the passes of every evaluation. Close, order, merge, allocate, print.
///
/// A plan has groups of passes. The first is an evaluation: all that follows from the state. Further ones run at the same positions, where a
/// stage of the integrator asks for them: forces that act once in several substeps, terms that a solver or a subcycle repeats. They find what the groups
/// before them have left there, images and pairs included.
///
/// Close: a field that is read, that is no state and that no group before provides, needs exactly one provider; it is added. Fields that the
/// rule of an image reads count as read by the term whose neighbours' values it makes.
/// Where a term that provides gradientScale is selected, every pair term but those of the raw gradient waits for it, and its pass sees
/// the normalised gradW, unless its group has a kernel of its own.
/// Order: wall laws and local laws as soon as what they read is there; then all pair terms that are ready share one stencil pass; wall laws that
/// add to a rate come last.
#pragma once
#include "plan/Catalogue.hpp"
#include <functional>
#include <iosfwd>
#include <optional>
#include <set>
#include <span>

namespace sph
{

/// A kernel by which a group sees its neighbours, beside the scene's: an average over more than the neighbours that forces see, say.
struct OwnKernel
{
    std::string name;
    double support; ///< [m]
};

/// A group of passes as a scene asks for it.
struct Group
{
    std::string name; ///< name of the stage that runs it
    std::vector<std::string> terms;
    std::set<std::string> changed = {};   ///< fields whose values differ from those in the groups before
    Names names = {};                     ///< other names of results that are summed separately
    std::set<std::string> inputs = {};    ///< fields that the caller writes before the group runs: the change that a solver tries
    std::optional<OwnKernel> kernel = {}; ///< none: the scene's; not for the first group
    /// Fields by which the caller chooses BoundaryShare, by which each neighbour then counts in place of its volume factor; none: by that factor.
    std::set<std::string> sharesBy = {};
    bool repeats = false; ///< runs several times between two evaluations, as the iterations of a solve do
    /// Pair passes of the group are computed in single precision where all of their terms bear it; sums of forces stay double.
    bool bearsSingle = false;
};

template<int dim> class Plan
{
public:
    /// `state`: names of the fields that the scene provides; `ruleReads`: fields that the rule of a field's images reads of their source. The catalogue must
    /// outlive the plan. Throws CaseError naming the term that lacks a provider, has several, or waits in a circle.
    Plan(const Catalogue<dim>&, const std::vector<Group>&, std::set<std::string> state,
         std::map<std::string, std::vector<FieldUse<dim>>> ruleReads = {});
    /// A plan of one evaluation alone.
    Plan(const Catalogue<dim>& catalogue, const std::vector<std::string>& terms, std::set<std::string> state)
        : Plan(catalogue, {{"evaluate", terms}}, std::move(state))
    {}

    void allocate(FieldStore<dim>&) const;
    /// Fields that images need room for: what they are by themselves; all else that passes gather is computed where it is packed. Where walls are layers these are all fields that
    /// some pass gathers, and where ranks share the particles those that rules of images read of copies as well.
    std::set<std::string> imaged(const Images<dim>&) const;
    /// Binds terms to their arrays; to be called again after each change of the arrays or the coefficients.
    void bind(FieldStore<dim>&, const Coefficients&);
    /// Runs the passes of a group. `kernel` is the scene's, the same for all groups: a group that has its own says so itself. `deltaT` [s] is the step of laws that
    /// advance a state. `leftOut` marks owned particles at which all sums of the group are taken for 0, without a look at their neighbours; none where it is empty.
    void evaluate(FieldStore<dim>&, const Images<dim>&, NeighbourLists<dim>&, const Kernel<dim>&, std::size_t group = 0, double deltaT = 0,
                  std::span<const std::uint8_t> leftOut = {});
    /// Runs the pair passes of a group of given shares for these particles alone.
    void evaluateAt(std::span<const int> particles, FieldStore<dim>&, const Images<dim>&, NeighbourLists<dim>&, const Kernel<dim>&,
                    std::size_t group);

    /// Index of the group of that name; throws std::logic_error where there is none.
    std::size_t group(const std::string& name) const;
    bool hasGroup(const std::string& name) const;
    int pairPasses(std::size_t group = 0) const;
    /// Number of pair passes run since the start, of all groups.
    long pairPassesRun() const { return pairPassesRun_; }
    /// Scratch memory between evaluations: the next one packs its records into it anew.
    std::span<double> idle() { return {packed<double>(), records_.size() / sizeof(double)}; }
    /// Memory of the packed records.
    std::size_t bytes() const { return records_.capacity(); }
    bool has(const std::string& term) const;
    bool provides(const std::string& field) const;

    /// Number of runs of each operation, by "group/term".
    using Counts = std::map<std::string, long>;
    void countInto(Counts* counts) { counts_ = counts; }

    /// Passes of a group with the terms in them, numbered on from `operation` and `pass`, why each term is there, columns gathered, image fields
    /// refreshed, and computed when packed.
    void printGroup(std::ostream&, std::size_t group, int& pass, int& operation) const;
    /// Fields, bytes, and the terms of the catalogue that no group has.
    void printFields(std::ostream&, const FieldStore<dim>&) const;
    /// Prints all groups in order, and the fields.
    void print(std::ostream&, const FieldStore<dim>&) const;

private:
    using Entry = CatalogueEntry<dim>;
    struct Pass
    {
        std::vector<const Entry*> entries;
        std::map<std::string, int> firstColumn;      ///< components read at j, each gathered once
        std::vector<FieldUse<dim>> columns, refresh; ///< refresh: those written since images last saw them, where they have room for them
        std::vector<const double*> sources;
        struct Computed
        {
            FieldUse<dim> field;
            std::size_t column; ///< its first
        };
        std::vector<Computed> computed; ///< fields without room for images, whose values are computed where they are packed
        std::vector<std::unique_ptr<Operation<dim>>> operations;
        PairFactors factors;                          ///< columns of the factors, behind those of the terms
        bool readsKernel = false, normalised = false; ///< normalised: gradW over the mean gradientScale of the pair
        bool within = false, keepsWithin = false;     ///< reads the neighbours within the support that a pass before has kept; keeps them
        bool slopes = false, keepsSlopes = false;     ///< likewise (dW/dr)/r of their pairs, with all factors
        bool single = false;                          ///< gathers in single precision
        bool leavesOut = false;                       ///< particles at which all of its terms are 0 by their own values
        bool pair() const { return entries[0]->over == Over::pairs; }
    };
    struct Passes
    {
        Group group;
        std::vector<const Entry*> chosen;
        std::map<const Entry*, std::string> reason;
        std::vector<Pass> passes;
        std::optional<Kernel<dim>> kernel; ///< its own, which finds its neighbours in the lists at each pass
        std::string resultName(const FieldUse<dim>& f) const { return nameIn(group.names, f.name.c_str()); }
    };
    const Catalogue<dim>& catalogue_;
    std::set<std::string> state_;
    std::map<std::string, std::vector<FieldUse<dim>>> ruleReads_;
    std::vector<Passes> groups_;
    /// Positions and columns of the pass at hand, packed, as doubles or floats.
    std::vector<std::byte, AlignedAllocator<std::byte>> records_;
    std::set<std::string> computed_; ///< fields that some pass computes of images
    bool keepsSingleSlopes_ = false;
    Counts* counts_ = nullptr;
    long pairPassesRun_ = 0;

    std::set<std::string> readAtNeighbours() const;
    std::set<std::string> readOfCopies() const;
    /// Calls f(field) for all that an entry reads, rules of images included.
    void forEachRead(const Entry&, const std::function<void(const FieldUse<dim>&)>& f) const;
    std::set<std::string> outdatedBy(std::set<std::string> fields) const;
    void select(Passes&);
    void close(Passes&, const std::set<std::string>& given);
    void order(Passes&, const std::set<std::string>& given, std::set<std::string>& fresh);
    /// Decides what each pass keeps of its pairs for those behind it.
    void keepPairs();
    /// `only`: the particles that the pass is for; all where there is none.
    void evaluatePairs(const Pass&, FieldStore<dim>&, const Images<dim>&, NeighbourLists<dim>&, const Kernel<dim>&,
                       std::optional<std::span<const int>> only, std::span<const std::uint8_t> leftOut);
    template<class Real> Real* packed() { return reinterpret_cast<Real*>(records_.data()); }
    /// Packs positions and columns of the particles [begin, end), images among them: in arrays of Stencil::recordWidth doubles, or as records of single precision.
    void pack(const Pass&, FieldStore<dim>&, const Images<dim>&, std::size_t begin, std::size_t end);
    /// Fields that a pass reads of copies of other ranks' particles, and that were written since these were last refreshed.
    std::vector<std::string> copiedFor(const Pass&, const FieldStore<dim>&) const;
};

}
