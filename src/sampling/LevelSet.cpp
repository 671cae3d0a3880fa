#include "sampling/LevelSet.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace sph
{

std::size_t Lattice::nodes() const
{
    std::size_t n = 1;
    for (const auto c : cells) n *= c + 1;
    return n;
}

Vector<3> Lattice::node(std::size_t k) const
{
    auto x = origin;
    for (std::size_t d = 0; d < dimension(); ++d)
    {
        x += double(k % (cells[d] + 1)) * edges[d];
        k /= cells[d] + 1;
    }
    return x;
}

std::size_t Lattice::beside(std::size_t node, unsigned corner) const
{
    for (std::size_t d = 0, stride = 1; d < dimension(); stride *= cells[d] + 1, ++d)
        if (corner >> d & 1u) node += stride;
    return node;
}

std::vector<std::size_t> Lattice::firstNodes() const
{
    std::vector<std::size_t> first;
    for (std::size_t k = 0; k < nodes(); ++k)
    {
        auto rest = k;
        bool isFirst = true;
        for (const auto c : cells)
        {
            isFirst = isFirst && rest % (c + 1) < c;
            rest /= c + 1;
        }
        if (isFirst) first.push_back(k);
    }
    return first;
}

double Lattice::diagonal() const
{
    Vector<3> sum;
    for (const auto& e : edges) sum += e;
    return mag(sum);
}

namespace
{

constexpr double notCrossed = std::numeric_limits<double>::quiet_NaN();

/// A corner of a simplex.
struct Corner
{
    Vector<3> x;
    double inside = notCrossed; ///< found where it is needed
    std::size_t node = 0;
    unsigned code = 0; ///< of the node in its cell
};

/// A simplex of up to three dimensions; its dimension is one less than it has corners.
struct Simplex
{
    std::array<Corner, 4> corner;
    std::size_t n = 0;
    void add(const Corner& c) { corner[n++] = c; }
};

double sizeOf(const Simplex& s)
{
    const auto edge = [&](std::size_t k) { return s.corner[k].x - s.corner[0].x; };
    switch (s.n)
    {
    case 2:
        return mag(edge(1));
    case 3:
        return mag(cross(edge(1), edge(2))) / 2;
    case 4:
        return std::fabs(dot(cross(edge(1), edge(2)), edge(3))) / 6;
    default:
        return 1;
    }
}

/// The part of a simplex on the positive side of a cut that goes through its edges, `between(p, n)` on each, and the cut itself, as simplices. The cut is a product of two simplices, of the
/// positive and of the negative corners; each monotone path through their pairs is one of the simplices of its staircase triangulation.
template<class Between, class Part, class Face>
void cut(const Simplex& s, const std::array<bool, 4>& isPositive, const Between& between, const Part& part, const Face& face)
{
    std::array<std::size_t, 4> positive{}, negative{};
    std::size_t m = 0, k = 0;
    for (std::size_t c = 0; c < s.n; ++c) (isPositive[c] ? positive[m++] : negative[k++]) = c;
    if (m == 0) return;
    if (k == 0) return part(s);
    std::array<std::array<Corner, 4>, 4> crossing;
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < k; ++j) crossing[i][j] = between(s.corner[positive[i]], s.corner[negative[j]]);
    const auto paths = [&](const auto& self, std::size_t i, std::size_t j, Simplex path, const auto& use) -> void
    {
        path.add(crossing[i][j]);
        if (i + 1 == m && j + 1 == k) return use(path);
        if (i + 1 < m) self(self, i + 1, j, path, use);
        if (j + 1 < k) self(self, i, j + 1, path, use);
    };
    for (std::size_t i = 0; i < m; ++i)
    {
        Simplex beginning;
        for (std::size_t c = 0; c <= i; ++c) beginning.add(s.corner[positive[c]]);
        paths(paths, i, 0, beginning, part);
    }
    paths(paths, 0, 0, Simplex{}, [&](const Simplex& f) { face(f, s.corner[positive[0]].x); });
}

/// The place between two others at which f falls to 0, as a share of the way, by the rule of false position (Illinois).
template<class F> double crossingOf(const F& f, double atStart, double atEnd)
{
    double low = 0, high = 1, share = 0.5;
    const double negligible = 1e-12 * (atStart - atEnd);
    for (int k = 0, last = 0; k < 30; ++k)
    {
        share = (low * atEnd - high * atStart) / (atEnd - atStart);
        const double here = f(share);
        if (!(std::fabs(here) > negligible)) break;
        const int side = here > 0 ? 1 : -1;
        (side > 0 ? low : high) = share;
        (side > 0 ? atStart : atEnd) = here;
        if (side == last) (side > 0 ? atEnd : atStart) *= 0.5;
        last = side;
    }
    return share;
}

}

