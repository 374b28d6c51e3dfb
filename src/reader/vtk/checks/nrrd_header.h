#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace aeolic {

/// The part of an NRRD header (http://teem.sourceforge.net/nrrd/format.html) that says where values are and how many.
struct NrrdHeader {
    unsigned valueBytes = 0;
    std::vector<std::uint64_t> sizes;    ///< Along each axis, the fastest first. None is 0.
    std::vector<std::string> dataFiles;  ///< As they are written; empty where the values follow the header.
    std::uint64_t headerBytes = 0;       ///< With the blank line.

    std::uint64_t valueCount() const;  ///< At most 2^60.
};

/// Reads up to the blank line, or to the end of the file where the values are in another. Throws InputError, which
/// begins with `path`, for a header that ends early or makes no sense, and for one that VTK's reader reads in another
/// way than it is meant or cannot read: values that are not raw, names of files by pattern, sizes before the dimension.
NrrdHeader readNrrdHeader(std::istream& file, const std::string& path);

/// Throws InputError unless the header is sound and the files hold all of the values.
void checkNrrdFile(const std::string& path);

}  // namespace aeolic
