#include "solids/CollisionShape.hpp"
#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace sph
{

namespace
{

/// Lengths are in mean sizes and g is 9.81, for which Bullet's tolerances are made.
constexpr double g = 9.81;
/// Substeps: contacts of meshes are found anew where points move along faces, and at half the substep they overlap a third as much.
constexpr double substepOfSpheres = 1.0 / 120, substepOfMeshes = 1.0 / 240;
constexpr int iterations = 40;
/// Surfaces nearer than this are looked at, and touch where they are nearer than `touching`.
constexpr double nearby = 0.02, touching = 0.005;

btVector3 bullet(const Vector<3>& a) { return {a.x, a.y, a.z}; }
Vector<3> plain(const btVector3& a) { return {a.x(), a.y(), a.z()}; }

struct Touch
{
    int id;                     ///< the same from step to step, so that the solver starts from the impulse of the last
    btVector3 onA, onB, normal; ///< from B to A
    double gap;
};

/// A pair across a periodic side, of which one body at least is a mesh. Bullet finds where the first touches a copy of the second, one or more periods off, convex part by
/// convex part; its solver is handed those points where the second itself has them.
class PairAcross
{
    /// Two convex parts, with the points that Bullet keeps of them.
    struct Parts
    {
        const btCollisionShape *a, *b;
        btPersistentManifold found;   ///< of the first body and the copy
        btPersistentManifold* handed; ///< of the bodies themselves
        btCollisionAlgorithm* algorithm = nullptr;
    };
    btCollisionDispatcher& dispatcher_;
    btRigidBody *a_, *b_;
    btVector3 shift_; ///< of the copy
    btCollisionObject copy_;
    std::vector<std::unique_ptr<Parts>> parts_;

    static std::vector<const btCollisionShape*> partsOf(const btRigidBody* body)
    {
        const auto* shape = body->getCollisionShape();
        if (!shape->isCompound()) return {shape};
        const auto* compound = static_cast<const btCompoundShape*>(shape); // placed as they are (makeBulletShape)
        std::vector<const btCollisionShape*> parts;
        for (int k = 0; k < compound->getNumChildShapes(); ++k) parts.push_back(compound->getChildShape(k));
        return parts;
    }
    static btCollisionObjectWrapper wrapped(const btCollisionObject& o, const btCollisionShape* part)
    {
        return {nullptr, part, &o, o.getWorldTransform(), -1, -1};
    }
    void place() { copy_.setWorldTransform(btTransform(b_->getWorldTransform().getBasis(), b_->getWorldTransform().getOrigin() + shift_)); }

    bool areNear(const Parts& p) const
    {
        btVector3 lowA, highA, lowB, highB;
        p.a->getAabb(a_->getWorldTransform(), lowA, highA);
        p.b->getAabb(copy_.getWorldTransform(), lowB, highB);
        const btVector3 slack(nearby, nearby, nearby);
        return TestAabbAgainstAabb2(lowA - slack, highA + slack, lowB, highB);
    }

    void touch(Parts& p, const btDispatcherInfo& info)
    {
        // The solver has left its impulses in what it was handed; points that stay keep them.
        for (int k = 0; k < p.handed->getNumContacts(); ++k)
        {
            const auto& solved = p.handed->getContactPoint(k);
            auto& point = p.found.getContactPoint(k);
            point.m_appliedImpulse = solved.m_appliedImpulse;
            point.m_appliedImpulseLateral1 = solved.m_appliedImpulseLateral1;
            point.m_appliedImpulseLateral2 = solved.m_appliedImpulseLateral2;
        }
        p.handed->clearManifold();
        if (!areNear(p)) return p.found.clearManifold();
        const auto first = wrapped(*a_, p.a), second = wrapped(copy_, p.b);
        if (!p.algorithm) p.algorithm = dispatcher_.findAlgorithm(&first, &second, &p.found, BT_CONTACT_POINT_ALGORITHMS);
        btManifoldResult result(&first, &second);
        result.setPersistentManifold(&p.found);
        p.algorithm->processCollision(&first, &second, info, &result);
        p.found.refreshContactPoints(a_->getWorldTransform(), copy_.getWorldTransform());
        for (int k = 0; k < p.found.getNumContacts(); ++k)
        {
            auto point = p.found.getContactPoint(k);
            point.m_positionWorldOnB -= shift_;
            p.handed->addManifoldPoint(point);
        }
    }

public:
    PairAcross(btCollisionDispatcher& dispatcher, btRigidBody* a, btRigidBody* b, const btVector3& shift)
        : dispatcher_(dispatcher), a_(a), b_(b), shift_(shift)
    {
        copy_.setCollisionShape(b->getCollisionShape());
        copy_.setFriction(b->getFriction());
        copy_.setRestitution(b->getRestitution());
        for (const auto* first : partsOf(a))
            for (const auto* second : partsOf(b))
            {
                const double breaking = std::min(first->getContactBreakingThreshold(gContactBreakingThreshold),
                                                 second->getContactBreakingThreshold(gContactBreakingThreshold));
                parts_.push_back(std::make_unique<Parts>(
                    Parts{first, second, btPersistentManifold(a, &copy_, 0, breaking, BT_LARGE_FLOAT), dispatcher.getNewManifold(a, b)}));
            }
    }
    PairAcross(const PairAcross&) = delete;
    PairAcross& operator=(const PairAcross&) = delete;
    ~PairAcross()
    {
        for (const auto& p : parts_)
        {
            if (p->algorithm)
            {
                p->algorithm->~btCollisionAlgorithm();
                dispatcher_.freeCollisionAlgorithm(p->algorithm);
            }
            dispatcher_.releaseManifold(p->handed);
        }
    }
    const btVector3& shift() const { return shift_; }
    void touch(const btDispatcherInfo& info)
    {
        place();
        for (const auto& p : parts_) touch(*p, info);
    }
};

/// Rigid bodies in a container. Contacts of meshes are Bullet's own, across periodic sides with its help (PairAcross); those of two spheres, also across periodic sides, and
/// those with walls, which Bullet has not or not with impulses kept from step to step, are handed to its solver.
class SettlingWorld : public btDiscreteDynamicsWorld
{
    const SolidContainer& container_;
    std::vector<const CollisionShape*> shapeOf_;
    std::vector<double> size_, reach_;
    std::vector<btRigidBody*> bodies_;
    std::vector<int> spheres_;
    std::vector<std::pair<int, int>> nearSpheres_; ///< as numbers in spheres_
    std::vector<Vector<3>> listedAt_;
    btRigidBody* walls_;
    double friction_, restitution_;
    std::map<std::pair<int, int>, btPersistentManifold*> given_;
    std::map<std::pair<int, int>, std::unique_ptr<PairAcross>> across_;

    void give(btRigidBody* a, btRigidBody* b, std::pair<int, int> key, const std::vector<Touch>& touches)
    {
        const auto at = given_.find(key);
        if (touches.empty())
        {
            if (at == given_.end()) return;
            getDispatcher()->releaseManifold(at->second);
            given_.erase(at);
            return;
        }
        auto* manifold = at != given_.end() ? at->second : given_[key] = getDispatcher()->getNewManifold(a, b);
        std::vector<btManifoldPoint> old;
        for (int k = 0; k < manifold->getNumContacts(); ++k) old.push_back(manifold->getContactPoint(k));
        manifold->clearManifold();
        for (const auto& touch : touches)
        {
            btManifoldPoint point(a->getWorldTransform().invXform(touch.onA), b->getWorldTransform().invXform(touch.onB), touch.normal,
                                  touch.gap);
            point.m_positionWorldOnA = touch.onA;
            point.m_positionWorldOnB = touch.onB;
            point.m_combinedFriction = friction_;
            point.m_combinedRestitution = restitution_;
            point.m_index0 = touch.id;
            for (const auto& before : old)
                if (before.m_index0 == touch.id)
                {
                    point.m_appliedImpulse = before.m_appliedImpulse;
                    point.m_appliedImpulseLateral1 = before.m_appliedImpulseLateral1;
                    point.m_appliedImpulseLateral2 = before.m_appliedImpulseLateral2;
                    point.m_lifeTime = before.m_lifeTime + 1;
                }
            manifold->addManifoldPoint(point);
        }
    }

    /// Wall number `wall` at a point, as the distance to it and its normal into the container.
    std::pair<double, btVector3> wallAt(int wall, const btVector3& x) const
    {
        const auto& c = container_;
        if (wall == 0) return {x.z(), {0, 0, 1}};
        if (c.isCylinder)
        {
            const double r = std::hypot(x.x(), x.y());
            return {c.radius - r, r > 0 ? btVector3(-x.x() / r, -x.y() / r, 0) : btVector3(1, 0, 0)};
        }
        if (wall == 1) return {x.x(), {1, 0, 0}};
        if (wall == 2) return {c.length - x.x(), {-1, 0, 0}};
        if (wall == 3) return {x.y(), {0, 1, 0}};
        return {c.width - x.y(), {0, -1, 0}};
    }

    void touchWall(int i, int wall)
    {
        const auto& shape = *shapeOf_[std::size_t(i)];
        const auto& at = bodies_[std::size_t(i)]->getWorldTransform();
        std::vector<Touch> all, touches;
        const bool isNear = wallAt(wall, at.getOrigin()).first < reach_[std::size_t(i)] + nearby;
        const auto look = [&](int id, const btVector3& x, double radius)
        {
            const auto [distance, normal] = wallAt(wall, x);
            const double gap = distance - radius;
            if (gap < nearby) all.push_back({id, x - radius * normal, x - distance * normal, normal, gap});
        };
        if (isNear && shape.isSphere) look(0, at.getOrigin(), 0.5 * size_[std::size_t(i)]);
        else if (isNear)
            for (int k = 0; k < int(shape.corners.size()); ++k) look(k, at(size_[std::size_t(i)] * shape.corners[std::size_t(k)]), 0);
        // The deepest, then what is farthest from those taken: four points hold a body.
        while (!all.empty() && touches.size() < 4)
        {
            const auto value = [&](const Touch& t)
            {
                if (touches.empty()) return -t.gap;
                double least = std::numeric_limits<double>::infinity();
                for (const auto& taken : touches) least = std::min(least, (t.onA - taken.onA).length2());
                return least;
            };
            const auto best = std::ranges::max_element(all, {}, value);
            touches.push_back(*best);
            all.erase(best);
        }
        give(bodies_[std::size_t(i)], walls_, {i, -1 - wall}, touches);
    }

    void touchSpheres()
    {
        std::vector<Vector<3>> centres;
        std::vector<double> reach;
        double moved = 0;
        for (const int i : spheres_)
        {
            centres.push_back(plain(bodies_[std::size_t(i)]->getWorldTransform().getOrigin()));
            reach.push_back(0.5 * size_[std::size_t(i)]);
            if (!listedAt_.empty()) moved = std::max(moved, mag(shortest(container_, centres.back() - listedAt_[centres.size() - 1])));
        }
        constexpr double skin = 0.2;
        if (listedAt_.empty() || moved > 0.5 * skin)
        {
            auto now = nearPairs(container_, centres, reach, nearby + skin);
            for (const auto& pair : nearSpheres_)
                if (!std::ranges::binary_search(now, pair)) touchPair(pair, centres, reach);
            nearSpheres_ = std::move(now);
            listedAt_ = centres;
        }
        for (const auto& pair : nearSpheres_) touchPair(pair, centres, reach);
    }

    void touchPair(std::pair<int, int> pair, const std::vector<Vector<3>>& centres, const std::vector<double>& reach)
    {
        const auto a = std::size_t(pair.first), b = std::size_t(pair.second);
        const int i = spheres_[a], j = spheres_[b];
        const auto d = shortest(container_, centres[a] - centres[b]);
        const double distance = mag(d), gap = distance - reach[a] - reach[b];
        std::vector<Touch> touches;
        if (gap < nearby && distance > 0)
        {
            const auto n = bullet(d / distance);
            touches = {{0, bullet(centres[a]) - reach[a] * n, bullet(centres[b]) + reach[b] * n, n, gap}};
        }
        give(bodies_[std::size_t(i)], bodies_[std::size_t(j)], {i, j}, touches);
    }

    void touchMeshesAcrossSides()
    {
        std::vector<Vector<3>> centres;
        for (const auto* b : bodies_) centres.push_back(plain(b->getWorldTransform().getOrigin()));
        std::map<std::pair<int, int>, std::unique_ptr<PairAcross>> now;
        for (const auto& pair : nearPairs(container_, centres, reach_, nearby))
        {
            const auto [i, j] = pair;
            if (shapeOf_[std::size_t(i)]->isSphere && shapeOf_[std::size_t(j)]->isSphere) continue;
            const auto apart = centres[std::size_t(j)] - centres[std::size_t(i)];
            const auto shift = bullet(shortest(container_, apart) - apart);
            if (shift.length2() == 0) continue; // Bullet sees it
            auto& known = across_[pair];
            const bool isSame = known && (known->shift() - shift).length2() < sqr(nearby);
            auto& at = now[pair];
            at = isSame ? std::move(known)
                        : std::make_unique<PairAcross>(*static_cast<btCollisionDispatcher*>(getDispatcher()), bodies_[std::size_t(i)],
                                                       bodies_[std::size_t(j)], shift);
            at->touch(getDispatchInfo());
        }
        across_ = std::move(now);
    }

    void performDiscreteCollisionDetection() override
    {
        btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
        for (int i = 0; i < int(bodies_.size()); ++i)
        {
            touchWall(i, 0);
            if (container_.isCylinder) touchWall(i, 1);
            for (int wall = 1; wall < 5 && !container_.isCylinder; ++wall)
                if (!container_.periodic[std::size_t(wall - 1) / 2]) touchWall(i, wall);
        }
        touchSpheres();
        if (spheres_.size() < bodies_.size() && (container_.periodic[0] || container_.periodic[1])) touchMeshesAcrossSides();
    }

public:
    SettlingWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver, btCollisionConfiguration* set,
                  const SolidContainer& container, const SolidsPlan& plan, btRigidBody* walls)
        : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, set),
          container_(container),
          walls_(walls),
          friction_(plan.friction),
          restitution_(plan.restitution)
    {
        setGravity({0, 0, -g});
        // One system of all contacts: islands come and go, and contacts across periodic sides are in no pair of Bullet's.
        getSimulationIslandManager()->setSplitIslands(false);
        auto& info = getSolverInfo();
        info.m_numIterations = iterations;
        info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
        // The whole impulse of the step before: with Bullet's 0.85 of it spheres at rest kept shaking, more than twice as long.
        info.m_warmstartingFactor = 1;
        info.m_splitImpulse = true; // overlaps are moved apart, not pushed apart: no energy comes of them
        info.m_splitImpulsePenetrationThreshold = 0;
    }

    void add(btRigidBody* body, const CollisionShape& shape, double size, double reach)
    {
        constexpr int sphere = 1, mesh = 2;
        shapeOf_.push_back(&shape);
        size_.push_back(size);
        reach_.push_back(reach);
        if (shape.isSphere) spheres_.push_back(int(bodies_.size()));
        bodies_.push_back(body);
        addRigidBody(body, shape.isSphere ? sphere : mesh, shape.isSphere ? mesh : sphere | mesh);
    }

    /// Mean of a body, in m g d
    double kineticEnergy() const
    {
        double energy = 0, mass = 0;
        for (const auto* b : bodies_)
        {
            const double m = 1 / b->getInvMass();
            const auto omega = b->getWorldTransform().getBasis().transpose() * b->getAngularVelocity();
            const auto spin = omega / b->getInvInertiaDiagLocal();
            energy += 0.5 * (m * b->getLinearVelocity().length2() + omega.dot(spin));
            mass += m;
        }
        return energy / (mass * g);
    }

    std::vector<Contact> contacts()
    {
        std::map<std::pair<int, int>, double> gaps;
        for (int k = 0; k < getDispatcher()->getNumManifolds(); ++k)
        {
            const auto* m = getDispatcher()->getManifoldByIndexInternal(k);
            const int i = m->getBody0()->getUserIndex(), j = m->getBody1()->getUserIndex();
            if (i < 0 || j < 0) continue;
            for (int p = 0; p < m->getNumContacts(); ++p)
                if (const double gap = m->getContactPoint(p).getDistance(); gap < touching)
                {
                    auto& least = gaps.try_emplace(std::minmax(i, j), gap).first->second;
                    least = std::min(least, gap);
                }
        }
        std::vector<Contact> all;
        for (const auto& [pair, gap] : gaps) all.push_back({pair.first, pair.second, gap});
        return all;
    }

    /// The container is lifted and set down: all bodies set off upwards together and fall again.
    void tap(double speed)
    {
        for (auto* b : bodies_) b->setLinearVelocity({0, 0, speed});
    }

    void setDamping(double damping)
    {
        for (auto* b : bodies_) b->setDamping(damping, damping);
    }
};

