#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace aeolic {

/// VTK's readers take the rest of a file that was cut off for a smaller surface, fill a field with zeros, crash, or
/// wait for ever. Throws InputError unless the file is as long as its header demands (.stl), its header and the sizes
/// in it are sound (NRRD, the XML formats, pieces and blocks in other files included), or what it refers to is there
/// (.obj). Others pass: our own readers notice. Returns how many bytes reading it takes at least.
std::uint64_t checkComplete(const std::string& path, const std::string& extension, std::uint64_t fileBytes);

/// The files that a parallel file names as its pieces, in order. Throws InputError where one is not there.
std::vector<std::string> pieceFilesOf(const std::string& path);

}  // namespace aeolic
