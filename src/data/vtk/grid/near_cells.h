#pragma once

#include <vtkDataSet.h>

#include <vector>

#include "data/cells/left_out.h"
#include "data/cells/near_surface.h"
#include "data/vtk/grid/cell_boxes.h"

namespace aeolic {

/// Cells near a surface: CellVolume::near().
struct NearCells {
    std::vector<char> chosen;  ///< [cells] 1 for those that are near.
    LeftOut leftOut;           ///< The others.
};

/// `runs`: of the data set. Parallel. Cost: a short search for each run, and more for the cells of those runs alone
/// that may have one that is near.
NearCells nearCellsOf(vtkDataSet& data, const CellRuns& runs, NearSurface& surface, double diagonals);

}  // namespace aeolic
