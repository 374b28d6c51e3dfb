#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <string>
#include <vector>

#include "data/vtk/arrays.h"
#include "reader/binary/numbers.h"

namespace aeolic {

/// VTK's number for the type.
int vtkTypeOf(NumberType type);

/// Appends those of `more` whose name and place, points or cells, `arrays` does not have.
void addOthers(std::vector<ArrayInfo>& arrays, const std::vector<ArrayInfo>& more);

/// An array whose values are not set yet.
vtkSmartPointer<vtkFloatArray> floatArray(const std::string& name, int components, std::size_t tuples);

/// Values as an array of VTK's class `Array`, which has numbers of their size.
template <class Array, class Number>
vtkSmartPointer<Array> arrayOf(const std::string& name, int components, const std::vector<Number>& values)
{
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(vtkIdType(values.size()) / components);
    std::ranges::copy(values, array->GetPointer(0));
    return array;
}

/// Puts a block of this name behind the others.
void addBlock(vtkMultiBlockDataSet& blocks, vtkDataObject* data, const std::string& name);

/// Gives a block all these arrays as floats. Blocks are put together, where VTK drops arrays that differ in type. A
/// block that has no such array, or one of other components, gets one of NaN.
void unifyArrays(vtkDataSet& block, const std::vector<ArrayInfo>& kept);

}  // namespace aeolic
