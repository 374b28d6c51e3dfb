#pragma once

#include <cstdint>
#include <string>

namespace aeolic {

/// Walks through a PLY file by what its header declares and throws InputError where it ends too early or a list's length
/// makes no sense. VTK's reader frees memory twice on such files. Cost: one buffered pass.
void checkPly(const std::string& path);

}  // namespace aeolic
