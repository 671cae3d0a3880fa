#include "surfaces/SurfaceWriter.hpp"
#include "base/CaseError.hpp"
#include "surfaces/VtkErrors.hpp"
#include "surfaces/entries/surfaceEntries.hpp"
#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPoints.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataWriter.h>

namespace sph
{

std::span<const std::string> surfaceFormats()
{
    static const auto formats = entry::formats.info().choices.words();
    return formats;
}

bool canHold(const std::string& format, int dimension) { return format != "stl" || dimension == 3; }

namespace
{

void runWriter(auto* writer, vtkPolyData* mesh, const std::filesystem::path& file)
{
    const VtkErrors errors(writer);
    writer->SetInputData(mesh);
    writer->SetFileName(file.c_str());
    writer->Write();
    errors.throwIfAny(fmt::format("Cannot write {}", file.string()));
}

}

void writeSurface(vtkPolyData* surface, const std::filesystem::path& file)
{
    // An empty surface of VTK's has no array of points, which VTK's own readers then miss.
    vtkNew<vtkPolyData> mesh;
    mesh->ShallowCopy(surface);
    if (!mesh->GetPoints()) mesh->SetPoints(vtkNew<vtkPoints>());
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    if (failed) throw CaseError(fmt::format("Cannot make the folder {}: {}", file.parent_path().string(), failed.message()));
    const auto format = file.extension();
    auto partial = file;
    partial += ".partial";
    if (format == ".vtp")
    {
        vtkNew<vtkXMLPolyDataWriter> writer;
        runWriter(writer.Get(), mesh.Get(), partial);
    }
    else if (format == ".stl")
    {
        vtkNew<vtkSTLWriter> writer;
        writer->SetFileTypeToBinary();
        runWriter(writer.Get(), mesh.Get(), partial);
    }
    else if (format == ".obj")
    {
        vtkNew<vtkOBJWriter> writer;
        runWriter(writer.Get(), mesh.Get(), partial);
    }
    else throw CaseError(fmt::format("No surface format has the extension \"{}\" of {}", format.string(), file.string()));
    std::filesystem::rename(partial, file, failed);
    if (failed) throw CaseError(fmt::format("Cannot write {}: {}", file.string(), failed.message()));
}

}
