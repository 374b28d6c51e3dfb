#include "reader/vtk/block_arrays.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkType.h>

#include <algorithm>
#include <cmath>

namespace aeolic {

int vtkTypeOf(NumberType type)
{
    constexpr int types[] = {VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,     VTK_UNSIGNED_SHORT,
                             VTK_INT,         VTK_UNSIGNED_INT,  VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
                             VTK_FLOAT,       VTK_DOUBLE};
    return types[std::size_t(type)];
}

void addOthers(std::vector<ArrayInfo>& arrays, const std::vector<ArrayInfo>& more)
{
    for (const ArrayInfo& array : more)
        if (!findInfo(arrays, array.name, array.onPoints)) arrays.push_back(array);
}

vtkSmartPointer<vtkFloatArray> floatArray(const std::string& name, int components, std::size_t tuples)
{
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(vtkIdType(tuples));
    return array;
}

void addBlock(vtkMultiBlockDataSet& blocks, vtkDataObject* data, const std::string& name)
{
    const unsigned number = blocks.GetNumberOfBlocks();
    blocks.SetBlock(number, data);
    blocks.GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

void unifyArrays(vtkDataSet& block, const std::vector<ArrayInfo>& kept)
{
    for (const ArrayInfo& array : kept) {
        if (isMaskName(array.name)) continue;
        vtkDataArray* const own = findArray(block, array.name, array.onPoints);
        vtkSmartPointer<vtkFloatArray> values;
        if (own && own->GetNumberOfComponents() == array.components) {
            values = toFloats(own);
        } else {
            values = floatArray(array.name, array.components,
                                std::size_t(array.onPoints ? block.GetNumberOfPoints() : block.GetNumberOfCells()));
            values->FillValue(std::nanf(""));
        }
        attributesOf(block, array.onPoints)->AddArray(values);
    }
}

}  // namespace aeolic
