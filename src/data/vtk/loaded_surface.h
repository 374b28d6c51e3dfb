#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "data/array_choice.h"
#include "data/progress.h"
#include "data/surface_mesh.h"

namespace aeolic {

/// What is wanted of a data set's arrays beside its geometry.
struct SurfaceArrays {
    bool wantVectors = false;
    std::string vectors;  ///< Empty: the active ones, or the only ones.
    std::string colorBy;  ///< NAME or NAME:mag, or empty. Not an error here if there is no such array.
};

struct LoadedSurface {
    SurfaceMesh mesh;         ///< With normals.
    std::string scalarLabel;  ///< Empty: `colorBy` was not found, or not asked for.
    std::string arrays;       ///< What there is, for messages …
    ArrayChoices offered;     ///< … and to choose from.
    std::vector<std::string> warnings;
};

/// Reads .vtp .pvtp .vtm .stl .ply .obj .vtk: polygons and strips of any kind as triangles, blocks appended to one
/// another. Throws InputError. `featureAngleDeg` is for the normals if the file has none.
LoadedSurface readSurfaceFile(const std::string& path, const SurfaceArrays& arrays, double featureAngleDeg,
                              const ProgressReport& progress);

}  // namespace aeolic
