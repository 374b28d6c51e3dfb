#pragma once

#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkPolyData.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace aeolic {

/// VTK's number of a cell's type as the byte it is kept in. Throws InputError, which begins with `path` and says the
/// number as it was found, for one that VTK has no cell for.
unsigned char cellTypeOf(std::int64_t type, std::int64_t cell, const std::string& path);

/// VTK's filters trust files blindly. Throws InputError, which begins with `where` and names the first bad cell, unless
/// every cell of the array refers to points that there are. `kind`: what these cells are called. Parallel.
void requireSoundCells(vtkCellArray& cells, vtkIdType points, const std::string& where, std::string_view kind = "cell");
/// Throws InputError, which begins with `where`, unless the vertices, lines, polygons and strips of `polyData` refer to
/// points that it has.
void requireSoundCells(vtkPolyData& polyData, const std::string& where);

/// Throws InputError, which begins with `path`, unless every array has a tuple for
/// each point or cell, every cell refers to points that there are, and has a type and as many corners as that needs.
/// Blocks of a multi-block data set are judged one by one.
void requireSoundData(vtkDataObject& data, const std::string& path);

}  // namespace aeolic
