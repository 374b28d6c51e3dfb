#include "data/vtk/grid/volume_blocks.h"

#include <vtkAppendFilter.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <vector>

#include "aeolic/error.h"
#include "data/vtk/grid/grid_volume.h"
#include "data/vtk/messages.h"
#include "data/vtk/surface/blocks.h"

namespace aeolic {

vtkSmartPointer<vtkDataSet> volumeOf(vtkMultiBlockDataSet& blocks, const std::string& path)
{
    std::vector<vtkDataSet*> volumes;
    for (const Block& block : blocksOf(blocks))
        if (auto* data = vtkDataSet::SafeDownCast(block.data); data && hasVolume(*data)) volumes.push_back(data);
    if (volumes.empty())
        throw InputError(path, "none of its parts fills space", "cells of a volume (faces go to --surface)");
    if (volumes.size() == 1) return volumes.front();
    const VtkMessages messages;
    vtkNew<vtkAppendFilter> append;
    append->MergePointsOn();  // Cells of two parts that touch are neighbours.
    for (vtkDataSet* volume : volumes) append->AddInputData(volume);
    append->Update();
    if (messages.failed()) throw InputError(path, messages.firstError(), "parts that can be put together");
    return append->GetOutput();
}

}  // namespace aeolic