/// Places bodies in layers of cells, each as wide as the largest body is long, from the bottom up.
void placeInCells(const SolidsPlan& plan, const SolidContainer& c, Bed& bed, double unit)
{
    double reach = 0;
    const Body* largest = nullptr;
    for (const auto& b : bed.bodies)
        if (bed.reachOf(b) > reach)
        {
            reach = bed.reachOf(b);
            largest = &b;
        }
    const double cell = 2.02 * reach;
    if (cell > c.narrowest())
        throw CaseError(
            plan.container.where,
            fmt::format("the largest solid ({}) is {:.4g} m long, and the container {:.4g} m wide: it must be {:.4g} m wide at least",
                        largest && !bed.shapeOf(*largest).isSphere() ? bed.shapeOf(*largest).file : "a sphere", 2 * reach * unit,
                        c.narrowest() * unit, cell * unit));
    for (const auto& [isPeriodic, period] : {std::pair{c.periodic[0], c.length}, {c.periodic[1], c.width}})
        if (isPeriodic && period < 4 * reach && !bed.shapeOf(*largest).isSphere())
            throw CaseError(
                plan.container.where,
                fmt::format(
                    "a period of {:.4g} m is shorter than two of the largest solid ({}, {:.4g} m long): it would touch another on both sides at once",
                    period * unit, bed.shapeOf(*largest).file, 2 * reach * unit));
    const double length = c.isCylinder ? 2 * c.radius : c.length, width = c.isCylinder ? 2 * c.radius : c.width;
    const int nx = std::max(1, int(length / cell)), ny = std::max(1, int(width / cell));
    const double dx = length / nx, dy = width / ny;
    std::vector<Vector<3>> cells;
    for (int k = 0; k < nx * ny; ++k)
    {
        const double x = (k % nx + 0.5) * dx, y = (k / nx + 0.5) * dy;
        if (!c.isCylinder) cells.push_back({x, y, 0});
        else if (std::hypot(x - c.radius, y - c.radius) + reach * 1.01 <= c.radius) cells.push_back({x - c.radius, y - c.radius, 0});
    }
    if (cells.empty()) cells.push_back({});
    Noise noise(plan.seed + 1);
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        auto& b = bed.bodies[i];
        auto x = cells[i % cells.size()];
        const double slack = c.isCylinder ? 0.01 * reach : 0.5;
        x.x += noise.between(-slack, slack) * (c.isCylinder ? 1 : dx - 2.01 * reach);
        x.y += noise.between(-slack, slack) * (c.isCylinder ? 1 : dy - 2.01 * reach);
        x.z = (double(i / cells.size()) + 0.5) * cell;
        b.centre = x;
    }
}

