#include "data/vtk/grid/foam_volume.h"

#include <fmt/format.h>
#include <vtkAppendFilter.h>
#include <vtkCompositeDataIterator.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/openfoam/foam_check.h"
#include "data/openfoam/foam_stream.h"
#include "data/vtk/messages.h"
#include "data/vtk/surface/foam_file.h"

namespace aeolic {
namespace {

constexpr std::uint64_t kBytesOfCell = 200;  // About: its points, corners and what the reader needs on the way.

/// All cells of one folder, of all its regions, appended to `append`. `polyhedra`: they stay whole.
void readFolder(const FoamCase& foam, const std::string& folder, double time, const std::vector<FoamField>& fields,
                bool polyhedra, vtkAppendFilter& append)
{
    vtkNew<vtkOpenFOAMReader> reader;
    reader->SetFileName((folder + "/case.foam").c_str());
    reader->SetListTimeStepsByControlDict(false);
    reader->SetSkipZeroTime(false);
    reader->SetCreateCellToPoint(false);
    reader->SetDecomposePolyhedra(!polyhedra);
    const FoamStream points(foamMeshFile(folder, foam.regions.front(), time, "points"));
    reader->SetUse64BitLabels(points.longLabels());
    reader->SetUse64BitFloats(points.longScalars());
    reader->UpdateInformation();
    reader->DisableAllPatchArrays();
    for (const std::string& region : foam.regions)
        reader->SetPatchArrayStatus((region.empty() ? "internalMesh" : region + "/internalMesh").c_str(), 1);
    reader->DisableAllCellArrays();
    for (const FoamField& field : fields) reader->SetCellArrayStatus(field.name.c_str(), 1);
    reader->DisableAllPointArrays();
    reader->DisableAllLagrangianArrays();
    reader->UpdateTimeStep(time);
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
        if (auto* grid = vtkUnstructuredGrid::SafeDownCast(iterator->GetCurrentDataObject())) {
            vtkNew<vtkUnstructuredGrid> copy;
            copy->ShallowCopy(grid);
            append.AddInputData(copy);
        }
}

}  // namespace

FoamVolume::FoamVolume(const std::string& path, std::optional<double> time) : foam_(findFoamCase(path))
{
    time_ = time.value_or(firstFoamTime(foam_));
    if (!foam_.times.empty()) arrays_ = foamArrays(foamFields(foam_, foam_.regions.front(), time_), "U");
}

void FoamVolume::requireAtTime(const std::vector<std::string>& names) const
{
    for (const std::string& name : names) requireFoamFieldAt(foam_, foam_.regions.front(), time_, name);
}

vtkSmartPointer<vtkDataObject> FoamVolume::read(const std::vector<ArrayInfo>& kept,
                                                std::optional<std::size_t> processor) const
{
    std::vector<std::string> folders = foam_.folders;
    if (processor) folders = {foam_.folders.at(*processor)};
    std::vector<FoamField> fields;
    for (const ArrayInfo& array : kept) fields.push_back({array.name, array.components});
    std::uint64_t cells = 0;
    for (const std::string& folder : folders)
        for (const std::string& region : foam_.regions) cells += checkFoamVolume(folder, region, time_, fields);
    if (cells == 0 && processor) return vtkSmartPointer<vtkUnstructuredGrid>::New();
    if (cells == 0) throw InputError(foam_.name, "its mesh has no cells", "a mesh with cells");
    requireMemory(foam_.name, fmt::format("a mesh of {} cells", cells), cells * kBytesOfCell);

    const VtkMessages messages;
    vtkNew<vtkAppendFilter> append;
    append->SetMergePoints(folders.size() > 1);
    for (const std::string& folder : folders) readFolder(foam_, folder, time_, fields, polyhedra_, *append);
    if (append->GetNumberOfInputConnections(0) > 0) append->Update();
    if (messages.failed())
        throw InputError(foam_.name, "it cannot be read (" + messages.firstError() + ")", "a complete, undamaged case");
    vtkUnstructuredGrid* grid = append->GetOutput();
    if (!grid || grid->GetNumberOfCells() == 0)
        throw InputError(foam_.name, "no cells could be read", "a complete, undamaged case");
    return grid;
}

}  // namespace aeolic
