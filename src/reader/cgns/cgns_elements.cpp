#include "reader/cgns/cgns_elements.h"

namespace aeolic {
namespace {

using Shape = CellShape;

/// "Standard Interface Data Structures", section 7.3; numbers as in cgnslib.h.
constexpr CgnsElement elements[] = {
    {2, 1, 0, Shape::triangle},      {3, 2, 1, Shape::triangle},     {4, 3, 1, Shape::triangle},
    {5, 3, 2, Shape::triangle},      {6, 6, 2, Shape::triangle},     {7, 4, 2, Shape::quad},
    {8, 8, 2, Shape::quad},          {9, 9, 2, Shape::quad},         {10, 4, 3, Shape::tetra},
    {11, 10, 3, Shape::tetra},       {12, 5, 3, Shape::pyramid},     {13, 14, 3, Shape::pyramid},
    {14, 6, 3, Shape::wedge},        {15, 15, 3, Shape::wedge},      {16, 18, 3, Shape::wedge},
    {17, 8, 3, Shape::hexahedron},   {18, 20, 3, Shape::hexahedron}, {19, 27, 3, Shape::hexahedron},
    {21, 13, 3, Shape::pyramid},     {24, 4, 1, Shape::triangle},    {25, 9, 2, Shape::triangle},
    {26, 10, 2, Shape::triangle},    {27, 12, 2, Shape::quad},       {28, 16, 2, Shape::quad},
    {29, 16, 3, Shape::tetra},       {30, 20, 3, Shape::tetra},      {31, 21, 3, Shape::pyramid},
    {32, 29, 3, Shape::pyramid},     {33, 30, 3, Shape::pyramid},    {34, 24, 3, Shape::wedge},
    {35, 38, 3, Shape::wedge},       {36, 40, 3, Shape::wedge},      {37, 32, 3, Shape::hexahedron},
    {38, 56, 3, Shape::hexahedron},  {39, 64, 3, Shape::hexahedron}, {40, 5, 1, Shape::triangle},
    {41, 12, 2, Shape::triangle},    {42, 15, 2, Shape::triangle},   {43, 16, 2, Shape::quad},
    {44, 25, 2, Shape::quad},        {45, 22, 3, Shape::tetra},      {46, 34, 3, Shape::tetra},
    {47, 35, 3, Shape::tetra},       {48, 29, 3, Shape::pyramid},    {49, 50, 3, Shape::pyramid},
    {50, 55, 3, Shape::pyramid},     {51, 33, 3, Shape::wedge},      {52, 66, 3, Shape::wedge},
    {53, 75, 3, Shape::wedge},       {54, 44, 3, Shape::hexahedron}, {55, 98, 3, Shape::hexahedron},
    {56, 125, 3, Shape::hexahedron},
};

}  // namespace

const CgnsElement* findCgnsElement(std::int64_t type)
{
    for (const CgnsElement& element : elements)
        if (element.type == type) return &element;
    return nullptr;
}

}  // namespace aeolic
