#pragma once

#include <cstdint>
#include <string>

#include "reader/vtk/checks/xml_values.h"

namespace aeolic {

/// Throws InputError unless the piece has `count` offsets and as many corners as the last of them says.
void checkXmlCells(XmlValues& values, vtkXMLDataElement& piece, const std::string& group, std::uint64_t count,
                   std::uint64_t points);

/// Throws InputError unless the faces of each polyhedron are within the array of faces, and their corners are points.
void checkXmlPolyhedra(XmlValues& values, vtkXMLDataElement& piece, std::uint64_t cells, std::uint64_t points);

}  // namespace aeolic
