#pragma once

#include <string>

namespace aeolic {

/// Asks before the work whether a file can be written there, so that nobody loads for an hour and then learns it
/// cannot. Creates nothing. Throws InputError naming the path: its folder does not exist or is not writable, or the
/// path is a folder, a device or a read-only file.
void checkWritable(const std::string& path);

/// Writes a file whole: `path` is what it was before, or complete. Where the file system can hold files without a name
/// (Linux's own can, most network file systems cannot) nothing unfinished is left behind, whatever ends the program;
/// elsewhere one that is killed may leave a file ending in .tmp. Throws std::runtime_error naming the path.
void writeTextFile(const std::string& path, const std::string& text);

}  // namespace aeolic
