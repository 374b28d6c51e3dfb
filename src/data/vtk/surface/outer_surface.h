#pragma once

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace aeolic {

/// The faces of a data set's cells that no other cell has, and its flat cells, with the values at their points and in
/// the cells behind them: what vtkDataSetSurfaceFilter gives. Grids of usual cells take a small part of its time and
/// memory (outer_faces.h). Throws InputError, which begins with `where`, for cells that are not sound.
vtkSmartPointer<vtkPolyData> outerSurface(vtkDataSet& data, const std::string& where);

/// Which of the data set's points that surface has, in its order.
std::vector<vtkIdType> outerPoints(vtkDataSet& data, const std::string& where);

}  // namespace aeolic
