#pragma once

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>

#include "aeolic/data.h"

namespace aeolic {

/// The caller's volume as VTK's cells, whose arrays are the caller's memory where they can be (memory_arrays.h).
/// Messages begin with `name`. Throws InputError.
vtkSmartPointer<vtkUnstructuredGrid> cellsFromMemory(const Volume& volume, const std::string& name);

}  // namespace aeolic
