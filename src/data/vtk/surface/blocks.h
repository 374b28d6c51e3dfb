#pragma once

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace aeolic {

/// A data object in a tree of blocks.
struct Block {
    std::string name;                 ///< "air/walls/left": its own name behind those of the blocks that it stands in.
    std::vector<std::string> groups;  ///< The blocks that it stands in: "air", "air/walls".
    vtkDataObject* data;
};

/// All of the tree, in its order. A block without a name has its number.
std::vector<Block> blocksOf(vtkMultiBlockDataSet& blocks);

/// Those that `wanted` names (data/part_choice.h), or all. Throws InputError, which begins with `path`.
std::vector<Block> chooseBlocks(const std::vector<Block>& blocks, const std::vector<std::string>& wanted,
                                const std::string& path);

/// The faces of cells that no other cell has.
vtkSmartPointer<vtkPolyData> outerSurface(vtkDataSet& cells);

}  // namespace aeolic
