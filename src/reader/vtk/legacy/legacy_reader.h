#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>

#include "data/progress.h"

namespace aeolic {

/// Reads a legacy VTK file (The VTK User's Guide, "VTK File Formats"; versions 1 to 5.1), text or binary: structured
/// points, a structured, rectilinear or unstructured grid, or polygons, with the attributes of points and cells. The
/// first of each kind becomes the active one. Arrays of text are skipped.
///
/// Our own, because VTK 9.1's reader takes memory for any count, copies names into memory of a fixed size, and makes
/// cells of numbers that it did not check. Throws InputError where the file ends early or a number makes no sense.
vtkSmartPointer<vtkDataObject> readLegacy(const std::string& path, const ProgressReport& progress);

}  // namespace aeolic
