#pragma once

#include <vtkCellArray.h>
#include <vtkPolyData.h>

#include <string>
#include <string_view>

namespace aeolic {

/// VTK's filters trust files blindly. Throws InputError, which begins with `where` and names the first bad cell, unless
/// every cell of the array refers to points that there are. `kind`: what these cells are called. Parallel.
void requireSoundCells(vtkCellArray& cells, vtkIdType points, const std::string& where, std::string_view kind = "cell");
/// Throws the same unless the vertices, lines, polygons and strips of `polyData` refer to points that it has.
void requireSoundCells(vtkPolyData& polyData, const std::string& where);

}  // namespace aeolic
