#pragma once

#include <vtkDataSet.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSmartPointer.h>

#include <string>

namespace aeolic {

/// All cells of the blocks that fill space, as one grid; points at the same place are one. Where none does, the grids
/// of faces. Throws InputError, which begins with `path`, where there are none of these either.
vtkSmartPointer<vtkDataSet> volumeOf(vtkMultiBlockDataSet& blocks, const std::string& path);

}  // namespace aeolic
