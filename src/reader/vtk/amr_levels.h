#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace aeolic {

/// A block of a data set that is refined in levels.
struct LeveledBlock {
    vtkSmartPointer<vtkDataObject> data;
    int level = 0;
};

/// Marks those cells of uniform grids whose middle lies in a block of a finer level: that one is drawn instead. Other
/// data stay as they are. Cost: O(cells), for blocks that overlap.
void hideRefined(const std::vector<LeveledBlock>& blocks);

}  // namespace aeolic
