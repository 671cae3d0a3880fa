#include "base/CaseError.hpp"
#include "particles.hpp"
#include "surfaces/IsoSurface.hpp"
#include "surfaces/SurfaceWriter.hpp"
#include "temporaryFolder.hpp"
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

namespace sph::test
{

namespace
{

Mesh smallBall(double scale)
{
    auto geometry = space(3, {-6, -6, -6}, {6, 6, 6});
    const auto particles = lattice(geometry, ball({0, 0, 0}, 3));
    auto grid = gridOfDomain(geometry, step);
    const auto colour = colourFunction(grid, {}, particles, "wendlandC2", support, Normalisation::particles);
    grid.low = scale * grid.low;
    grid.step = scale * grid.step;
    return freeSurface(grid, colour, 0.5, geometry, 0);
}

template<class Reader> Mesh read(const std::filesystem::path& file)
{
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
}

}

// A written surface reads back with the same triangles and area, for a ball of a tenth of a millimetre, too: VTP keeps doubles,
// binary STL single precision (1e-6), OBJ six digits (1e-4 in the area of triangles of a tenth of the radius).
TEST(SurfaceWriter, FilesReadBack)
{
    const TemporaryFolder folder;
    const auto mesh = smallBall(3e-5);
    const double area = measure(mesh);
    for (const auto& format : surfaceFormats()) writeSurface(mesh, folder.path() / "new" / ("ball." + format));
    const auto check = [&](const Mesh& back, double tolerance)
    {
        EXPECT_EQ(back->GetNumberOfCells(), mesh->GetNumberOfCells());
        EXPECT_NEAR(measure(back) / area, 1, tolerance);
        EXPECT_GT(signedVolume(back), 0);
    };
    check(read<vtkXMLPolyDataReader>(folder.path() / "new" / "ball.vtp"), 1e-12);
    check(read<vtkSTLReader>(folder.path() / "new" / "ball.stl"), 1e-5);
    check(read<vtkOBJReader>(folder.path() / "new" / "ball.obj"), 1e-4);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "new" / "ball.vtp.partial"));
}

// An empty surface makes files, too: a series over time stays complete.
TEST(SurfaceWriter, WritesEmptySurfaces)
{
    const TemporaryFolder folder;
    writeSurface(Mesh::New(), folder / "none.vtp");
    EXPECT_EQ(read<vtkXMLPolyDataReader>(folder / "none.vtp")->GetNumberOfCells(), 0);
}

// A place where nothing can be written is a CaseError that names the file; VTK itself prints nothing.
TEST(SurfaceWriter, SaysWhatCannotBeWritten)
{
    const TemporaryFolder folder;
    folder.write("file", "");
    const auto message = [&](const std::filesystem::path& to)
    {
        try
        {
            writeSurface(smallBall(1), to);
        }
        catch (const CaseError& error)
        {
            return std::string(error.what());
        }
        return std::string("nothing was thrown");
    };
    testing::internal::CaptureStderr();
    EXPECT_NE(message(folder.path() / "file" / "ball.vtp").find("Cannot make the folder " + (folder / "file").string()), std::string::npos);
    std::filesystem::create_directories(folder / "taken.stl");
    std::filesystem::create_directories(folder.path() / "taken.stl.partial");
    EXPECT_NE(message(folder / "taken.stl").find("Cannot write " + (folder / "taken.stl").string()), std::string::npos);
    EXPECT_NE(message(folder / "ball.xyz").find("\".xyz\""), std::string::npos);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Contour lines of 2-D cases are no triangles.
TEST(SurfaceWriter, StlHoldsNoLines)
{
    EXPECT_FALSE(canHold("stl", 2));
    EXPECT_TRUE(canHold("stl", 3));
    EXPECT_TRUE(canHold("vtp", 2));
    EXPECT_TRUE(canHold("obj", 2));
}

}
