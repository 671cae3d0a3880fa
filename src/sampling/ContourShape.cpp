#include "sampling/ContourShape.hpp"
#include "geometry/components.hpp"
#include "geometry/wallNames.hpp"
#include "sampling/FluidPart.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/SphereFit.hpp"
#include "sampling/nearestOfWall.hpp"
#include "sampling/readBox.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Text contourValue{"value", byScene("the volume fraction of `phase`"), "expression of fields, position, time and constants"};
const Word contourPhase{"phase", byScene("the first of constant/phaseProperties; with `value` all"),
                        "phase whose surface it is; with `value` its particles alone carry the value"};
const Scalar contourLevel{"level", Unit{units::none, "of the value"}, byScene("1/2 of a volume fraction; needed with `value`"),
                          "that the value has on the contour"};
const SubDictionary contourRegion{"region", byScene("all of the domain"), "the part of the contour within this box"};
const SubDictionary cut{"cut", byScene("the whole surface"), "plane in which the contour lies, in 2-D a line"};
const VectorParameter cutPoint{"point", units::m, required, "in the plane"};
const Direction cutNormal{"normal", required, "of the plane"};
const Word contourWall{"wall", notGiven, "wall with which the angle is measured"};
const Scalar contourAbove{"above", Unit{units::none, "spacings"}, 2.5, nonNegative, "of `wall`: what lies nearer to it is not fitted"};
const Switch endsAtWalls{"endsAtWalls", true, "whether the contour ends at walls, or goes on into them as far as the kernel's mean does"};
const Direction contourDirection{"direction", Vector<3>{1, 0, 0}, "along which front and rear are found"};
const VectorParameter contourCentre{"centre", units::m, byScene("the best one"),
                                    "of the circle or sphere; the radius is then the mean distance from it"};
}

namespace
{

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

template<auto part, auto component> double componentOf(const ContourFigures& f) { return f.*part.*component; }

}

ContourFigures::ContourFigures()
    : rear(undefined),
      front(undefined),
      centroid{undefined, undefined, undefined},
      radius(undefined),
      centre(centroid),
      misfit(undefined),
      angle(undefined),
      semiAxes(centroid),
      least(undefined),
      most(undefined)
{}

const std::vector<ContourFigure>& contourFigures()
{
    using F = ContourFigures;
    using V = Vector<3>;
    static const std::vector<ContourFigure> all{
        {{"area", "m^2", "of the contour; in 2-D and in a cut its length [m]"}, [](const F& f) { return f.area; }},
        {{"volume", "m^3", "where the value is above the level; in 2-D and in a cut its area [m^2]"}, [](const F& f) { return f.volume; }},
        {{"rear", "m", "least coordinate of the contour along `direction`"}, [](const F& f) { return f.rear; }},
        {{"front", "m", "largest coordinate of the contour along `direction`"}, [](const F& f) { return f.front; }},
        {{"centroid_x", "m", "of the volume"}, componentOf<&F::centroid, &V::x>},
        {{"centroid_y", "m", "of the volume"}, componentOf<&F::centroid, &V::y>},
        {{"centroid_z", "m", "of the volume"}, componentOf<&F::centroid, &V::z>},
        {{"radius", "m", "of the circle or sphere fitted to the contour; with `centre` the mean distance from it"},
         [](const F& f) { return f.radius; }},
        {{"centre_x", "m", "of that circle or sphere"}, componentOf<&F::centre, &V::x>},
        {{"centre_y", "m", "of that circle or sphere"}, componentOf<&F::centre, &V::y>},
        {{"centre_z", "m", "of that circle or sphere"}, componentOf<&F::centre, &V::z>},
        {{"misfit", "m", "root mean square distance of the contour from it"}, [](const F& f) { return f.misfit; }},
        {{"angle", "degrees", "of it with `wall`, through the side where the value is above the level"},
         [](const F& f) { return f.angle; }},
        {{"semiAxis1", "m", "longest of the ellipse or ellipsoid fitted to the contour"}, componentOf<&F::semiAxes, &V::x>},
        {{"semiAxis2", "m", "next of it"}, componentOf<&F::semiAxes, &V::y>},
        {{"semiAxis3", "m", "shortest of the ellipsoid; 0 of an ellipse"}, componentOf<&F::semiAxes, &V::z>},
    };
    return all;
}

EntryList ContourShape::entries()
{
    return {entry::contourValue,
            entry::contourPhase,
            entry::contourLevel,
            {entry::contourRegion, {entry::min, entry::max}},
            {entry::cut, {entry::cutPoint, entry::cutNormal}},
            entry::contourWall,
            entry::contourAbove,
            entry::endsAtWalls,
            entry::contourDirection,
            entry::contourCentre};
}

