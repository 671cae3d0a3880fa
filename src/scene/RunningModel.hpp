/// A model at run time, beside its terms: stages of a step and of the making of lists, limits of the step, energy, lines of the log, numbers of
/// a restart. It is made at start-up; a model without such needs has none.
///
///     template<int dim> class Damping final : public RunningModel<dim>
///     {
///         std::vector<Stage<dim>> stages(JoinPoint point) override
///         {
///             if (point != JoinPoint::afterKick) return {};
///             return {{"damp", "v *= exp(-rate dt)", [this](Particles<dim>& p, const Substep& s) { damp(p, s.deltaT); }}};
///         }
///     };
///     settings.runningModels.push_back(running<Damping>(rate, until));               // in the model's `read`
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

template<int dim> class Particles;
struct Settings;
struct Geometry;
struct FieldInfo;

/// Numbers of a restart beside the fields.
using Numbers = std::map<std::string, double>;

/// The part of a step that stages are run in.
struct Substep
{
    double time, deltaT; ///< time at its start, and its length [s]
    double whole;        ///< length of the step that it is a part of [s]
};

/// A line of a step's algorithm. Under it -dry-run prints the passes of the groups that it evaluates.
template<int dim> struct Stage
{
    std::string name;     ///< "drift"
    std::string equation; ///< "x += dt/2 v"
    std::function<void(Particles<dim>&, const Substep&)> run;
    std::vector<std::string> groups;
    bool onceAStep; ///< the stage runs in the middle one of several substeps alone
    /// Takes back what the stage has done to the state, if it has done anything, where it or a later one throws StepTooLong.
    std::function<void(Particles<dim>&, const Substep&)> undo;

    Stage(std::string called, std::string does, std::function<void(Particles<dim>&, const Substep&)> f,
          std::vector<std::string> evaluates = {}, bool once = false)
        : name(std::move(called)), equation(std::move(does)), run(std::move(f)), groups(std::move(evaluates)), onceAStep(once)
    {}
    Stage undoneBy(std::function<void(Particles<dim>&, const Substep&)> f) &&
    {
        undo = std::move(f);
        return std::move(*this);
    }
};

/// Points of a step, and of what is done within its stages, at which stages of models join those of an integrator.
enum class JoinPoint
{
    loaded,   ///< once, when the particles of a time folder have been loaded, before any are removed or inserted
    start,    ///< once, after the first evaluation of a run or the loading of a restart, before what acts once a step is evaluated
    exchange, ///< before each sorting: removes and inserts particles (Particles::setSize)
    sorted,   ///< after particles have been sorted and lists have been built
    moved,    ///< at new positions before an evaluation between two sortings
    complete, ///< after an evaluation: fields that output, log and limits need beyond it, at the present state; what the next step reads stays as it was
    beforeDrift,
    beforeEvaluation, ///< positions are those that forces are taken at, velocities still those of the start of the step
    afterEvaluation,  ///< after each evaluation: also at the start, and before fields are written
    solve,            ///< forces are there, velocities are not
    afterKick,        ///< velocities are those of the end of the step
    afterDrift,
    atEnd
};

/// Points that lie within a stage of the step, and those of the start.
inline constexpr JoinPoint withinStages[]{JoinPoint::loaded, JoinPoint::start,           JoinPoint::exchange, JoinPoint::sorted,
                                          JoinPoint::moved,  JoinPoint::afterEvaluation, JoinPoint::complete};

/// A step that is stable, and the criterion that binds.
struct StepLimit
{
    double deltaT;
    std::string by;
    bool ofSubstep = false;           ///< limit by what acts in each substep, with the most substeps; else by what acts once
    const FieldInfo* field = nullptr; ///< field whose largest value, of one particle, sets the limit; none where constants of the scene do
};

/// Energy that a model stores in the fluid [J], per metre of depth in 2-D.
struct StoredEnergy
{
    std::string of; ///< what stores it: "interfaces"
    double value;
    bool isHeld =
        true; ///< held against what the scene has supplied; else it is a supply at the start alone, as compression is, which sound carries
};

template<int dim> class RunningModel
{
public:
    virtual ~RunningModel() = default;
    /// Stages that join the step at a place, in order.
    virtual std::vector<Stage<dim>> stages(JoinPoint) { return {}; }
    /// Sets to 0, at buffer particles, a rate that is about to act for `deltaT` [s] by a model's own step.
    virtual void withholdRate(Particles<dim>&, const std::string& /*field*/, double /*deltaT*/) {}
    /// Further limits of the step.
    virtual std::vector<StepLimit> limits() const { return {}; }
    /// Mass of a phase that the model has let into the scene since the first start, less what it has taken out, openings aside [kg].
    virtual double letIn(std::size_t /*phase*/) const { return 0; }
    /// Numbers of the log's columns, by name.
    virtual Numbers columns(const Particles<dim>&) const { return {}; }
    /// Text of the log, once before the first step and at each report: lines, each with its line end.
    virtual std::string introduction() const { return ""; }
    virtual std::string report(const Particles<dim>&) const { return ""; }
    /// A few words on the line of the step.
    virtual std::string note() const { return ""; }
    /// Warning of a state that the resolution or the model does not bear, asked for before each time folder and given once; "" where there is none.
    virtual std::string warning(const Particles<dim>&) { return ""; }
    /// Adds the numbers of a restart.
    virtual void save(Numbers&) const {}
    /// Power of the model upon the fluid in the last step, or the most that it can have been [W].
    virtual double power() const { return 0; }
    /// The same as measured.
    virtual double measuredPower() const { return power(); }
    /// Energy that the model stores at the present state.
    virtual std::optional<StoredEnergy> energy(const Particles<dim>&) const { return {}; }
    /// The most that the model may give to motion from its start on, besides its energy and power [J]; `mass` of each phase in the scene [kg].
    virtual double supply(const Particles<dim>&, const std::vector<double>& /*mass*/) const { return 0; }
    virtual std::size_t bytes() const { return 0; }
};

/// Makes a model at run time in either dimension.
struct RunningModelMaker
{
    template<int dim> using Make = std::function<std::unique_ptr<RunningModel<dim>>(Particles<dim>&, const Numbers& restored)>;
    Make<2> make2;
    Make<3> make3;
    template<int dim> const Make<dim>& make() const
    {
        if constexpr (dim == 2) return make2;
        else return make3;
    }
};
/// Maker of `M<dim>(particles, restored, args...)`.
template<template<int> class M, class... Args> RunningModelMaker running(Args... args)
{
    const auto make = [=]<int dim>(std::integral_constant<int, dim>) -> RunningModelMaker::Make<dim>
    {
        return [=](Particles<dim>& particles, const Numbers& restored) -> std::unique_ptr<RunningModel<dim>>
        { return std::make_unique<M<dim>>(particles, restored, args...); };
    };
    return {make(std::integral_constant<int, 2>{}), make(std::integral_constant<int, 3>{})};
}

}
