#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "reader/binary/numbers.h"

namespace aeolic {

struct PlyProperty {
    std::string name;
    NumberType type = NumberType::float32;  ///< The value's type, or that of the list's entries.
    bool isList = false;
    NumberType countType = NumberType::uint8;  ///< The type of the list's length.
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
