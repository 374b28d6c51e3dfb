#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>

#include <memory>
#include <string>

#include "data/cells/volume_cells.h"

namespace aeolic {

/// The 3D cells of a data set, with values on its points: `vectors`, and `scalars` unless it is null. Left out are
/// cells that are flat by kind, that ghost flags hide, or that have a corner that is not finite. Cells with curved
/// sides count as the ones with straight sides between their corners. Throws InputError, which begins with `where`, if
/// no cell is left. Cost: one pass over the cells.
std::shared_ptr<VolumeCells> volumeFromGrid(vtkDataSet& data, vtkFloatArray& vectors, vtkFloatArray* scalars,
                                            const std::string& where);

/// Whether any cell of the data set is 3D.
bool hasVolume(vtkDataSet& data);

}  // namespace aeolic
