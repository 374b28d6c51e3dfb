#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "data/reading/questions.h"

namespace aeolic {

/// The counts in the header of a surface's file: of VTK's XML, of PLY, of binary STL; nothing where it tells none. They
/// throw InputError for a file that cannot be read.
std::optional<SurfaceCounts> countsOfXml(const std::string& path);
std::optional<SurfaceCounts> countsOfPly(const std::string& path);
std::optional<SurfaceCounts> countsOfStl(const std::string& path);

/// VTK takes what is left of an STL file that was cut off for a smaller surface. Throws InputError unless the file is
/// as long as its header says, or is text with a last line.
void checkStl(const std::string& path, std::uint64_t fileBytes);

}  // namespace aeolic
