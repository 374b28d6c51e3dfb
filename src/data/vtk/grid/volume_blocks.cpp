#include "data/vtk/grid/volume_blocks.h"

#include <vtkAppendFilter.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <vector>

#include "aeolic/error.h"
#include "data/vtk/arrays.h"
#include "data/vtk/data_objects.h"
#include "data/vtk/grid/cell_means.h"
#include "data/vtk/messages.h"

namespace aeolic {

namespace {

/// Volumes that are put together keep only the arrays that all of them have. So where one volume hides cells or points,
/// the others get flags that hide none.
void shareFlags(const std::vector<vtkDataSet*>& volumes, bool onPoints)
{
    const char* const name = vtkDataSetAttributes::GhostArrayName();
    const auto has = [&](vtkDataSet* data) { return findArray(*data, name, onPoints) != nullptr; };
    if (std::none_of(volumes.begin(), volumes.end(), has)) return;
    for (vtkDataSet* volume : volumes) {
        if (has(volume)) continue;
        vtkNew<vtkUnsignedCharArray> none;
        none->SetName(name);
        none->SetNumberOfValues(onPoints ? volume->GetNumberOfPoints() : volume->GetNumberOfCells());
        none->FillValue(0);
        attributesOf(*volume, onPoints)->AddArray(none);
    }
}

}  // namespace

vtkSmartPointer<vtkDataSet> volumeOf(vtkMultiBlockDataSet& blocks, const std::string& path)
{
    std::vector<vtkDataSet*> volumes, faces;
    for (const Block& block : blocksOf(blocks)) {
        auto* data = vtkDataSet::SafeDownCast(block.data);
        if (!data || data->GetDataObjectType() == VTK_POLY_DATA) continue;
        const int dimension = dimensionOfCells(*data);
        if (dimension == 3) volumes.push_back(data);
        if (dimension == 2) faces.push_back(data);
    }
    if (volumes.empty()) volumes.swap(faces);
    if (volumes.empty())
        throw InputError(path, "none of its parts fills space", "cells of a volume (polygons go to --surface)");
    if (volumes.size() == 1) return volumes.front();
    for (const bool onPoints : {false, true}) shareFlags(volumes, onPoints);
    const VtkMessages messages;
    vtkNew<vtkAppendFilter> append;
    append->MergePointsOn();  // Cells of two parts that touch are neighbours.
    for (vtkDataSet* volume : volumes) append->AddInputData(volume);
    append->Update();
    if (messages.failed()) throw InputError(path, messages.firstError(), "parts that can be put together");
    return append->GetOutput();
}

}  // namespace aeolic
