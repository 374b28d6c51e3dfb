#pragma once

#include <cstdint>
#include <string>

namespace aeolic {

/// VTK takes what is left of an STL file that was cut off for a smaller surface. Throws InputError unless the file is
/// as long as its header says, or is text with a last line.
void checkStl(const std::string& path, std::uint64_t fileBytes);

}  // namespace aeolic
