#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>

#include "data/progress.h"

namespace aeolic {

/// Reads a legacy VTK file (.vtk) of polygons or a grid, in text or binary, with all its arrays. Throws InputError,
/// which begins with the file's name.
vtkSmartPointer<vtkDataObject> readLegacy(const std::string& path, const ProgressReport& progress);

}  // namespace aeolic
