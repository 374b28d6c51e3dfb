#pragma once

#include <vtkDataSet.h>

#include <cstddef>
#include <functional>
#include <vector>

#include "base/bounds.h"
#include "data/cells/cell_tree.h"
#include "data/cells/left_out.h"
#include "data/cells/near_surface.h"

namespace aeolic {

/// The boxes around a data set's cells. Any thread may ask, as long as the data set stays as it is.
std::function<Bounds(std::size_t cell)> cellBoxesOf(vtkDataSet& data);

/// Cells one after the other in a data set. In most files they are neighbours, so a surface is far from most runs.
struct CellRun {
    static constexpr std::size_t kCells = 32;

    CellTree::Box middles;               ///< Around the middles of the cells' boxes, where these are finite.
    double leastDiagonal, mostDiagonal;  ///< Of those boxes; infinite and negative where there is none.
};

struct CellRuns {
    std::vector<CellRun> runs;
    Bounds bounds;  ///< Around all boxes that are finite.
};

/// Cost: one parallel pass over the cells, and 1.25 bytes a cell.
CellRuns runsOfCells(vtkDataSet& data);

/// A box with an inside, none of whose sides is infinitely far.
bool isFinite(const Bounds& box);

/// Cells near a surface: CellVolume::near().
struct NearCells {
    std::vector<char> chosen;  ///< [cells] 1 for those that are near.
    LeftOut leftOut;           ///< The others.
};

/// `runs`: of the data set. Parallel. Cost: a short search for each run, and more for the cells of those runs alone
/// that may have one that is near.
NearCells nearCellsOf(vtkDataSet& data, const CellRuns& runs, NearSurface& surface, double diagonals);

}  // namespace aeolic
