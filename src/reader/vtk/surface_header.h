#pragma once

#include <optional>
#include <string>

#include "data/reading/questions.h"

namespace aeolic {

/// The counts in the header of a surface's file (.vtp, .ply, binary .stl); nothing for other files. Throws InputError
/// for a file that cannot be read.
std::optional<SurfaceCounts> countsInHeader(const std::string& path);

}  // namespace aeolic
