#pragma once

#include <string>

namespace aeolic {

/// Asks before the work whether a file can be written there, so that nobody loads for an hour and then learns it
/// cannot. Creates nothing. Throws InputError naming the path: its folder does not exist or is not writable, or the
/// path is a folder, a device or a read-only file.
void checkWritable(const std::string& path);

/// Writes a text file whole: to a temporary name beside `path`, renamed when complete.
/// Throws std::runtime_error naming the path; then nothing is left behind.
void writeTextFile(const std::string& path, const std::string& text);

}  // namespace aeolic
