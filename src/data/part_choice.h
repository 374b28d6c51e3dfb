#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace aeolic {

/// A part of a file of several: a patch, a block.
struct PartName {
    std::string name;                 ///< "terrain", or "air/walls/left" where parts stand in others.
    std::vector<std::string> groups;  ///< Other names that it goes by together with others.
};

/// A file, and which of its parts are wanted.
struct FileAndParts {
    std::string file;
    std::vector<std::string> parts;  ///< Names, groups and patterns with *; empty: the usual ones.
};

/// "CASE:PART,PART" in two. A colon belongs to the file's name where such a file is there, or nothing stands before it.
/// Behind a file that is there colons belong to the names of parts.
FileAndParts splitParts(const std::string& spec);

/// The numbers of the parts that any of `wanted` names, increasing. A name without '/' may stand for the end of a
/// part's name behind a '/'. Several that follow each other count as one with commas where a part is called so. Throws
/// InputError, which begins with `where`, for one that matches none.
std::vector<std::size_t> chooseParts(const std::vector<PartName>& parts, const std::vector<std::string>& wanted,
                                     const std::string& where);

}  // namespace aeolic