/// Steps until the bodies have come to rest, which is looked at once the time `fallen` [sqrt(d/g)] has passed: at first all are slow.
void bringToRest(SettlingWorld& world, const SolidsPlan& plan, Bed& bed, double substep, double fallen, const Progress& progress)
{
    // Shares of the velocities that are lost in a unit of time: while bodies fall, and once almost all are at rest, so that what rolls on stops.
    constexpr double falling = 0.1, stopping = 0.98, slow = 1e-3;
    world.setDamping(falling);
    const double perUnit = std::sqrt(g), before = bed.time;
    constexpr int between = 12, needed = 10;
    const int most = int(plan.longest / perUnit / substep);
    int atRest = 0, step = 0;
    for (double reported = 0; atRest < needed && step < most; ++step)
    {
        world.stepSimulation(substep, 0);
        if (step % between != between - 1) continue;
        bed.kineticEnergy = world.kineticEnergy();
        const double time = (step + 1) * substep * perUnit;
        bed.time = before + time;
        atRest = time > fallen && bed.kineticEnergy < plan.restEnergy ? atRest + 1 : 0;
        if (time > fallen && bed.kineticEnergy < slow) world.setDamping(stopping);
        if (time - reported < 20) continue;
        reported = time;
        progress(fmt::format("t = {:.0f} sqrt(d/g): kinetic energy of a body {:.2g} m g d", bed.time, bed.kineticEnergy));
    }
    if (atRest < needed)
        throw CaseError(plan.timeLimitAt,
                        fmt::format("the bed is not at rest after {:g} sqrt(d/g): the kinetic energy of a body is {:.2g} m g d, and "
                                    "restEnergy {:g}. Give it more time, or more restEnergy",
                                    plan.longest, bed.kineticEnergy, plan.restEnergy));
}

}

