#pragma once

#include <string>
#include <vector>

#include "reader/ensight/ensight_case.h"
#include "reader/ensight/ensight_geometry.h"

namespace aeolic {

/// A variable's values: for each part as many as it has points, or cells that are kept, each of the variable's number
/// of components. NaN where the file says that a value is undefined, or has none. Throws InputError, which begins with
/// the file's name.
std::vector<std::vector<float>> readEnSightValues(const EnSightPlace& place, const EnSightVariable& variable,
                                                  const EnSightGeometry& geometry);

}  // namespace aeolic
