#pragma once

#include <string>

#include "aeolic/data.h"
#include "data/loaded_surface.h"

namespace aeolic {

/// A surface from the caller's memory, to be finished: as readSurfaceFile() makes it of a file with the same polygons
/// and arrays. Where `wanted.part` is split it is one rank's piece, to be placed. Messages begin with `name`. Throws
/// InputError.
LoadedSurface surfaceFromMemory(const Surface& surface, const std::string& name, const SurfaceArrays& wanted);

}  // namespace aeolic
