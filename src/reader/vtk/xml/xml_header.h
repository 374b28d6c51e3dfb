#pragma once

#include <vtkDataArray.h>
#include <vtkXMLDataElement.h>

#include <cstdint>
#include <istream>
#include <string>

namespace aeolic {

/// What VTK 9.1 would read as something else than the file says, in words for a message; empty where there is nothing.
/// VTK takes 0 or 1 for an origin or spacing that it cannot read. It makes the arrays as the first piece has them, and
/// fills them by their places. It leaves memory as it is where no piece covers a part of the grid, and where an array
/// has no values for a step of time.
std::string faultOf(vtkXMLDataElement& primary);

/// That of the origin and spacing alone.
std::string faultOfPlace(vtkXMLDataElement& primary);

/// Where the last byte of the array's values is among them, from 0. It has `values` of them at least; all that its
/// piece of a grid has where that is said. -1: it has none.
std::int64_t lastByte(vtkXMLDataElement& element, vtkDataArray& array, std::int64_t values);

/// How many bytes the base64 within an array's element has behind the word that counts them.
std::int64_t bytesWithin(vtkXMLDataElement& element, std::istream& file);

/// False where these are types of cells, and one is no byte: VTK would take its lowest bits. Other arrays may have any
/// values.
bool areCellTypes(vtkXMLDataElement& element, vtkDataArray& values);

}  // namespace aeolic
