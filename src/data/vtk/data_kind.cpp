#include "data/vtk/data_kind.h"

#include <vtkDataObjectTypes.h>

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

}  // namespace aeolic
