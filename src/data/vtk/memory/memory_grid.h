#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "aeolic/data.h"

namespace aeolic {

/// The caller's grid as image data, whose arrays are the caller's memory where they can be (memory_arrays.h). Messages
/// begin with `name`. Throws InputError.
vtkSmartPointer<vtkImageData> imageFromMemory(const Grid& grid, const std::string& name);

}  // namespace aeolic
