#pragma once

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace aeolic {

/// Which cells of a data set are shells: faces that stand beside cells that fill space. A face with the corners of one
/// of those cells belongs to its boundary and is no shell. Empty where there is none, or where nothing fills space.
std::vector<char> shellCells(vtkDataSet& data);

/// The outer surface of a data set with shells. These have points of their own; everywhere else the arrays on the
/// points are NaN. So the values of shells are known from what is to be looked up in the cells that fill space.
/// `shells`: as shellCells() returns them, not empty. Throws InputError that begins with `where`.
vtkSmartPointer<vtkPolyData> boundaryWithShells(vtkDataSet& data, const std::vector<char>& shells,
                                                const std::string& where);

}  // namespace aeolic
