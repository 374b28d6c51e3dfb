#pragma once

#include <cstdint>
#include <string>

namespace aeolic {

/// Whether `path` is a folder, or ends in .foam or .openfoam: then it names an OpenFOAM case, or fails to.
bool namesFoamCase(const std::string& path);

/// Whether `path` ends like the name of an EnSight case file.
bool namesEnSightCase(const std::string& path);

/// Throws InputError unless `path` is a file that can be opened and is not empty. Returns its size in bytes.
std::uint64_t checkReadableFile(const std::string& path);

}  // namespace aeolic
