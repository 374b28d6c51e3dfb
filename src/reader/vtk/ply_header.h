#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace aeolic {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

int bytesOf(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;  ///< The value's type, or that of the list's entries.
    bool isList = false;
    PlyType countType = PlyType::uint8;  ///< The type of the list's length.
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    enum class Format { text, littleEndian, bigEndian } format = Format::text;
    std::vector<PlyElement> elements;
};

/// Reads up to and including the line 'end_header'. Throws InputError naming `path` and the line that makes no sense.
PlyHeader readPlyHeader(std::istream& file, const std::string& path);

}  // namespace aeolic
