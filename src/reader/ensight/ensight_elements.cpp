#include "reader/ensight/ensight_elements.h"

namespace aeolic {
namespace {

using Shape = EnSightShape;

constexpr EnSightElement elements[] = {
    {"point", Shape::point, 1, 1, 0},       {"bar2", Shape::line, 2, 2, 1},
    {"bar3", Shape::line, 3, 2, 1},         {"tria3", Shape::triangle, 3, 3, 2},
    {"tria6", Shape::triangle, 6, 3, 2},    {"quad4", Shape::quad, 4, 4, 2},
    {"quad8", Shape::quad, 8, 4, 2},        {"nsided", Shape::polygon, 0, 0, 2},
    {"tetra4", Shape::tetra, 4, 4, 3},      {"tetra10", Shape::tetra, 10, 4, 3},
    {"pyramid5", Shape::pyramid, 5, 5, 3},  {"pyramid13", Shape::pyramid, 13, 5, 3},
    {"penta6", Shape::wedge, 6, 6, 3},      {"penta15", Shape::wedge, 15, 6, 3},
    {"hexa8", Shape::hexahedron, 8, 8, 3},  {"hexa20", Shape::hexahedron, 20, 8, 3},
    {"nfaced", Shape::polyhedron, 0, 0, 3},
};

}  // namespace

const EnSightElement* findEnSightElement(std::string_view name)
{
    if (isEnSightGhost(name)) name.remove_prefix(2);
    for (const EnSightElement& element : elements)
        if (element.name == name) return &element;
    return nullptr;
}

}  // namespace aeolic
