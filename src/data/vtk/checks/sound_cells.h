#pragma once

#include <vtkCellArray.h>

namespace aeolic {

/// Whether every cell of the array refers to existing points: VTK's filters trust files blindly. Parallel.
bool cellsAreSound(vtkCellArray& cells, vtkIdType points);

}  // namespace aeolic
