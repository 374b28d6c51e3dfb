#pragma once

#include <vtkDataObject.h>

#include <string>

namespace aeolic {

/// The array of the degrees of Lagrange cells, as VTK's writers call it.
inline constexpr const char* kHigherOrderDegrees = "HigherOrderDegrees";

/// Cuts the Lagrange cells of an unstructured grid, or of those among blocks, into linear ones between their points,
/// and copies the cells' values. Pyramids, and Bezier cells, whose other points lie beside them, are left with their
/// corners. A cell with a number of points that fits no degree stays as it is. All others, and grids without such
/// cells, are not touched. The cells need not be sound. Throws InputError that begins with `path` where memory is
/// missing.
void makeCellsLinear(vtkDataObject& data, const std::string& path);

}  // namespace aeolic
