#pragma once

#include <vtkDataSet.h>

#include <vector>

#include "data/vtk/arrays.h"

namespace aeolic {

/// Gives a block all these arrays as floats. Blocks are put together, where VTK drops arrays that differ in type. A
/// block that has no such array, or one of other components, gets one of NaN.
void unifyArrays(vtkDataSet& block, const std::vector<ArrayInfo>& kept);

}  // namespace aeolic
