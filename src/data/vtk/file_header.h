#pragma once

#include <vtkAlgorithm.h>

#include <string>
#include <vector>

#include "data/vtk/arrays.h"

namespace aeolic {

/// The arrays of which a reader of the XML family, or of NRRD, tells before it reads them; its information is up to
/// date.
std::vector<ArrayInfo> announcedArrays(vtkAlgorithm& reader);

/// Throws InputError for an NRRD file whose header VTK would take for another than it is. Reads the header again.
void checkNrrdHeader(const std::string& path, vtkAlgorithm& reader);

}  // namespace aeolic
