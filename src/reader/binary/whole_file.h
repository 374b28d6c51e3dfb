#pragma once

#include <string>

namespace aeolic {

/// The bytes of a file. Throws InputError, which begins with `path`, where it cannot be read, or where there is no
/// memory for it and for as much again as is made of it.
std::string wholeFile(const std::string& path);

}  // namespace aeolic
