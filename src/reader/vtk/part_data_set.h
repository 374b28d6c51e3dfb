#pragma once

#include <vtkPointSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "reader/parts/part_source.h"

namespace aeolic {

/// A part's cells with the points that they use: polygons where `dimension` is 2, else an unstructured grid. It has all
/// of `arrays`, NaN where the part has none of the name. Of polygons, cells that fill space are left out with their
/// values. Throws InputError, which begins with `where`, for corners that are no points, sizes that do not fit and
/// coordinates that are not finite or beyond 1e30.
vtkSmartPointer<vtkPointSet> dataSetOf(PartMesh part, int dimension, const std::vector<PartArray>& arrays,
                                       const std::string& where);

}  // namespace aeolic
