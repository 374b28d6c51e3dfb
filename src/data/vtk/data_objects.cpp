#include "data/vtk/data_objects.h"

#include <vtkDataObjectTypes.h>
#include <vtkInformation.h>

namespace aeolic {

std::string kindOf(vtkDataObject& data)
{
    switch (data.GetDataObjectType()) {
        case VTK_POLY_DATA:
            return "polygons";
        case VTK_IMAGE_DATA:
        case VTK_STRUCTURED_POINTS:
        case VTK_UNIFORM_GRID:
            return "image data";
        case VTK_RECTILINEAR_GRID:
            return "a rectilinear grid";
        case VTK_STRUCTURED_GRID:
            return "a structured grid";
        case VTK_UNSTRUCTURED_GRID:
            return "an unstructured grid";
        case VTK_MULTIBLOCK_DATA_SET:
            return "a multi-block data set";
        default:
            return data.GetClassName();
    }
}

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
