#pragma once

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "aeolic/data.h"

namespace aeolic {

/// The caller's grid as image data, whose arrays are the caller's memory where they can be (memory_arrays.h). Messages
/// begin with `name`. Throws InputError.
vtkSmartPointer<vtkImageData> imageFromMemory(const Grid& grid, const std::string& name);

/// The caller's volume as VTK's unstructured, structured or rectilinear grid. Its arrays are the caller's memory where
/// they can be. Throws InputError, which begins with `name`.
vtkSmartPointer<vtkDataSet> cellsFromMemory(const Volume& volume, const std::string& name);

}  // namespace aeolic
