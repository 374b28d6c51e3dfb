#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "data/progress.h"

namespace aeolic {

/// Reads a Wavefront OBJ file: vertices, faces, and normals where every face has them, or none and there are as many
/// as vertices. A corner with a normal or a texture of another number than its vertex makes every corner a point of its
/// own. Groups and materials of the faces become arrays of numbers. Lines, points and textures are skipped.
///
/// Throws InputError, which names the line, where a vertex has no three numbers or a face refers to what is not there.
vtkSmartPointer<vtkPolyData> readObj(const std::string& path, const ProgressReport& progress);

}  // namespace aeolic
