#pragma once

#include <string>
#include <vector>

#include "data/loaded_surface.h"
#include "data/openfoam/foam_case.h"
#include "data/progress.h"
#include "data/vtk/arrays.h"

namespace aeolic {

/// Patches of an OpenFOAM case as a surface: `arrays.parts`, or all walls. Values stand on the faces, as the solver has
/// them. Reads no more than those patches and the arrays that are wanted. Throws InputError.
LoadedSurface readFoamFile(const std::string& path, const SurfaceArrays& arrays, const ProgressReport& progress);

/// The moment that is read where none is given: the first. 0 where the case has no times.
double firstFoamTime(const FoamCase& foam);

/// The fields as arrays of cells. Those drawn where none is named: `preferred`, else U, where they are vectors.
std::vector<ArrayInfo> foamArrays(const std::vector<FoamField>& fields, const std::string& preferred);

}  // namespace aeolic
