#pragma once

#include <cstdint>
#include <string>

namespace aeolic {

/// VTK's readers of the XML family believe counts, extents, offsets and the sizes of blocks, and then crash, wait for
/// ever or take memory for them. Throws InputError unless those of the file agree with each other and with its
/// content, those of its pieces and blocks too. Reads headers, and of the values only the ends of cells and polyhedra.
/// Returns how many bytes the arrays take in memory: where they are compressed, many times the bytes on disk.
std::uint64_t checkXmlFile(const std::string& path);

}  // namespace aeolic
