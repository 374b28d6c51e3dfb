#pragma once

#include <vtkDataObject.h>
#include <vtkMultiBlockDataSet.h>

#include <string>
#include <vector>

namespace aeolic {

/// "image data", "an unstructured grid" …
std::string kindOf(vtkDataObject& data);

/// A part of a file of several, as it was read.
struct Block {
    std::string name;
    vtkDataObject* data;
};

/// All blocks that are there, in their order. Readers give no blocks in blocks.
std::vector<Block> blocksOf(vtkMultiBlockDataSet& blocks);

}  // namespace aeolic
