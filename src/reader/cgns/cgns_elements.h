#pragma once

#include <cstdint>

#include "reader/parts/part_source.h"

namespace aeolic {

/// A kind of element, by CGNS' own number.
struct CgnsElement {
    int type;
    std::int64_t nodes;  ///< In the file.
    int dimension;
    CellShape shape;  ///< Of its corners, which come first. Without meaning where the dimension is below 2.
};

/// Null for an unknown number, and for MIXED, NGON_n and NFACE_n.
const CgnsElement* findCgnsElement(std::int64_t type);

constexpr std::int64_t kCgnsMixed = 20, kCgnsNgon = 22, kCgnsNface = 23;

}  // namespace aeolic
