#pragma once

#include <vtkDataSet.h>

#include <string>
#include <vector>

#include "data/file_summary.h"
#include "data/progress.h"
#include "data/vtk/arrays.h"

namespace aeolic {

/// Reads all of the file; of a case no more than its patches, at its first time. Throws the InputError that loading
/// would throw.
FileSummary summaryOf(const std::string& path, const ProgressReport& progress);

/// That of an OpenFOAM case: of its patches at its first time, and of each field at the first time that has it. The
/// cells are not read. Throws InputError.
FileSummary summaryOfFoam(const std::string& path, const ProgressReport& progress);

/// Enters a data set's points, cells, bounds and arrays.
void addDataSet(vtkDataSet& data, FileSummary& summary);

/// Enters which of the arrays is drawn where none is named, and which could be.
void chooseDefaultVectors(const std::vector<ArrayInfo>& arrays, FileSummary& summary);

}  // namespace aeolic
