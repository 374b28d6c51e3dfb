#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace aeolic {

/// VTK's readers take what is left of a file that was cut off for a smaller surface, fill a field with zeros, crash, or
/// wait for ever. These throw InputError unless the file is as long as its header demands (STL), or its header and the
/// sizes in it are sound (NRRD, the XML formats, pieces in other files included). They return how many bytes reading it
/// takes at least.
std::uint64_t checkStl(const std::string& path, std::uint64_t fileBytes);
std::uint64_t checkNrrd(const std::string& path, std::uint64_t fileBytes);
std::uint64_t checkXml(const std::string& path, std::uint64_t fileBytes);

/// The files that a parallel file names as its pieces, in order. Throws InputError where one is not there.
std::vector<std::string> pieceFilesOf(const std::string& path);

}  // namespace aeolic