ContourShape::ContourShape(const Dictionary& d, const FunctionContext& context, const std::vector<std::string>& numbers,
                           const std::vector<std::string>& later)
    : level_(0.5),
      above_(entry::contourAbove(d)),
      endsAtWalls_(entry::endsAtWalls(d)),
      direction_(entry::contourDirection(d)),
      centre_(entry::contourCentre.ifGiven(d))
{
    if (entry::contourValue.given(d))
    {
        value_.emplace(entry::contourValue, d, entry::contourValue.needed(d), numbers, later);
        level_ = entry::contourLevel.needed(d);
    }
    else level_ = entry::contourLevel(d, level_);
    const auto numberOf = [&](const std::string& word, const std::vector<std::string>& words)
    { return std::size_t(std::max<long>(0, std::ranges::find(words, word) - words.begin())); };
    if (entry::contourPhase.given(d)) phase_ = numberOf(entry::contourPhase.among(d, context.phases), context.phases);
    else if (!value_) phase_ = 0;
    if (entry::contourRegion.given(d)) region_ = readBox(entry::contourRegion(d), context.geometry);
    if (entry::contourWall.given(d))
    {
        const auto walls = wallNames(context.geometry);
        wall_ = numberOf(entry::contourWall.among(d, walls), walls);
    }
    if (entry::cut.given(d))
    {
        const auto plane = entry::cut(d);
        cut_ = Cut{entry::cutPoint(plane), entry::cutNormal(plane)};
        if (wall_) entry::contourWall.error(d, "goes without `cut` alone: the angle is that of the whole surface with the wall");
        const auto& g = context.geometry;
        const Box within = region_.value_or(Box{g.low, g.high});
        double low = Box::infinity, high = -Box::infinity;
        for (unsigned corner = 0; corner < 1u << g.dimension; ++corner)
        {
            auto x = cut_->point;
            for (int k = 0; k < g.dimension; ++k) x.*component(k) = (corner >> k & 1u ? within.high : within.low).*component(k);
            low = std::min(low, dot(x - cut_->point, cut_->normal));
            high = std::max(high, dot(x - cut_->point, cut_->normal));
        }
        if (low > 0 || high < 0)
            entry::cut.error(d, fmt::format("the plane through {} does not meet the box from {} to {}", cell(cut_->point), cell(within.low),
                                            cell(within.high)));
    }
    if (centre_ && wall_)
        entry::contourCentre.error(d, "goes without `wall` alone: the angle is that of the circle or sphere that fits best");
}

/// The value at places of a view.
class ContourShape::Sampled
{
    const ParticleView& view_;
    const ContourShape& own_;
    Interpolator interpolator_;
    FluidPart fluidPart_;
    std::vector<Interpolator::Range> ranges_;
    bool isAlone_; ///< of a liquid without anything around it
    Box box_;

    /// sum_j V_j W_j over the part of the kernel's sphere that is fluid.
    double filled(const Vector<3>& x, double coverage) const
    {
        const auto& g = *view_.geometry;
        bool isWhole = g.walls.empty() || g.distance(x) > view_.support;
        for (int k = 0; k < g.dimension; ++k)
            if (const auto c = component(k); !g.periodic[std::size_t(k)])
                isWhole = isWhole && x.*c - g.low.*c > view_.support && g.high.*c - x.*c > view_.support;
        const double part = isWhole ? 1 : fluidPart_(x, g);
        return part > 0 ? coverage / part : 0;
    }
    Vector<3> wrapped(Vector<3> x) const
    {
        const auto& g = *view_.geometry;
        for (int k = 0; k < g.dimension; ++k)
            if (const auto c = component(k); g.periodic[std::size_t(k)]) x.*c -= g.length(k) * std::floor((x.*c - g.low.*c) / g.length(k));
        return x;
    }
    PointWeights weights(const Vector<3>& x) const
    {
        const Interpolator::Admits ofPhase = [this](std::size_t i, const Vector<3>&) { return phaseOf(view_, i) == *own_.phase_; };
        return interpolator_.weights(x, Interpolation::linear, own_.phase_ ? ofPhase : Interpolator::Admits{});
    }

public:
    std::vector<double> values;

