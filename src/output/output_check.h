#pragma once

#include <string>

namespace aeolic {

/// Throws InputError for a path that no file can have: an empty one, or one with a byte of 0.
void checkFileName(const std::string& path);

/// Checks before the work that a file can be written there: nobody should learn after an hour of loading that it
/// cannot. Creates nothing. Throws InputError naming the path: its folder does not exist or is not writable, or the
/// path is a folder, a device or a read-only file.
void checkWritable(const std::string& path);

/// Writes a whole file as a NewFile: afterwards `path` is complete, or what it was before. Throws std::runtime_error
/// naming the path.
void writeTextFile(const std::string& path, const std::string& text, bool mayBeNameless = true);

}  // namespace aeolic
