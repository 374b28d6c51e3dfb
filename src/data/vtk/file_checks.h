#pragma once

#include <cstdint>
#include <string>

namespace aeolic {

/// Throws InputError unless `path` is a file that can be opened and is not empty. Returns its size in bytes.
std::uint64_t checkReadableFile(const std::string& path);

/// STL and PLY state in their header how much follows, but VTK's readers take a shorter file for a smaller surface, or
/// what lies behind the end for points. Throws InputError if the file is shorter than its header demands, or the header
/// itself is not one. `extension` is ".stl" or ".ply"; others pass.
void checkDeclaredSize(const std::string& path, const std::string& extension, std::uint64_t fileBytes);

}  // namespace aeolic