    Sampled(const ParticleView& view, const ContourShape& own, const NamedNumbers& numbers)
        : view_(view),
          own_(own),
          interpolator_(view, own.value_ ? Mirrored::no : Mirrored::atSymmetryPlanes),
          fluidPart_(view, own.value_ ? Mirrored::no : Mirrored::atSymmetryPlanes),
          isAlone_(!own.value_ && view.phases.size() < 2)
    {
        if (own.value_) values = own.value_->atParticles(view, numbers);
        else
            for (std::size_t i = 0; i < view.n; ++i) values.push_back(phaseOf(view, i) == *own.phase_);
        ranges_ = interpolator_.rangesOfCells(values.data());
        box_ = own.box(view, values);
    }
    const Box& box() const { return box_; }

    double operator()(const Vector<3>& at) const
    {
        const auto x = wrapped(at);
        if (own_.value_) return weights(x)(values.data());
        const auto sums = interpolator_.sums(x, values.data());
        if (isAlone_) return filled(x, sums.coverage);
        return sums.coverage > 0 ? sums.ofValues / sums.coverage : undefined;
    }
    /// The same; where all particles around are on one side of the level, some value of that side.
    double atNode(const Vector<3>& x) const
    {
        const auto [low, high] = interpolator_.range(wrapped(x), ranges_);
        if (low > high) return isAlone_ ? 0 : undefined;
        if (!isAlone_ && low > own_.level_) return low;
        if (!isAlone_ && high <= own_.level_) return high;
        return (*this)(x);
    }
    /// Distance to walls, to the box in a cut, and to where the particles end [m].
    double inside(const Vector<3>& at) const
    {
        const auto& g = *view_.geometry;
        const auto x = wrapped(at);
        double distance = g.patches.empty() || !own_.endsAtWalls_ ? view_.support : std::min(view_.support, g.distance(x));
        if (own_.cut_)
            for (int k = 0; k < g.dimension; ++k)
                distance = std::min({distance, at.*component(k) - box_.low.*component(k), box_.high.*component(k) - at.*component(k)});
        if (own_.value_)
            if (const double coverage = weights(x).coverage; coverage < 0.5)
                distance = std::min(distance, view_.support * (filled(x, coverage) - 0.5));
        return distance;
    }
};

/// The region; where none is given, the domain, begun in periodic directions half a period before the middle of what is above the level.
Box ContourShape::box(const ParticleView& view, const std::vector<double>& values) const
{
    const auto& g = *view.geometry;
    auto box = region_.value_or(Box{g.low, g.high});
    if (g.dimension == 2) box.low.z = box.high.z = 0;
    if (region_ || cut_) return box;
    for (int k = 0; k < g.dimension; ++k)
        if (const auto c = component(k); g.periodic[std::size_t(k)])
        {
            double sine = 0, cosine = 0;
            const double turn = 2 * std::numbers::pi / g.length(k);
            for (std::size_t i = 0; i < view.n; ++i)
                if (values[i] > level_)
                {
                    const double angle = turn * (position(view, i).*c - g.low.*c);
                    sine += view.volume[i] * std::sin(angle);
                    cosine += view.volume[i] * std::cos(angle);
                }
            const double middle = g.low.*c + std::atan2(sine, cosine) / turn;
            if (!std::isfinite(middle)) continue;
            box.low.*c = middle - 0.5 * g.length(k);
            box.high.*c = middle + 0.5 * g.length(k);
        }
    return box;
}

Lattice ContourShape::lattice(const ParticleView& view, const Box& box) const
{
    const int dimension = view.dimension;
    Lattice lattice{box.low, {}, {}};
    const auto add = [&](const Vector<3>& direction, double length)
    {
        const auto n = std::max(1.0, std::ceil(length / view.spacing - 1e-9));
        lattice.edges.push_back(length / n * direction);
        lattice.cells.push_back(std::size_t(n));
    };
    if (!cut_)
    {
        for (int k = 0; k < dimension; ++k)
        {
            Vector<3> direction;
            direction.*component(k) = 1;
            add(direction, box.high.*component(k) - box.low.*component(k));
        }
        return lattice;
    }
    // Directions in the plane, and how far the box reaches along them.
    const auto& normal = cut_->normal;
    std::vector<Vector<3>> along;
    if (dimension == 2) along = {{-normal.y, normal.x, 0}};
    else
    {
        int least = 0;
        for (const int k : {1, 2})
            if (std::fabs(normal.*component(k)) < std::fabs(normal.*component(least))) least = k;
        Vector<3> axis;
        axis.*component(least) = 1;
        const auto first = unitVector(axis - dot(axis, normal) * normal);
        along = {first, cross(normal, first)};
    }
    lattice.origin = cut_->point;
    for (const auto& direction : along)
    {
        double low = Box::infinity, high = -Box::infinity;
        for (unsigned corner = 0; corner < 1u << dimension; ++corner)
        {
            Vector<3> x;
            for (int k = 0; k < dimension; ++k) x.*component(k) = (corner >> k & 1u ? box.high : box.low).*component(k);
            low = std::min(low, dot(x - cut_->point, direction));
            high = std::max(high, dot(x - cut_->point, direction));
        }
        lattice.origin += low * direction;
        add(direction, high - low);
    }
    return lattice;
}

