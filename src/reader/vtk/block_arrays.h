#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "data/vtk/arrays.h"
#include "reader/binary/numbers.h"

namespace aeolic {

/// VTK's number for the type.
int vtkTypeOf(NumberType type);

/// Whether one of the arrays has this name on points, or on cells.
bool isAmong(const std::vector<ArrayInfo>& arrays, const std::string& name, bool onPoints);

/// Puts those arrays behind the others whose name is not among them.
void addOthers(std::vector<ArrayInfo>& arrays, const std::vector<ArrayInfo>& more);

/// An array whose values are not set yet.
vtkSmartPointer<vtkFloatArray> floatArray(const std::string& name, int components, std::size_t tuples);

/// Puts a block of this name behind the others.
void addBlock(vtkMultiBlockDataSet& blocks, vtkDataObject* data, const std::string& name);

vtkDataSetAttributes& valuesOf(vtkDataSet& data, bool onPoints);

/// Gives a block all these arrays as floats. Blocks are put together, where VTK drops arrays that differ in type. A
/// block that has no such array, or one of other components, gets one of NaN.
void unifyArrays(vtkDataSet& block, const std::vector<ArrayInfo>& kept);

}  // namespace aeolic
