#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace aeolic {

/// Throws InputError unless `path` is a file that can be opened and is not empty. Returns its size in bytes.
std::uint64_t checkReadableFile(const std::string& path);

/// VTK's readers take what is left of a file that was cut off for a smaller surface, fill a field with zeros, or crash.
/// Throws InputError unless the file is as long as its header demands (.stl) or ends as it should (the XML formats,
/// pieces and blocks in other files included), or begins as it should (.vtk). Others pass: their readers notice.
void checkComplete(const std::string& path, const std::string& extension, std::uint64_t fileBytes);

/// The files that a parallel file names as its pieces, in order. Throws InputError where one is not there.
std::vector<std::string> pieceFilesOf(const std::string& path);

}  // namespace aeolic