double ContourShape::angleWith(const ParticleView& view, const SphereFit& sphere, bool isAboveInside) const
{
    const auto foot = nearestOfWall(*view.geometry, *wall_, sphere.centre).foot;
    if (view.dimension == 3 && foot.k1 != foot.k2) return undefined; // no part of a sphere
    const double h = foot.distance, R = sphere.radius;
    const double inside = std::acos(std::clamp(-h / R - foot.k1 * (sqr(R) - sqr(h)) / (2 * R), -1.0, 1.0)) * 180 / std::numbers::pi;
    return isAboveInside ? inside : 180 - inside;
}

void ContourShape::fit(const ParticleView& view, const LevelSet& set, const Lattice& lattice, ContourFigures& figures) const
{
    const auto n = lattice.dimension();
    // In a cut coordinates are those of its plane.
    const auto local = [&](const Vector<3>& x)
    {
        if (!cut_) return x;
        const auto way = x - cut_->point;
        return Vector<3>{dot(way, unitVector(lattice.edges[0])), n == 2 ? dot(way, unitVector(lattice.edges[1])) : 0, 0};
    };
    const auto global = [&](const Vector<3>& u)
    {
        if (!cut_) return u;
        auto x = cut_->point + u.x * unitVector(lattice.edges[0]);
        if (n == 2) x += u.y * unitVector(lattice.edges[1]);
        return x;
    };
    std::vector<Vector<3>> places;
    std::vector<double> weights;
    for (const auto& place : set.places)
        if (!wall_ || nearestOfWall(*view.geometry, *wall_, place.x).foot.distance > above_ * view.spacing)
        {
            places.push_back(local(place.x));
            weights.push_back(place.weight);
        }
    figures.places = places.size();
    if (places.empty()) return;
    if (n > 1)
    {
        const auto ellipsoid = fitEllipsoid(places, int(n), weights);
        if (ellipsoid.semiAxes.x > 0) figures.semiAxes = ellipsoid.semiAxes;
    }

    SphereFit sphere;
    double total = 0;
    for (const double w : weights) total += w;
    if (centre_)
    {
        sphere.centre = local(*centre_);
        for (std::size_t k = 0; k < places.size(); ++k) sphere.radius += weights[k] / total * mag(places[k] - sphere.centre);
    }
    else if (n > 1) sphere = fitSphere(places, int(n), weights);
    if (!(sphere.radius > 0)) return;
    figures.radius = sphere.radius;
    figures.centre = global(sphere.centre);
    double square = 0, up = 0;
    for (std::size_t k = 0; k < places.size(); ++k) square += weights[k] / total * sqr(mag(places[k] - sphere.centre) - sphere.radius);
    figures.misfit = std::sqrt(square);
    for (const auto& place : set.places) up += place.weight * dot(place.up, figures.centre - place.x);
    if (wall_) figures.angle = angleWith(view, sphere, up > 0);
}

ContourFigures ContourShape::operator()(const ParticleView& view, const NamedNumbers& numbers) const
{
    ContourFigures figures;
    const Sampled sampled(view, *this, numbers);
    const auto nodes = lattice(view, sampled.box());
    std::vector<double> atNodes(nodes.nodes());
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t k = 0; k < atNodes.size(); ++k) atNodes[k] = sampled.atNode(nodes.node(k));
    const auto set = levelSet(
        nodes, atNodes, level_, [&](const Vector<3>& x) { return sampled(x); }, [&](const Vector<3>& x) { return sampled.inside(x); });

    figures.least = set.least;
    figures.most = set.most;
    figures.area = set.size;
    figures.volume = set.enclosed;
    if (set.enclosed > 0) figures.centroid = set.moment / set.enclosed;
    if (set.places.empty()) return figures;
    figures.rear = Box::infinity;
    figures.front = -Box::infinity;
    for (const auto& place : set.places)
    {
        figures.rear = std::min(figures.rear, dot(place.x, direction_));
        figures.front = std::max(figures.front, dot(place.x, direction_));
    }
    fit(view, set, nodes, figures);
    return figures;
}

}
