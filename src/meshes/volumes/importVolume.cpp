#include "meshes/volumes/importVolume.hpp"
#include "meshes/volumes/VoxelContour.hpp"
#include "meshes/volumes/VoxelImage.hpp"
#include <algorithm>
#include <cmath>
#include <dlfcn.h>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace sph
{

namespace
{

ContourVoxels* contourVoxels()
{
    void* const library = dlopen("libsphVoxels.so", RTLD_NOW);
    if (!library) throw UnusableMesh(std::string("volumes need the library libsphVoxels.so: ") + dlerror());
    auto* const contour = reinterpret_cast<ContourVoxels*>(dlsym(library, "contourVoxels"));
    if (!contour) throw UnusableMesh(std::string("libsphVoxels.so: ") + dlerror());
    return contour;
}

/// Gauss's kernel along one direction after the other, cut off at three deviations, normalised where the volume ends.
void smooth(VoxelImage& image, double deviation)
{
    const int reach = int(std::ceil(3 * deviation));
    std::vector<double> weight;
    for (int k = 0; k <= reach; ++k) weight.push_back(std::exp(-0.5 * sqr(k / deviation)));
    std::size_t stride = 1;
    for (const int n : image.cells)
    {
        std::vector<double> line(static_cast<std::size_t>(n));
        for (std::size_t first = 0; first < image.size(); ++first)
        {
            if (first / stride % std::size_t(n) != 0) continue; // no first voxel of a line
            for (int i = 0; i < n; ++i) line[std::size_t(i)] = image.values[first + std::size_t(i) * stride];
            for (int i = 0; i < n; ++i)
            {
                double sum = 0, weights = 0;
                for (int k = std::max(-reach, -i); k <= std::min(reach, n - 1 - i); ++k)
                {
                    const double w = weight[std::size_t(std::abs(k))];
                    sum += w * line[std::size_t(i + k)];
                    weights += w;
                }
                image.values[first + std::size_t(i) * stride] = float(sum / weights);
            }
        }
        stride *= std::size_t(n);
    }
}

std::size_t solidVoxels(const VoxelImage& image, double iso)
{
    return std::size_t(std::ranges::count_if(image.values, [&](float v) { return v > iso; }));
}

void checkShare(const VoxelImage& image, std::size_t solid, const std::string& what)
{
    if (solid > 0 && solid < image.size()) return;
    const auto [low, high] = std::ranges::minmax(image.values);
    throw UnusableMesh(
        fmt::format("{} of its voxels are solid by {}: their values go from {:g} to {:g}", solid == 0 ? "none" : "all", what, low, high));
}

/// Turns the values into ones that are larger in the solid, counts its voxels, and returns the value on its surface; none of a smoothed indicator.
std::optional<double> segment(VoxelImage& image, const TriSurface::Volume& v, std::size_t& solid)
{
    double surface = 0.5;
    if (v.label)
    {
        for (auto& value : image.values) value = value == float(*v.label) ? 1 : 0;
        solid = solidVoxels(image, surface);
        checkShare(image, solid, fmt::format("label {:g}", *v.label));
    }
    else
    {
        const auto turn = [&]
        {
            for (auto& value : image.values) value = -value;
        };
        if (v.solidBelow) turn();
        // A surface through the centres of voxels would have points that coincide: whole numbers are parted half-way.
        surface = (v.solidBelow ? -*v.threshold : *v.threshold) - (image.isWhole ? 0.5 : 0);
        solid = solidVoxels(image, surface);
        if (v.solidBelow && (solid == 0 || solid == image.size())) turn(); // as the user knows them
        checkShare(image, solid, fmt::format("threshold {:g}", *v.threshold));
        if (v.smoothing > 0)
            for (auto& value : image.values) value = value > surface ? 1 : 0;
    }
    if (v.smoothing == 0) return surface;
    smooth(image, v.smoothing);
    return {};
}

/// One layer of nodes more on each side, as far below the iso value as the outermost voxel is above it, so that the surface lies half-way between them: in the outer face.
std::vector<float> padded(const VoxelImage& image, double iso)
{
    const auto& n = image.cells;
    std::vector<float> values;
    const float below = std::nextafter(float(iso), -std::numeric_limits<float>::infinity());
    values.reserve(std::size_t(n[0] + 2) * std::size_t(n[1] + 2) * std::size_t(n[2] + 2));
    for (int k = -1; k <= n[2]; ++k)
        for (int j = -1; j <= n[1]; ++j)
            for (int i = -1; i <= n[0]; ++i)
            {
                const int a = std::clamp(i, 0, n[0] - 1), b = std::clamp(j, 0, n[1] - 1), c = std::clamp(k, 0, n[2] - 1);
                const float inner =
                    image.values[std::size_t(a) + std::size_t(n[0]) * (std::size_t(b) + std::size_t(n[1]) * std::size_t(c))];
                const bool isPadding = a != i || b != j || c != k;
                values.push_back(isPadding && inner >= iso ? std::min(float(2 * iso - inner), below) : inner);
            }
    return values;
}

double volumeOf(const TriangleSurface& s)
{
    double sum = 0;
    for (const auto& [a, b, c] : s.triangles)
        sum += dot(s.points[std::size_t(a)], cross(s.points[std::size_t(b)], s.points[std::size_t(c)])) / 6;
    return sum;
}

double wholeVolume(const VoxelImage& image) { return double(image.size()) * image.voxel.x * image.voxel.y * image.voxel.z; }

/// The surface on which the values are `iso`, normals outwards.
NumberedMesh surfaceAt(const VoxelImage& image, double iso)
{
    iso = float(iso); // a number of the kind that the values are
    const auto values = padded(image, iso);
    VoxelContour contour;
    contourVoxels()({image.cells[0] + 2, image.cells[1] + 2, image.cells[2] + 2}, values.data(), iso, contour);
    NumberedMesh mesh;
    const auto& h = image.voxel;
    for (const auto& [x, y, z] : contour.points)
        mesh.points.push_back(image.low + Vector<3>{h.x * (x - 0.5), h.y * (y - 0.5), h.z * (z - 0.5)});
    mesh.triangles = std::move(contour.triangles);
    if (volumeOf(mesh) < 0)
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

/// The surface of a smoothed indicator that encloses the share of the volume that is solid, by false position (Illinois: Dowell & Jarratt 1971).
NumberedMesh surfaceAround(const VoxelImage& image, double share)
{
    constexpr double tolerance = 1e-5; // of the volume
    constexpr int most = 20;
    double low = 0.1, high = 0.9; // more and less is solid at these values
    const auto excess = [&](const NumberedMesh& mesh) { return volumeOf(mesh) / wholeVolume(image) - share; };
    double atLow = excess(surfaceAt(image, low)), atHigh = excess(surfaceAt(image, high));
    NumberedMesh mesh;
    std::optional<bool> wasBelow;
    for (int k = 0; k < most; ++k)
    {
        const double iso = atLow > 0 && atHigh < 0 ? low + (high - low) * atLow / (atLow - atHigh) : 0.5;
        mesh = surfaceAt(image, iso);
        const double at = excess(mesh);
        if (std::abs(at) < tolerance || !(atLow > 0 && atHigh < 0)) break;
        const bool isBelow = at > 0;
        (isBelow ? low : high) = iso;
        (isBelow ? atLow : atHigh) = at;
        if (isBelow == wasBelow) (isBelow ? atHigh : atLow) *= 0.5; // the same end twice
        wasBelow = isBelow;
    }
    return mesh;
}

}

NumberedMesh importVolume(const std::filesystem::path& file, const TriSurface::Volume& v, std::vector<std::string>& notes)
{
    VoxelImage image;
    try
    {
        image = readVoxels(file, v);
    }
    catch (const UnusableMesh&)
    {
        throw;
    }
    catch (const std::exception& e)
    {
        throw UnusableMesh(fmt::format("it cannot be read: {}", e.what()));
    }
    std::size_t solid = 0;
    const auto iso = segment(image, v, solid);
    const double share = double(solid) / double(image.size());
    auto mesh = iso ? surfaceAt(image, *iso) : surfaceAround(image, share);
    mesh.regions = {"patch0"};
    mesh.region.assign(mesh.triangles.size(), 0);
    for (int f = 0; f < int(mesh.triangles.size()); ++f) mesh.number.push_back(f);

    const double porosity = 1 - share, ofSurface = 1 - volumeOf(mesh) / wholeVolume(image);
    const auto& h = image.voxel;
    notes.push_back(fmt::format(
        "{} x {} x {} voxels of {:.6g} x {:.6g} x {:.6g}: porosity {:.5f} by voxels, {:.5f} by the surface ({:+.2g} % of the void)",
        image.cells[0], image.cells[1], image.cells[2], h.x, h.y, h.z, porosity, ofSurface, 100 * (ofSurface / porosity - 1)));
    return mesh;
}

}
