#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reader/openfoam/foam_case.h"

namespace aeolic {

/// Throws InputError unless one folder's mesh and these fields' cells are sound: coordinates are finite, corners are
/// below the number of points, every face has an owner, every cell at least four faces, patches lie within the faces,
/// and fields have a value for each cell. Reads all of these files once. Returns the number of cells.
std::uint64_t checkFoamVolume(const std::string& folder, const std::string& region, double time,
                              const std::vector<FoamField>& fields);

}  // namespace aeolic
