#include "surfaces/Picture.hpp"
#include "base/CaseError.hpp"
#include "geometry/TriangleSurface.hpp"
#include "surfaces/VtkErrors.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
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
#include <vtkProperty.h>
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

bool drawable(const Mesh& mesh) { return mesh && mesh->GetNumberOfCells() > 0; }

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
        renderer->AddActor(actor);
    }
    if (drawable(scene.wallCuts))
    {
        auto actor = actorOf(scene.wallCuts, cutStone);
        if (scene.dimension == 2) flat(actor);
        actor->GetProperty()->SetInterpolationToFlat();
        actor->GetProperty()->SetAmbient(0.55);
        actor->GetProperty()->SetDiffuse(0.45);
        renderer->AddActor(actor);
    }
}

void addLiquid(vtkRenderer* renderer, const Scene& scene)
{
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
    const auto [low, high] = points.range.value_or(std::array{*least, *most});
    const double range = high > low ? high - low : std::max(1.0, std::fabs(low));
    auto colours = vtkSmartPointer<vtkColorTransferFunction>::New();
    for (std::size_t k = 0; k < std::size(scale); ++k)
        colours->AddRGBPoint(low + range * double(k) / (std::size(scale) - 1), scale[k][0], scale[k][1], scale[k][2]);
    return colours;
}

void addColourBar(vtkRenderer* renderer, const Points& points, vtkScalarsToColors* colours)
{
    vtkNew<vtkScalarBarActor> bar;
    bar->SetLookupTable(colours);
    bar->SetTitle((points.title + "\n ").c_str());
    bar->SetNumberOfLabels(5);
    bar->SetLabelFormat("%.3g");
    bar->SetPosition(0.9, 0.2);
    bar->SetWidth(0.09);
    bar->SetHeight(0.6);
    bar->SetBarRatio(0.25);
    bar->UnconstrainedFontSizeOn();
    for (auto* text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()})
    {
        text->SetColor(ink[0], ink[1], ink[2]);
        text->SetFontFamilyToArial();
        text->SetFontSize(16 * oversampling);
        text->ItalicOff();
        text->BoldOff();
        text->ShadowOff();
    }
    renderer->AddActor2D(bar);
}

/// Names of the phases in their colours, one below the other.
void addLegend(vtkRenderer* renderer, const Scene& scene)
{
    for (std::size_t k = 0; k < scene.points.phases.size(); ++k)
    {
        auto colour = phaseColours[k % std::size(phaseColours)];
        const double top = scene.size[1] - 60 - 28 * double(k);
        const auto write = [&](const std::string& text, double x, const Colour& c)
        {
            vtkNew<vtkTextActor> actor;
            actor->SetInput(text.c_str());
            actor->SetPosition(oversampling * x, oversampling * top);
            actor->GetTextProperty()->SetFontFamilyToArial();
            actor->GetTextProperty()->SetFontSize(18 * oversampling);
            actor->GetTextProperty()->SetColor(c[0], c[1], c[2]);
            renderer->AddActor2D(actor);
        };
        vtkNew<vtkTextActor> patch;
        patch->SetInput("    ");
        patch->SetPosition(oversampling * (scene.size[0] - 150), oversampling * top);
        patch->GetTextProperty()->SetFontSize(18 * oversampling);
        patch->GetTextProperty()->SetBackgroundColor(colour[0], colour[1], colour[2]);
        patch->GetTextProperty()->SetBackgroundOpacity(1);
        patch->GetTextProperty()->FrameOn();
        patch->GetTextProperty()->SetFrameColor(ink[0], ink[1], ink[2]);
        renderer->AddActor2D(patch);
        write(scene.points.phases[k], scene.size[0] - 110, ink);
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
        ball->SetThetaResolution(20);
        ball->SetPhiResolution(14);
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
    if (points.phases.empty()) addColourBar(renderer, points, colours);
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
        return n + 0.3 * (mag(side) > 0 ? side / mag(side) : Vector<3>{}) + 0.25 * up;
    }
    const auto right = crossSection(up)[0];
    return 1.75 * cross(right, up) + 0.85 * right + 0.75 * up;
}

/// A plane scene fills the picture, seen from +z. A colour bar takes its place on the right.
void setPlaneCamera(vtkCamera* camera, const Scene& scene)
{
    const auto extent = scene.high - scene.low;
    const bool bar = !scene.points.position.empty() && scene.points.phases.empty();
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
