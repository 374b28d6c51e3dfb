#pragma once

#include <istream>
#include <string>

namespace aeolic {

/// VTK's reader looks up texture coordinates and normals wherever a face says, and puts lines into memory of a fixed
/// size. Throws InputError, which begins with `path`, unless all that faces, lines and points refer to is there.
void checkObj(std::istream& file, const std::string& path);

}  // namespace aeolic
