#pragma once

#include <cstdint>
#include <string_view>

namespace aeolic {

/// What a cell is once the points between its corners are left out.
enum class EnSightShape { point, line, triangle, quad, polygon, tetra, pyramid, wedge, hexahedron, polyhedron };

struct EnSightElement {
    std::string_view name;
    EnSightShape shape;
    std::uint32_t nodes, corners;  ///< In the file and of the shape; 0 where each element has its own number.
    int dimension;                 ///< 3: it fills space.
};

/// Null for an unknown name. The elements of ghosts ("g_hexa8") have the row of the others.
const EnSightElement* findEnSightElement(std::string_view name);

inline bool isEnSightGhost(std::string_view name)
{
    return name.starts_with("g_");
}

}  // namespace aeolic