void settle(const SolidsPlan& plan, Bed& bed, const Progress& progress)
{
    bed.time = 0;
    bed.taps = 0;
    const double unit = bed.meanSize;
    auto c = plan.container;
    for (double* length : {&c.length, &c.width, &c.radius, &c.height}) *length /= unit;
    for (auto& b : bed.bodies) b.size /= unit;
    placeInCells(plan, c, bed, unit);

    std::vector<CollisionShape> forms;
    for (const auto& shape : bed.shapes)
    {
        forms.push_back(makeCollisionShape(shape));
        if (!shape.isSphere()) bed.notes.push_back(fmt::format("{}: {}{}", shape.file, shape.note, forms.back().description));
    }

    std::vector<BulletShape> shapes;
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    btDefaultCollisionConfiguration set;
    btCollisionDispatcher dispatcher(&set);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btEmptyShape nothing;
    btRigidBody walls(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &nothing));
    walls.setUserIndex(-1);
    SettlingWorld world(&dispatcher, &broadphase, &solver, &set, c, plan, &walls);

    // Bullet multiplies the coefficients of two bodies.
    const double friction = std::sqrt(plan.friction), restitution = std::sqrt(plan.restitution);
    shapes.reserve(bed.bodies.size());
    for (const auto& b : bed.bodies)
    {
        const auto& form = forms[std::size_t(b.shape)];
        const double mass = b.size * b.size * b.size;
        shapes.push_back(makeBulletShape(form, b.size));
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shapes.back().get(), mass * b.size * b.size * form.inertia);
        info.m_friction = friction;
        info.m_restitution = restitution;
        const btMatrix3x3 turned(btQuaternion(b.rotation.v.x, b.rotation.v.y, b.rotation.v.z, b.rotation.w));
        info.m_startWorldTransform = btTransform(turned * form.axes, bullet(b.centre));
        bodies.push_back(std::make_unique<btRigidBody>(info));
        bodies.back()->setActivationState(DISABLE_DEACTIVATION);
        bodies.back()->setUserIndex(int(bodies.size()) - 1);
        world.add(bodies.back().get(), form, b.size, bed.reachOf(b));
    }

    const bool hasMeshes = std::ranges::any_of(bed.shapes, [](const auto& s) { return !s.isSphere(); });
    const double substep = hasMeshes ? substepOfMeshes : substepOfSpheres;
    const auto takeOver = [&]
    {
        for (std::size_t i = 0; i < bodies.size(); ++i)
        {
            auto& b = bed.bodies[i];
            const auto& at = bodies[i]->getWorldTransform();
            const auto turned = at.getBasis() * forms[std::size_t(b.shape)].axes.transpose();
            b.rotation = rotationTo(plain(turned.getColumn(0)), plain(turned.getColumn(1)), plain(turned.getColumn(2)));
            auto x = plain(at.getOrigin());
            if (c.periodic[0]) x.x -= c.length * std::floor(x.x / c.length);
            if (c.periodic[1]) x.y -= c.width * std::floor(x.y / c.width);
            b.centre = unit * x;
        }
    };
    for (auto& b : bed.bodies) b.size *= unit;
    double highest = 0;
    for (const auto& b : bodies) highest = std::max(highest, b->getWorldTransform().getOrigin().z());
    bringToRest(world, plan, bed, substep, 2 * std::sqrt(2 * highest), progress);
    takeOver();
    // A tap lifts the bed by an eighth of a size: v = (g d)^1/2/2.
    constexpr int mostTaps = 500;
    const double speed = 0.5 * std::sqrt(g);
    for (double loosest = 0; plan.porosity; ++bed.taps)
    {
        const double porosity = porosityOfMiddle(plan, bed);
        if (bed.taps == 0) loosest = porosity;
        if (porosity <= *plan.porosity) break;
        if (bed.taps == mostTaps)
            throw CaseError(
                plan.porosityAt,
                fmt::format("the bed has settled to a porosity of {:.4f} and after {} taps to {:.4f}; {:g} is out of its reach. Less "
                            "friction makes it denser, and so does method randomClose",
                            loosest, bed.taps, porosity, *plan.porosity));
        if (bed.taps % 10 == 0) progress(fmt::format("t = {:.0f} sqrt(d/g): porosity {:.4f} after {} taps", bed.time, porosity, bed.taps));
        world.tap(speed);
        bringToRest(world, plan, bed, substep, 2 * speed / g * std::sqrt(g), progress);
        takeOver();
    }
    bed.contacts = world.contacts();
    for (auto& contact : bed.contacts) contact.gap *= unit;
}

}
