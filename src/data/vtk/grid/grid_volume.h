#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkSmartPointer.h>

#include <mutex>
#include <string>
#include <vector>

#include "data/cells/cell_volume.h"
#include "data/vtk/grid/near_cells.h"

namespace aeolic {

/// The 3D cells of a data set, with values on its points. They stay where they are. Left out are cells that are flat by
/// kind, that ghost flags hide, or that have a corner that is not finite. Cells with curved sides count as the ones
/// with straight sides between their corners.
class GridVolume final : public CellVolume {
public:
    /// `scalars`: null where there is none. `where`: begins messages. Throws InputError for more points than can be
    /// counted.
    GridVolume(vtkSmartPointer<vtkDataSet> data, vtkSmartPointer<vtkFloatArray> vectors,
               vtkSmartPointer<vtkFloatArray> scalars, std::string where);

    /// Throws InputError where memory for that many is missing.
    Shell near(NearSurface& surface, double diagonals) const override;
    std::shared_ptr<const CellVolume> copy() const override;
    std::size_t count() const override { return std::size_t(data_->GetNumberOfCells()); }
    Bounds bounds() const override;
    double maxVector() const override { return longest; }
    bool meansOfCells() const override { return areMeans; }

    double longest = 0;     ///< What maxVector() says.
    bool areMeans = false;  ///< What meansOfCells() says.

private:
    const CellRuns& runs() const;
    VolumeCells cellsOf(const std::vector<char>& chosen) const;

    vtkSmartPointer<vtkDataSet> data_;
    vtkSmartPointer<vtkFloatArray> vectors_, scalars_;
    std::string where_;
    mutable std::once_flag measured_;
    mutable CellRuns runs_;
};

/// Whether any cell of the data set is 3D.
bool hasVolume(vtkDataSet& data);

}  // namespace aeolic
