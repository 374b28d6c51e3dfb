#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "data/progress.h"

namespace aeolic {

/// Reads a PLY file (Greg Turk, "The PLY Polygon File Format", 1994): text or binary of either byte order. Vertices x,
/// y, z, normals nx, ny, nz, the faces' vertex_indices (or vertex_index); every other number of a vertex or face
/// becomes a float array of its name. Anything else is skipped.
///
/// Our own, alone among the formats, because VTK 9.1's reader frees memory twice or reads outside of it where a file is
/// cut off, lacks a property or has an index out of range. Throws InputError where the file ends early or a number
/// makes no sense.
vtkSmartPointer<vtkPolyData> readPly(const std::string& path, const ProgressReport& progress);

}  // namespace aeolic
