#include "reader/vtk/foam_volume.h"

#include <fmt/format.h>
#include <vtkAppendFilter.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/vtk/messages.h"
#include "reader/openfoam/foam_check.h"
#include "reader/vtk/foam_patches.h"
#include "reader/vtk/modules/modules.h"

namespace aeolic {
namespace {

constexpr std::uint64_t kBytesOfCell = 200;  // About: its points, corners and what the reader needs on the way.

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

vtkSmartPointer<vtkDataObject> FoamVolume::read(const std::vector<ArrayInfo>& kept) const
{
    return read(kept, std::nullopt);
}

vtkSmartPointer<vtkDataObject> FoamVolume::readPiece(const std::vector<ArrayInfo>& kept, int processor) const
{
    return read(kept, std::size_t(processor));
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
    for (const std::string& folder : folders)
        vtkModule().readFoamFolder(foam_, folder, time_, fields, polyhedra_, *append);
    if (append->GetNumberOfInputConnections(0) > 0) append->Update();
    if (messages.failed())
        throw InputError(foam_.name, "it cannot be read (" + messages.firstError() + ")", "a complete, undamaged case");
    vtkUnstructuredGrid* grid = append->GetOutput();
    if (!grid || grid->GetNumberOfCells() == 0)
        throw InputError(foam_.name, "no cells could be read", "a complete, undamaged case");
    return grid;
}

}  // namespace aeolic