LevelSet levelSet(const Lattice& lattice, const std::vector<double>& atNodes, double level,
                  const std::function<double(const Vector<3>&)>& f, const std::function<double(const Vector<3>&)>& inside)
{
    const auto n = lattice.dimension();
    const unsigned corners = 1u << n;
    LevelSet result;
    result.least = std::numeric_limits<double>::infinity();
    result.most = -result.least;
    for (const double value : atNodes)
        if (!std::isnan(value))
        {
            result.least = std::min(result.least, value);
            result.most = std::max(result.most, value);
        }

    // Edges of simplices lead from one corner of a cell to one that lies beside it in the positive directions.
    const auto isAbove = [&](std::size_t node) { return atNodes[node] > level; };
    const auto first = lattice.firstNodes();
    std::vector<char> isCut(first.size());
    std::unordered_map<std::size_t, std::size_t> numberOf;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    const auto edgeOf = [&](std::size_t a, unsigned step) { return a * corners + step; };
    for (std::size_t c = 0; c < first.size(); ++c)
    {
        unsigned above = 0;
        bool known = true;
        for (unsigned k = 0; k < corners; ++k)
        {
            const auto node = lattice.beside(first[c], k);
            known = known && !std::isnan(atNodes[node]);
            above += isAbove(node);
        }
        isCut[c] = !known ? -1 : above == 0 ? 0 : above == corners ? 1 : 2;
        if (isCut[c] != 2) continue;
        for (unsigned k = 0; k < corners; ++k)
            for (unsigned step = 1; step < corners; ++step)
                if (const auto a = lattice.beside(first[c], k), b = lattice.beside(a, step); !(k & step) && isAbove(a) != isAbove(b))
                    if (numberOf.try_emplace(edgeOf(a, step), edges.size()).second)
                        edges.push_back({isAbove(a) ? a : b, isAbove(a) ? b : a});
    }
    std::vector<Vector<3>> crossings(edges.size());
#pragma omp parallel for schedule(dynamic, 16)
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
        const auto [a, b] = edges[e];
        const auto from = lattice.node(a), way = lattice.node(b) - from;
        crossings[e] =
            from + crossingOf([&](double share) { return f(from + share * way) - level; }, atNodes[a] - level, atNodes[b] - level) * way;
    }

    std::vector<double> insideOf(atNodes.size(), notCrossed);
    std::vector<char> isAsked(atNodes.size());
    for (std::size_t c = 0; c < first.size(); ++c)
        if (isCut[c] > 0)
            for (unsigned k = 0; k < corners; ++k) isAsked[lattice.beside(first[c], k)] = 1;
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t k = 0; k < atNodes.size(); ++k)
        if (isAsked[k]) insideOf[k] = inside(lattice.node(k));

    double whole = 1; // the size of a cell
    {
        Simplex corner;
        corner.add({});
        for (const auto& e : lattice.edges) corner.add({.x = e});
        whole = sizeOf(corner) * (n == 3 ? 6 : n == 2 ? 2 : 1);
    }
    const auto count = [&](double size, const Vector<3>& centre)
    {
        result.enclosed += size;
        result.moment += size * centre;
    };
    const auto countPart = [&](const Simplex& s)
    {
        Vector<3> centre;
        for (std::size_t k = 0; k < s.n; ++k) centre += s.corner[k].x / double(s.n);
        count(sizeOf(s), centre);
    };
    // What is left of a simplex within inside(x) > 0.
    const auto within = [&](Simplex s, const auto& use)
    {
        std::array<bool, 4> isInside{};
        for (std::size_t k = 0; k < s.n; ++k)
        {
            auto& corner = s.corner[k];
            if (std::isnan(corner.inside)) corner.inside = inside(corner.x);
            isInside[k] = corner.inside >= 0;
        }
        const auto between = [](const Corner& p, const Corner& q)
        { return Corner{.x = p.x + p.inside / (p.inside - q.inside) * (q.x - p.x), .inside = 0}; };
        cut(s, isInside, between, use, [](const Simplex&, const Vector<3>&) {});
    };
    std::vector<std::vector<unsigned>> paths; // corners of the simplices of a cell
    std::vector<unsigned> order(n);
    std::iota(order.begin(), order.end(), 0u);
    do {
        auto& path = paths.emplace_back(1, 0u);
        for (const auto k : order) path.push_back(path.back() | 1u << k);
    } while (std::next_permutation(order.begin(), order.end()));

    for (std::size_t c = 0; c < first.size(); ++c)
    {
        if (isCut[c] <= 0) continue;
        if (isCut[c] == 1 && insideOf[first[c]] > lattice.diagonal())
        {
            count(whole, 0.5 * (lattice.node(first[c]) + lattice.node(lattice.beside(first[c], corners - 1))));
            continue;
        }
        for (const auto& path : paths)
        {
            Simplex s;
            std::array<bool, 4> above{};
            for (const auto code : path)
            {
                const auto node = lattice.beside(first[c], code);
                above[s.n] = isAbove(node);
                s.add({lattice.node(node), insideOf[node], node, code});
            }
            const auto between = [&](const Corner& p, const Corner& q)
            {
                const auto& a = p.code < q.code ? p : q; // its code is part of the other's
                return Corner{.x = crossings[numberOf.at(edgeOf(a.node, p.code ^ q.code))]};
            };
            cut(
                s, above, between, [&](const Simplex& part) { within(part, countPart); },
                [&](const Simplex& face, const Vector<3>& high)
                {
                    within(face,
                           [&](const Simplex& piece)
                           {
                               const double size = sizeOf(piece);
                               result.size += size;
                               for (std::size_t k = 0; k < piece.n; ++k)
                                   result.places.push_back({piece.corner[k].x, high - piece.corner[k].x, size / double(piece.n)});
                           });
                });
        }
    }
    return result;
}

}
