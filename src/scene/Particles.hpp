/// The particles with their images, lists, plan and the models at run time: everything that stages change, and nothing of time.
#pragma once
#include "geometry/MovingWalls.hpp"
#include "images/Images.hpp"
#include "plan/Plan.hpp"
#include "scene/LeakGuard.hpp"
#include "scene/Settings.hpp"
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace sph
{

template<int dim> class Particles
{
public:
    /// Settings and catalogue must outlive the particles. Throws CaseError where particles do not fit the scene.
    Particles(const Settings&, const Geometry&, const Catalogue<dim>&, Cloud, const Numbers& restored);

    /// Evaluates rates and derived fields at the present state: a pure function of the state.
    void evaluate();
    /// Evaluates a further group of the plan, after an evaluation and at the same positions. `deltaT` [s] is the step of laws that advance a state. The
    /// neighbours of particles that `leftOut` marks are not looked at: their sums are 0.
    void evaluate(const std::string& group, double deltaT = 0, std::span<const std::uint8_t> leftOut = {});
    /// Evaluates a group of given shares (Group::sharesBy) for these particles alone.
    void evaluateAt(std::span<const int> particles, const std::string& group);
    /// Evaluates all fields at the present state for whoever looks at them, and leaves no trace: what a step reads before it evaluates, and so
    /// the bytes of a run, stay as they are.
    void observe();
    /// Power of each operation that accelerates, sum_i m_i v_i.a_i of its acceleration alone [W], by name; leaves no trace.
    std::map<std::string, double> powers();
    /// Observes after the particles have been sorted: a restart begins with what is then written.
    void settle();
    /// Wraps and sorts the particles, and makes images and lists anew.
    void rebuild();
    /// Tells how far any particle may have moved since; lists are rebuilt when that may matter.
    void moved(double distance) { travelled_ += distance * images_.closingSpeed(); }

    /// Walls that move across themselves go on, as particles do in a drift.
    void driftWalls(double deltaT);
    const MovingWalls& movingWalls() const { return movingWalls_; }
    /// Sets the velocity of a wall under load.
    void pushWall(int wall, const Vector<3>& velocity) { movingWalls_.push(geometry_, wall, velocity); }

    std::size_t size() const { return owned_; }
    /// Number of particles after some have come in or gone, in stages of JoinPoint::exchange.
    void setSize(std::size_t owned) { owned_ = owned; }
    /// Number of particles of all ranks.
    std::size_t total() const;
    const Settings& settings() const { return settings_; }
    const Geometry& geometry() const { return geometry_; }
    const Coefficients& coefficients() const { return coefficients_; }
    /// Sets the gravity of the evaluations from now on [m/s^2].
    void setGravity(const Vector<3>& g) { coefficients_.g = g; }
    /// Numbers of a model that vary with time, of the evaluations from now on.
    template<class T> T& numbersOf() { return coefficients_.template of<T>(); }
    /// Sets the scale of the number density, of the evaluations from now on.
    void setDensityScale(double scale)
    {
        coefficients_.densityScale = scale;
        bind();
    }
    FieldStore<dim>& store() { return store_; }
    const FieldStore<dim>& store() const { return store_; }
    Images<dim>& images() { return images_; }
    const Images<dim>& images() const { return images_; }
    const NearWalls& nearWalls() const { return images_.nearWalls(); }
    const NeighbourLists<dim>& lists() const { return lists_; }
    const Plan<dim>& plan() const { return plan_; }
    Plan<dim>& plan() { return plan_; }
    const Kernel<dim>& kernel() const { return kernel_; }
    const std::vector<std::unique_ptr<RunningModel<dim>>>& runningModels() const { return runningModels_; }
    /// Stages with which all models join a point.
    std::vector<Stage<dim>> stages(JoinPoint) const;
    /// Runs them at a point that lies within a stage of the step: an evaluation, the making of lists, an observation.
    void run(JoinPoint);
    /// Number of runs of each of those, by name.
    const std::map<std::string, long>& joinedRuns() const { return joinedRuns_; }

    /// Particles whose state is prescribed: rates leave them alone.
    std::span<const int> held() const { return held_; }
    /// Those that one model holds from now on, beside what others hold.
    void hold(const RunningModel<dim>& by, std::vector<int> held);
    /// Whether any rank has buffer particles; all ranks must ask.
    bool holdsAny() const;
    void withholdRate(const std::string& field, double deltaT)
    {
        for (const auto& model : runningModels_) model->withholdRate(*this, field, deltaT);
    }
    /// Whether the state is one between prediction and correction: the values at the start of the step are then in q_0 (Evolving::startName).
    bool predicted() const { return predicted_; }
    void setPredicted(bool predicted) { predicted_ = predicted; }
    /// Largest speed, as last measured [m/s].
    double maxSpeed() const { return maxSpeed_; }
    void setMaxSpeed(double speed) { maxSpeed_ = speed; }

    /// Largest acceleration when last observed [m/s^2].
    double observedAcceleration() const { return observedAcceleration_; }
    double skin() const { return skin_; } ///< skin of the lists [m]
    long rebuilds() const { return rebuilds_; }
    const Leaks& leaks() const { return leakGuard_.leaks(); }
    std::size_t bytes() const;

private:
    const Settings& settings_;
    Geometry geometry_; ///< present geometry: some walls move
    MovingWalls movingWalls_;
    const Catalogue<dim>& catalogue_;
    Coefficients coefficients_;
    Plan<dim> plan_;
    /// Plans by operation that accelerates: an evaluation of it and what it reads; empty until asked for.
    std::map<std::string, std::unique_ptr<Plan<dim>>> alone_;
    FieldStore<dim> store_;
    std::unique_ptr<Halo<dim>> halo_; ///< null where one process is alone
    Images<dim> images_;
    LeakGuard<dim> leakGuard_;
    NeighbourLists<dim> lists_;
    Kernel<dim> kernel_;
    std::vector<std::unique_ptr<RunningModel<dim>>> runningModels_;
    std::map<JoinPoint, std::vector<Stage<dim>>> joined_;
    std::map<std::string, long> joinedRuns_;
    std::vector<std::pair<const RunningModel<dim>*, std::vector<int>>> heldBy_;
    std::vector<int> held_; ///< all of those
    std::size_t owned_ = 0;
    double skin_, travelled_ = 0, maxSpeed_ = 0, observedAcceleration_ = 0;
    long rebuilds_ = 0;
    bool predicted_ = false;

    /// Cost of each particle, from the number of its neighbours and of the images that it is the source of.
    std::vector<float> costs() const;
    void allocateState();
    void load(Cloud, bool restarted);
    void checkApart() const;
    Vector<dim> position(std::size_t i) const;
    void bind();
    /// Evaluates the first group and the stages that join it, for the present positions and images.
    void evaluateFirst();
    /// Makes images and lists for the present positions; `inPassing`: no later ones depend on them.
    void makeLists(bool inPassing = false);
    /// Runs an observation of the present state, with images and lists for it, and restores the state that the observation has changed.
    void look(const std::function<void()>& at);
    void planAlone();
};

}
