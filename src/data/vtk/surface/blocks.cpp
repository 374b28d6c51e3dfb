#include "data/vtk/surface/blocks.h"

#include <vtkInformation.h>

namespace aeolic {

std::vector<Block> blocksOf(vtkMultiBlockDataSet& blocks)
{
    std::vector<Block> all;
    for (unsigned i = 0; i < blocks.GetNumberOfBlocks(); ++i) {
        vtkDataObject* block = blocks.GetBlock(i);
        if (!block) continue;
        const bool named = blocks.HasMetaData(i) && blocks.GetMetaData(i)->Has(vtkCompositeDataSet::NAME());
        all.push_back({named ? blocks.GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : std::to_string(i), block});
    }
    return all;
}

}  // namespace aeolic
