#pragma once

#include <string>

#include "data/loaded_surface.h"
#include "data/progress.h"

namespace aeolic {

/// Reads .vtp .pvtp .vtm .stl .ply .obj .vtk: polygons and strips of any kind as triangles, blocks appended to one
/// another. A .pvtp that is split gives this part's pieces alone, which placePiece() then puts in their place: their
/// triangles are those of the whole, in its order, with the same bits. Throws InputError.
LoadedSurface readSurfaceFile(const std::string& path, const SurfaceArrays& arrays, const ProgressReport& progress);

}  // namespace aeolic
