#pragma once

#include <vtkAlgorithm.h>

#include <string>
#include <vector>

#include "data/vtk/arrays.h"

namespace aeolic {

/// The arrays that a reader announces before it reads them: readers of the XML family and of NRRD do. The reader's
/// information must be up to date.
std::vector<ArrayInfo> announcedArrays(vtkAlgorithm& reader);

}  // namespace aeolic
