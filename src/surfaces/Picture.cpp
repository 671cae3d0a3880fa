#include "surfaces/Picture.hpp"
#include "base/CaseError.hpp"
#include "geometry/TriangleSurface.hpp"
#include "surfaces/VtkErrors.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkDualDepthPeelingPass.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageShrink3D.h>
#include <vtkLight.h>
#include <vtkLightKit.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOutlineSource.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkScalarBarActor.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTranslucentPass.h>
#include <vtkWindowToImageFilter.h>

namespace sph
{

namespace
{

using Colour = std::array<double, 3>;

constexpr Colour white{1, 1, 1}, ink{0.15, 0.17, 0.20}, stone{0.87, 0.85, 0.81}, cutStone{0.74, 0.72, 0.69}, water{0.08, 0.45, 0.86},
    cutWater{0.20, 0.55, 0.90};

/// Water, air and further phases, told apart by those who see no red or green, too (after Okabe and Ito 2008).
constexpr Colour phaseColours[] = {{0.00, 0.45, 0.70}, {0.85, 0.90, 0.93}, {0.90, 0.62, 0.00}, {0.00, 0.62, 0.45}, {0.80, 0.47, 0.65}};

/// Dark blue over green to yellow, of even steps to the eye: nine points of the scale viridis (van der Walt and Smith 2015).
constexpr Colour scale[] = {{0.267, 0.005, 0.329}, {0.283, 0.141, 0.458}, {0.230, 0.299, 0.535},
                            {0.173, 0.450, 0.558}, {0.128, 0.567, 0.551}, {0.158, 0.684, 0.502},
                            {0.369, 0.789, 0.383}, {0.678, 0.864, 0.190}, {0.993, 0.906, 0.144}};

/// Drawn this many times larger in each direction and averaged, for smooth edges.
constexpr int oversampling = 2;

constexpr std::size_t manyBalls = 20000;

bool drawable(vtkPolyData* mesh) { return mesh && mesh->GetNumberOfCells() > 0; }

vtkSmartPointer<vtkActor> actorOf(vtkPolyData* mesh, const Colour& colour)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    actor->GetProperty()->SetInterpolationToPhong();
    return actor;
}

void flat(vtkActor* actor) { actor->GetProperty()->LightingOff(); }

void addSolids(vtkRenderer* renderer, const Scene& scene)
{
    if (drawable(scene.walls))
    {
        auto actor = actorOf(scene.walls, stone);
        actor->GetProperty()->SetAmbient(0.18);
        actor->GetProperty()->SetDiffuse(0.82);
        actor->GetProperty()->SetSpecular(0.12);
        actor->GetProperty()->SetSpecularPower(20);
        actor->GetProperty()->SetOpacity(scene.wallOpacity);
        renderer->AddActor(actor);
    }
    if (drawable(scene.wallCuts))
    {
        auto actor = actorOf(scene.wallCuts, cutStone);
        if (scene.dimension == 2) flat(actor);
        actor->GetProperty()->SetInterpolationToFlat();
        actor->GetProperty()->SetAmbient(0.55);
        actor->GetProperty()->SetDiffuse(0.45);
        actor->GetProperty()->SetOpacity(scene.wallOpacity);
        renderer->AddActor(actor);
    }
}

/// The scale from the least to the largest value, or over a range that is given.
vtkSmartPointer<vtkScalarsToColors> scaleOf(double least, double most, const std::optional<std::array<double, 2>>& given)
{
    const auto [low, high] = given.value_or(std::array{least, most});
    const double range = high > low ? high - low : std::max(1.0, std::fabs(low));
    auto colours = vtkSmartPointer<vtkColorTransferFunction>::New();
    for (std::size_t k = 0; k < std::size(scale); ++k)
        colours->AddRGBPoint(low + range * double(k) / (std::size(scale) - 1), scale[k][0], scale[k][1], scale[k][2]);
    return colours;
}

vtkSmartPointer<vtkScalarsToColors> coloursOf(const Points& points)
{
    if (!points.phases.empty())
    {
        auto table = vtkSmartPointer<vtkLookupTable>::New();
        const int count = int(points.phases.size());
        table->SetNumberOfTableValues(count);
        table->SetTableRange(-0.5, count - 0.5);
        for (int k = 0; k < count; ++k)
        {
            const auto& c = phaseColours[k % std::size(phaseColours)];
            table->SetTableValue(k, c[0], c[1], c[2]);
        }
        return table;
    }
    const auto [least, most] = std::minmax_element(points.value.begin(), points.value.end());
    return scaleOf(*least, *most, points.range);
}

/// A line of text that ends at `right`, in pixels of the picture from its lower left corner: it grows to the left and is never cut off by the edge.
void writeUpTo(vtkRenderer* renderer, const std::string& text, double right, double bottom, int fontSize)
{
    vtkNew<vtkTextActor> actor;
    actor->SetInput(text.c_str());
    actor->SetPosition(oversampling * right, oversampling * bottom);
    auto* property = actor->GetTextProperty();
    property->SetJustificationToRight();
    property->SetFontFamilyToArial();
    property->SetFontSize(fontSize * oversampling);
    property->SetColor(ink[0], ink[1], ink[2]);
    renderer->AddActor2D(actor);
}

void addColourBar(vtkRenderer* renderer, const Scene& scene, const std::string& title, vtkScalarsToColors* colours)
{
    // A label, as -1.23e+05, needs some 80 pixels beside the bar: more of a narrower picture, as long as the bar does not stand in it.
    const double width = std::clamp(100.0 / scene.size[0], 0.09, 0.11), bottom = 0.2, height = 0.6;
    vtkNew<vtkScalarBarActor> bar;
    bar->SetLookupTable(colours);
    bar->SetNumberOfLabels(5);
    bar->SetLabelFormat("%.3g");
    bar->SetPosition(0.99 - width, bottom);
    bar->SetWidth(width);
    bar->SetHeight(height);
    bar->SetBarRatio(0.25);
    bar->UnconstrainedFontSizeOn();
    auto* text = bar->GetLabelTextProperty();
    text->SetColor(ink[0], ink[1], ink[2]);
    text->SetFontFamilyToArial();
    text->SetFontSize(16 * oversampling);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
    renderer->AddActor2D(bar);
    writeUpTo(renderer, title, scene.size[0] - 14, (bottom + height) * scene.size[1] + 22, 16);
}

/// Surface and cuts in the colours of the values at their points, opaque, so that a colour is what the bar says.
void addColouredLiquid(vtkRenderer* renderer, const Scene& scene)
{
    double least = std::numeric_limits<double>::max(), most = std::numeric_limits<double>::lowest();
    std::vector<vtkPolyData*> meshes;
    for (vtkPolyData* mesh : {scene.liquid.Get(), scene.liquidCuts.Get()})
        if (drawable(mesh))
        {
            const auto* range = mesh->GetPointData()->GetScalars()->GetRange();
            least = std::min(least, range[0]);
            most = std::max(most, range[1]);
            meshes.push_back(mesh);
        }
    if (meshes.empty()) return;
    const auto colours = scaleOf(least, most, scene.liquidColours->range);
    for (auto* mesh : meshes)
    {
        auto actor = actorOf(mesh, white);
        actor->GetMapper()->ScalarVisibilityOn();
        actor->GetMapper()->SetLookupTable(colours);
        actor->GetMapper()->UseLookupTableScalarRangeOn();
        actor->GetMapper()->InterpolateScalarsBeforeMappingOn();
        if (mesh == scene.liquidCuts) actor->GetProperty()->SetInterpolationToFlat();
        actor->GetProperty()->SetAmbient(0.35);
        actor->GetProperty()->SetDiffuse(0.7);
        renderer->AddActor(actor);
    }
    addColourBar(renderer, scene, scene.liquidColours->title, colours);
}

void addLiquid(vtkRenderer* renderer, const Scene& scene)
{
    if (scene.liquidColours) return addColouredLiquid(renderer, scene);
    if (drawable(scene.liquid))
    {
        auto actor = actorOf(scene.liquid, water);
        actor->GetProperty()->SetOpacity(0.66);
        actor->GetProperty()->SetAmbient(0.22);
        actor->GetProperty()->SetDiffuse(0.75);
        actor->GetProperty()->SetSpecular(0.75);
        actor->GetProperty()->SetSpecularPower(60);
        renderer->AddActor(actor);
    }
    if (drawable(scene.liquidCuts))
    {
        auto actor = actorOf(scene.liquidCuts, cutWater);
        actor->GetProperty()->SetInterpolationToFlat();
        actor->GetProperty()->SetOpacity(0.72);
        actor->GetProperty()->SetAmbient(0.35);
        actor->GetProperty()->SetDiffuse(0.65);
        renderer->AddActor(actor);
    }
}

void addOutline(vtkRenderer* renderer, const Scene& scene)
{
    vtkNew<vtkOutlineSource> outline;
    const double z0 = scene.dimension == 2 ? 0 : scene.low.z, z1 = scene.dimension == 2 ? 0 : scene.high.z;
    outline->SetBounds(scene.low.x, scene.high.x, scene.low.y, scene.high.y, z0, z1);
    outline->Update();
    auto actor = actorOf(outline->GetOutput(), ink);
    flat(actor);
    actor->GetProperty()->SetLineWidth(1.2 * oversampling);
    renderer->AddActor(actor);
}

void addContour(vtkRenderer* renderer, const Scene& scene)
{
    if (!drawable(scene.contour)) return;
    auto actor = actorOf(scene.contour, ink);
    flat(actor);
    actor->GetProperty()->SetLineWidth(2.0 * oversampling);
    // The lines lie in front of the discs, which are in the plane z = 0.
    actor->SetPosition(0, 0, 1e-3 * mag(scene.high - scene.low));
    renderer->AddActor(actor);
}

/// Names of the phases with their colours, one below the other.
void addLegend(vtkRenderer* renderer, const Scene& scene)
{
    for (std::size_t k = 0; k < scene.points.phases.size(); ++k)
    {
        const auto& colour = phaseColours[k % std::size(phaseColours)];
        const double right = scene.size[0] - 14, bottom = scene.size[1] - 60 - 28 * double(k);
        vtkNew<vtkTextActor> patch;
        patch->SetInput("    ");
        patch->SetPosition(oversampling * (right - 26), oversampling * bottom);
        patch->GetTextProperty()->SetFontSize(18 * oversampling);
        patch->GetTextProperty()->SetBackgroundColor(colour[0], colour[1], colour[2]);
        patch->GetTextProperty()->SetBackgroundOpacity(1);
        patch->GetTextProperty()->FrameOn();
        patch->GetTextProperty()->SetFrameColor(ink[0], ink[1], ink[2]);
        renderer->AddActor2D(patch);
        writeUpTo(renderer, scene.points.phases[k], right - 36, bottom, 18);
    }
}

void addPoints(vtkRenderer* renderer, const Scene& scene)
{
    const auto& points = scene.points;
    if (points.position.empty()) return;
    vtkNew<vtkPoints> positions;
    vtkNew<vtkDoubleArray> values;
    values->SetName("value");
    for (std::size_t p = 0; p < points.position.size(); ++p)
    {
        const auto& x = points.position[p];
        positions->InsertNextPoint(x.x, x.y, x.z);
        values->InsertNextValue(points.value[p]);
    }
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(positions);
    cloud->GetPointData()->SetScalars(values);

    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(cloud);
    vtkSmartPointer<vtkPolyDataAlgorithm> shape;
    if (scene.dimension == 2)
    {
        auto disc = vtkSmartPointer<vtkRegularPolygonSource>::New();
        disc->SetNumberOfSides(20);
        disc->SetRadius(points.diameter / 2);
        disc->GeneratePolylineOff();
        shape = disc;
    }
    else
    {
        auto ball = vtkSmartPointer<vtkSphereSource>::New();
        // Of many, each is a few pixels wide.
        const bool many = points.position.size() > manyBalls;
        ball->SetThetaResolution(many ? 10 : 20);
        ball->SetPhiResolution(many ? 8 : 14);
        ball->SetRadius(points.diameter / 2);
        shape = ball;
    }
    mapper->SetSourceConnection(shape->GetOutputPort());
    mapper->ScalingOff();
    mapper->OrientOff();
    const auto colours = coloursOf(points);
    mapper->SetLookupTable(colours);
    mapper->UseLookupTableScalarRangeOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    if (scene.dimension == 2) flat(actor);
    renderer->AddActor(actor);
    if (points.phases.empty()) addColourBar(renderer, scene, points.title, colours);
    else addLegend(renderer, scene);
}

void addTitle(vtkRenderer* renderer, const Scene& scene)
{
    if (scene.title.empty()) return;
    vtkNew<vtkTextActor> title;
    title->SetInput(scene.title.c_str());
    title->SetPosition(24 * oversampling, (scene.size[1] - 44) * oversampling);
    title->GetTextProperty()->SetFontFamilyToArial();
    title->GetTextProperty()->SetFontSize(22 * oversampling);
    title->GetTextProperty()->SetColor(ink[0], ink[1], ink[2]);
    renderer->AddActor2D(title);
}

/// Clefts between opaque bodies are darkened (ambient occlusion), and translucent surfaces behind one another drawn in their
/// order.
void setPasses(vtkRenderer* renderer, const Scene& scene)
{
    vtkNew<vtkSSAOPass> occlusion;
    occlusion->SetRadius(0.12 * mag(scene.high - scene.low));
    occlusion->SetBias(0.002 * mag(scene.high - scene.low));
    occlusion->SetKernelSize(64);
    occlusion->BlurOn();
    occlusion->SetDelegatePass(vtkNew<vtkOpaquePass>());
    vtkNew<vtkDualDepthPeelingPass> peeling;
    peeling->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
    peeling->SetMaximumNumberOfPeels(12);
    peeling->SetOcclusionRatio(0);
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetOpaquePass(occlusion);
    steps->SetTranslucentPass(peeling);
    renderer->SetPass(steps);
}

/// View from above the front right corner; nearly straight at a plane that the scene is cut by.
Vector<3> viewDirection(const Camera& wish)
{
    const auto up = wish.up / mag(wish.up);
    if (wish.facing)
    {
        const auto& n = *wish.facing;
        const auto side = cross(up, n);
        return n + 0.3 * (mag(side) > 0 ? side / mag(side) : crossSection(up)[0]) + 0.25 * up;
    }
    const auto right = crossSection(up)[0];
    return 1.75 * cross(right, up) + 0.85 * right + 0.75 * up;
}

/// A plane scene fills the picture, seen from +z. A colour bar takes its place on the right.
void setPlaneCamera(vtkCamera* camera, const Scene& scene)
{
    const auto extent = scene.high - scene.low;
    const bool bar = scene.liquidColours || (!scene.points.position.empty() && scene.points.phases.empty());
    const double aspect = double(scene.size[0]) / scene.size[1];
    const double height = std::max(1.16 * extent.y, (bar ? 1.3 : 1.08) * extent.x / aspect) / scene.camera.zoom;
    auto centre = scene.camera.focalPoint.value_or(0.5 * (scene.low + scene.high));
    if (bar) centre.x += 0.06 * height * aspect;
    camera->SetFocalPoint(centre.x, centre.y, 0);
    camera->SetPosition(centre.x, centre.y, mag(extent));
    camera->SetViewUp(0, 1, 0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * height);
}

void setSpaceCamera(vtkRenderer* renderer, const Scene& scene)
{
    const auto& wish = scene.camera;
    auto* camera = renderer->GetActiveCamera();
    const auto centre = wish.focalPoint.value_or(0.5 * (scene.low + scene.high));
    const auto position = wish.position.value_or(centre + mag(scene.high - scene.low) * viewDirection(wish));
    camera->SetFocalPoint(centre.x, centre.y, centre.z);
    camera->SetPosition(position.x, position.y, position.z);
    camera->SetViewUp(wish.up.x, wish.up.y, wish.up.z);
    camera->SetViewAngle(24);
    if (!wish.position)
    {
        const double bounds[6] = {scene.low.x, scene.high.x, scene.low.y, scene.high.y, scene.low.z, scene.high.z};
        renderer->ResetCamera(bounds);
    }
    camera->Zoom(wish.zoom);
}

void setCamera(vtkRenderer* renderer, const Scene& scene)
{
    if (scene.dimension == 2) setPlaneCamera(renderer->GetActiveCamera(), scene);
    else setSpaceCamera(renderer, scene);
    renderer->ResetCameraClippingRange();
}

std::string lengthInWords(double length)
{
    if (length >= 1) return fmt::format("{:g} m", length);
    if (length >= 1e-3) return fmt::format("{:g} mm", 1e3 * length);
    return fmt::format("{:g} um", 1e6 * length);
}

/// A bar at the lower left, about a fifth of the picture long, and its length. Its place is in pixels, so that the camera must be set.
void addScaleBar(vtkRenderer* renderer, const Scene& scene)
{
    auto* camera = renderer->GetActiveCamera();
    const double degree = std::numbers::pi / 180;
    const double heightSeen = camera->GetParallelProjection() ? 2 * camera->GetParallelScale()
                                                              : 2 * camera->GetDistance() * std::tan(0.5 * degree * camera->GetViewAngle());
    const double pixel = heightSeen / (oversampling * scene.size[1]);
    const double length = roundLength(0.25 * oversampling * scene.size[0] * pixel);
    const double left = 24 * oversampling, bottom = 16 * oversampling, thickness = 5 * oversampling, right = left + length / pixel;
    vtkNew<vtkPoints> corners;
    corners->InsertNextPoint(left, bottom, 0);
    corners->InsertNextPoint(right, bottom, 0);
    corners->InsertNextPoint(right, bottom + thickness, 0);
    corners->InsertNextPoint(left, bottom + thickness, 0);
    vtkNew<vtkCellArray> bar;
    bar->InsertNextCell({0, 1, 2, 3});
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(corners);
    mesh->SetPolys(bar);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(ink[0], ink[1], ink[2]);
    renderer->AddActor2D(actor);
    vtkNew<vtkTextActor> text;
    text->SetInput(lengthInWords(length).c_str());
    text->SetPosition(left, bottom + 2 * thickness);
    text->GetTextProperty()->SetFontFamilyToArial();
    text->GetTextProperty()->SetFontSize(16 * oversampling);
    text->GetTextProperty()->SetColor(ink[0], ink[1], ink[2]);
    renderer->AddActor2D(text);
}

}

