#pragma once

#include <vtkType.h>

#include <array>
#include <optional>
#include <vector>

namespace aeolic {

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

/// Whether it is the type of a Lagrange or Bezier cell.
bool isOfHigherOrder(int vtkType);

}  // namespace aeolic
