#include "meshes/readers/GltfFile.hpp"
#include "meshes/readers/RegionNames.hpp"
#include "meshes/readers/singlePrecision.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sph
{

namespace
{

/// x -> e_x x + e_y y + e_z z + shift
struct Affine
{
    Vector<3> e_x{1, 0, 0}, e_y{0, 1, 0}, e_z{0, 0, 1}, shift;

    Vector<3> turned(const Vector<3>& x) const { return x.x * e_x + x.y * e_y + x.z * e_z; }
    Vector<3> operator()(const Vector<3>& x) const { return turned(x) + shift; }
    Affine operator*(const Affine& inner) const { return {turned(inner.e_x), turned(inner.e_y), turned(inner.e_z), (*this)(inner.shift)}; }
    bool mirrors() const { return dot(cross(e_x, e_y), e_z) < 0; }
    double largestStretch() const { return std::max({mag(e_x), mag(e_y), mag(e_z)}); }
};

Affine placeOf(const GltfNode& node)
{
    if (node.find("matrix"))
    {
        const auto m = node.numbers<16>("matrix", {});
        return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    }
    const auto t = node.numbers<3>("translation", {0, 0, 0}), s = node.numbers<3>("scale", {1, 1, 1});
    const auto [x, y, z, w] = node.numbers<4>("rotation", {0, 0, 0, 1});
    const double norm = x * x + y * y + z * z + w * w;
    if (!(norm > 0)) throw UnusableMesh(fmt::format("{}.rotation: the quaternion is zero", node.path()));
    const double k = 2 / norm;
    return {s[0] * Vector<3>{1 - k * (y * y + z * z), k * (x * y + w * z), k * (x * z - w * y)},
            s[1] * Vector<3>{k * (x * y - w * z), 1 - k * (x * x + z * z), k * (y * z + w * x)},
            s[2] * Vector<3>{k * (x * z + w * y), k * (y * z - w * x), 1 - k * (x * x + y * y)},
            {t[0], t[1], t[2]}};
}

class Gltf
{
    GltfFile file_;
    RegionNames regions_;
    NumberedMesh mesh_;
    std::size_t linesAndPoints_ = 0;
    Notes& notes_;

    /// Corners of the triangles one after another, of a list (4), strip (5) or fan (6).
    std::vector<int> corners(const GltfNode& primitive, std::size_t mode, std::size_t points)
    {
        std::vector<int> listed;
        if (const auto indices = primitive.find("indices"))
            for (const double i : file_.numbers(indices->whole(), "SCALAR", 1).values)
            {
                if (!(i >= 0 && i < double(points) && i == std::floor(i)))
                    throw UnusableMesh(fmt::format("{}: vertex {}, and there are {}", indices->path(), i, points));
                listed.push_back(int(i));
            }
        else
            for (std::size_t i = 0; i < points; ++i) listed.push_back(int(i));
        if (mode == 4)
        {
            if (listed.size() % 3 != 0)
                throw UnusableMesh(fmt::format("{}: {} corners are no whole triangles", primitive.path(), listed.size()));
            return listed;
        }
        std::vector<int> all;
        for (std::size_t k = 2; k < listed.size(); ++k)
        {
            const bool odd = mode == 5 && k % 2 == 1;
            const int a = mode == 6 ? listed[0] : listed[k - 2], b = listed[k - 1], c = listed[k];
            all.insert(all.end(), {a, odd ? c : b, odd ? b : c});
        }
        return all;
    }

    void addPrimitive(const GltfNode& primitive, const std::string& meshName, const Affine& toScene)
    {
        primitive.checkExtensions();
        const auto mode = primitive.whole("mode", 4);
        if (mode > 6) throw UnusableMesh(fmt::format("{}.mode: {} is none", primitive.path(), mode));
        if (mode < 4)
        {
            ++linesAndPoints_;
            return;
        }
        const auto position = primitive.at("attributes").at("POSITION").whole();
        const auto [x, single] = file_.numbers(position, "VEC3", 3);
        const auto all = corners(primitive, mode, x.size() / 3);
        if (mesh_.points.size() + x.size() / 3 > std::size_t(std::numeric_limits<int>::max()))
            throw UnusableMesh(fmt::format("{}: more vertices than 2^31", primitive.path()));

        std::string name;
        if (const auto material = primitive.find("material")) name = file_.root().at("materials")[material->whole()].text("name");
        const int region = regions_.index(name.empty() ? meshName : name), first = int(mesh_.points.size());
        double largest = 0;
        for (std::size_t i = 0; i < x.size(); i += 3)
        {
            const Vector<3> p = toScene({x[i], x[i + 1], x[i + 2]});
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
                throw UnusableMesh(fmt::format("{}: its node puts it nowhere", primitive.path()));
            mesh_.points.push_back(p);
            largest = std::max({largest, std::abs(x[i]), std::abs(x[i + 1]), std::abs(x[i + 2])});
        }
        if (single) mesh_.rounding = std::max(mesh_.rounding, toScene.largestStretch() * roundingOf(largest));
        for (std::size_t k = 0; k < all.size(); k += 3)
        {
            const int a = first + all[k], b = first + all[k + 1], c = first + all[k + 2];
            mesh_.number.push_back(int(mesh_.triangles.size()));
            if (toScene.mirrors()) mesh_.triangles.push_back({a, c, b});
            else mesh_.triangles.push_back({a, b, c});
            mesh_.region.push_back(region);
        }
    }

    void addMesh(std::size_t index, const Affine& toScene)
    {
        const auto mesh = file_.root().at("meshes")[index];
        if (const auto weights = mesh.find("weights")) checkWeights(*weights);
        const auto primitives = mesh.at("primitives");
        auto name = mesh.text("name");
        if (name.empty()) name = fmt::format("meshes_{}", index);
        for (std::size_t i = 0; i < primitives.size(); ++i)
            addPrimitive(primitives[i], primitives.size() > 1 ? fmt::format("{}-{}", name, i) : name, toScene);
    }

    static void checkWeights(const GltfNode& weights)
    {
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weights[i].number() != 0)
                throw UnusableMesh(fmt::format("{}: morph targets are not read: apply them, and export it again", weights.path()));
    }

    std::vector<std::size_t> rootNodes() const
    {
        const auto listed = [](const GltfNode& list)
        {
            std::vector<std::size_t> all;
            for (std::size_t i = 0; i < list.size(); ++i) all.push_back(list[i].whole());
            return all;
        };
        if (file_.root().find("scenes"))
        {
            const auto nodes = file_.root().at("scenes")[file_.root().whole("scene", 0)].find("nodes");
            return nodes ? listed(*nodes) : std::vector<std::size_t>{};
        }
        const auto nodes = file_.root().at("nodes");
        std::vector<char> isChild(nodes.size(), 0);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (const auto children = nodes[i].find("children"))
                for (const auto child : listed(*children))
                    if (child < isChild.size()) isChild[child] = 1;
        std::vector<std::size_t> roots;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!isChild[i]) roots.push_back(i);
        return roots;
    }

    void addNodes()
    {
        struct Visit
        {
            std::size_t node;
            Affine parent;
        };
        std::vector<Visit> open;
        const auto roots = rootNodes();
        for (auto r = roots.rbegin(); r != roots.rend(); ++r) open.push_back({*r, {}});
        const auto nodes = file_.root().at("nodes");
        std::vector<char> visited(nodes.size(), 0);
        while (!open.empty())
        {
            const auto [index, parent] = open.back();
            open.pop_back();
            const auto node = nodes[index];
            if (std::exchange(visited[index], 1)) throw UnusableMesh(fmt::format("{}: it has two parents", node.path()));
            node.checkExtensions();
            const auto toScene = parent * placeOf(node);
            if (const auto weights = node.find("weights")) checkWeights(*weights);
            if (const auto mesh = node.find("mesh"))
            {
                if (node.find("skin"))
                    throw UnusableMesh(fmt::format("{}.skin: skins are not read: apply its pose, and export it again", node.path()));
                addMesh(mesh->whole(), toScene);
            }
            if (const auto children = node.find("children"))
                for (std::size_t i = children->size(); i-- > 0;) open.push_back({(*children)[i].whole(), toScene});
        }
    }

public:
    Gltf(const std::filesystem::path& file, std::string_view bytes, Notes& notes)
        : file_(file, bytes, notes), regions_(notes), notes_(notes)
    {}

    NumberedMesh read()
    {
        addNodes();
        if (linesAndPoints_ > 0) notes_.push_back(counted(linesAndPoints_, "primitive") + " of lines or points left out");
        mesh_.regions = regions_.words();
        return std::move(mesh_);
    }
};

}

NumberedMesh readGltf(const std::filesystem::path& file, std::string_view bytes, Notes& notes) { return Gltf(file, bytes, notes).read(); }

}
