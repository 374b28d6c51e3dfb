#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "reader/parts/part_source.h"

namespace aeolic {

/// A kind of element, by CGNS' own number.
struct CgnsElement {
    int type;
    std::int64_t nodes;  ///< In the file.
    int dimension;
    CellShape shape;  ///< Of its corners, which come first. Without meaning where the dimension is below 2.
};

/// "Standard Interface Data Structures", section 7.3; numbers as in cgnslib.h.
inline constexpr CgnsElement kCgnsElements[] = {
    {2, 1, 0, CellShape::triangle},      {3, 2, 1, CellShape::triangle},     {4, 3, 1, CellShape::triangle},
    {5, 3, 2, CellShape::triangle},      {6, 6, 2, CellShape::triangle},     {7, 4, 2, CellShape::quad},
    {8, 8, 2, CellShape::quad},          {9, 9, 2, CellShape::quad},         {10, 4, 3, CellShape::tetra},
    {11, 10, 3, CellShape::tetra},       {12, 5, 3, CellShape::pyramid},     {13, 14, 3, CellShape::pyramid},
    {14, 6, 3, CellShape::wedge},        {15, 15, 3, CellShape::wedge},      {16, 18, 3, CellShape::wedge},
    {17, 8, 3, CellShape::hexahedron},   {18, 20, 3, CellShape::hexahedron}, {19, 27, 3, CellShape::hexahedron},
    {21, 13, 3, CellShape::pyramid},     {24, 4, 1, CellShape::triangle},    {25, 9, 2, CellShape::triangle},
    {26, 10, 2, CellShape::triangle},    {27, 12, 2, CellShape::quad},       {28, 16, 2, CellShape::quad},
    {29, 16, 3, CellShape::tetra},       {30, 20, 3, CellShape::tetra},      {31, 21, 3, CellShape::pyramid},
    {32, 29, 3, CellShape::pyramid},     {33, 30, 3, CellShape::pyramid},    {34, 24, 3, CellShape::wedge},
    {35, 38, 3, CellShape::wedge},       {36, 40, 3, CellShape::wedge},      {37, 32, 3, CellShape::hexahedron},
    {38, 56, 3, CellShape::hexahedron},  {39, 64, 3, CellShape::hexahedron}, {40, 5, 1, CellShape::triangle},
    {41, 12, 2, CellShape::triangle},    {42, 15, 2, CellShape::triangle},   {43, 16, 2, CellShape::quad},
    {44, 25, 2, CellShape::quad},        {45, 22, 3, CellShape::tetra},      {46, 34, 3, CellShape::tetra},
    {47, 35, 3, CellShape::tetra},       {48, 29, 3, CellShape::pyramid},    {49, 50, 3, CellShape::pyramid},
    {50, 55, 3, CellShape::pyramid},     {51, 33, 3, CellShape::wedge},      {52, 66, 3, CellShape::wedge},
    {53, 75, 3, CellShape::wedge},       {54, 44, 3, CellShape::hexahedron}, {55, 98, 3, CellShape::hexahedron},
    {56, 125, 3, CellShape::hexahedron},
};

/// Null for an unknown number, and for MIXED, NGON_n and NFACE_n.
inline const CgnsElement* findCgnsElement(std::int64_t type)
{
    const auto* const found = std::ranges::find(kCgnsElements, type, &CgnsElement::type);
    return found == std::end(kCgnsElements) ? nullptr : found;
}

constexpr std::int64_t kCgnsMixed = 20, kCgnsNgon = 22, kCgnsNface = 23;

}  // namespace aeolic