double roundLength(double most)
{
    const double decade = std::pow(10, std::floor(std::log10(most)));
    return (most >= 5 * decade ? 5 : most >= 2 * decade ? 2 : 1) * decade;
}

void drawPicture(const Scene& scene, const std::filesystem::path& png)
{
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(white[0], white[1], white[2]);
    addSolids(renderer, scene);
    addLiquid(renderer, scene);
    addPoints(renderer, scene);
    addContour(renderer, scene);
    addOutline(renderer, scene);
    addTitle(renderer, scene);

    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetAlphaBitPlanes(1);
    window->SetSize(oversampling * scene.size[0], oversampling * scene.size[1]);
    window->AddRenderer(renderer);
    vtkNew<vtkLightKit> lights;
    lights->SetKeyLightIntensity(1.05);
    lights->SetKeyLightAngle(45, 25);
    lights->SetKeyToFillRatio(2.2);
    lights->SetKeyToHeadRatio(2.6);
    lights->AddLightsToRenderer(renderer);
    setCamera(renderer, scene);
    if (scene.scaleBar) addScaleBar(renderer, scene);
    if (scene.dimension == 3) setPasses(renderer, scene);
    window->Render();

    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(window);
    image->SetInputBufferTypeToRGB();
    image->ReadFrontBufferOff();
    vtkNew<vtkImageShrink3D> averaged;
    averaged->SetInputConnection(image->GetOutputPort());
    averaged->SetShrinkFactors(oversampling, oversampling, 1);
    averaged->AveragingOn();

    std::error_code failed;
    std::filesystem::create_directories(png.parent_path(), failed);
    if (failed) throw CaseError(fmt::format("Cannot make the folder {}: {}", png.parent_path().string(), failed.message()));
    vtkNew<vtkPNGWriter> writer;
    const VtkErrors errors(writer);
    writer->SetFileName(png.c_str());
    writer->SetInputConnection(averaged->GetOutputPort());
    writer->Write();
    errors.throwIfAny(fmt::format("Cannot write {}", png.string()));
}

}
