#include "reader/vtk/block_arrays.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <cmath>

namespace aeolic {

void unifyArrays(vtkDataSet& block, const std::vector<ArrayInfo>& kept)
{
    for (const ArrayInfo& array : kept) {
        if (isMaskName(array.name)) continue;
        vtkDataArray* const own = findArray(block, array.name, array.onPoints);
        vtkSmartPointer<vtkFloatArray> values;
        if (own && own->GetNumberOfComponents() == array.components) {
            values = toFloats(own);
        } else {
            values = vtkSmartPointer<vtkFloatArray>::New();
            values->SetName(array.name.c_str());
            values->SetNumberOfComponents(array.components);
            values->SetNumberOfTuples(array.onPoints ? block.GetNumberOfPoints() : block.GetNumberOfCells());
            values->FillValue(std::nanf(""));
        }
        (array.onPoints ? static_cast<vtkFieldData*>(block.GetPointData()) : block.GetCellData())->AddArray(values);
    }
}

}  // namespace aeolic
