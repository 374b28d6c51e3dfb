#pragma once

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace aeolic {

/// A part of a file of several, as it was read.
struct Block {
    std::string name;
    vtkDataObject* data;
};

/// All blocks that are there, in their order. Readers give no blocks in blocks.
std::vector<Block> blocksOf(vtkMultiBlockDataSet& blocks);

/// The faces of cells that no other cell has.
vtkSmartPointer<vtkPolyData> outerSurface(vtkDataSet& cells);

}  // namespace aeolic
