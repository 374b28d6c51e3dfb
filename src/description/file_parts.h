#pragma once

#include <string>
#include <vector>

namespace aeolic {

/// A file, and which of its parts are wanted.
struct FileAndParts {
    std::string file;
    std::vector<std::string> parts;  ///< Names, groups and patterns with *; empty: the usual ones.
};

/// "CASE:PART,PART" in two. A colon belongs to the file's name where such a file is there, or nothing stands before it.
FileAndParts splitParts(const std::string& spec);

}  // namespace aeolic
