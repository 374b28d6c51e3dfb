#pragma once

#include <vtkDataObject.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace aeolic {

/// The array of the degrees of Lagrange cells, as VTK's writers call it.
inline constexpr const char* kHigherOrderDegrees = "HigherOrderDegrees";

/// Cuts the Lagrange cells of an unstructured grid, or of those among blocks, into linear ones between their points,
/// and copies the cells' values. Pyramids, and Bezier cells, whose other points lie beside them, are left with their
/// corners. A cell with a number of points that fits no degree stays as it is. All others, and grids without such
/// cells, are not touched. The cells need not be sound. Throws InputError that begins with `path` where memory is
/// missing.
void makeCellsLinear(vtkDataObject& data, const std::string& path);

/// How a Lagrange cell is cut into linear ones between its points.
struct LagrangeCut {
    int vtkType = 0;  ///< Of the linear cells.
    std::size_t corners = 0;
    std::vector<vtkIdType> points;  ///< [cells * corners] Which of the cell's own points they have.
};

/// The cut of a Lagrange cell of a VTK type with so many points. `degrees`: along its axes; zeros: the same along all,
/// which the number of points tells. Of a Bezier cell and of a pyramid it is the cell between its corners. Nothing
/// where the type is another, or where the number of points fits no degree up to 10.
std::optional<LagrangeCut> lagrangeCut(int vtkType, vtkIdType points, const std::array<int, 3>& degrees);

}  // namespace aeolic
