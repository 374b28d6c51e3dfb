#pragma once

#include <vtkAppendFilter.h>

#include <string>
#include <vector>

#include "reader/openfoam/foam_case.h"

namespace aeolic {

/// All cells of one folder, of all its regions, appended to `append`. `polyhedra`: they stay whole.
using ReadFoamFolder = void (*)(const FoamCase& foam, const std::string& folder, double time,
                                const std::vector<FoamField>& fields, bool polyhedra, vtkAppendFilter& append);

}  // namespace aeolic
