#pragma once

#include <vtkPolyData.h>

#include <string>

#include "data/loaded_surface.h"
#include "data/vtk/arrays.h"

namespace aeolic {

/// An array of cells by this name says where a piece's polygons stand among those of all pieces (SurfaceMesh::order).
inline constexpr const char* kTrianglesPlaces = "aeolic: places of polygons";

/// Tells the surface what it is coloured by.
void tellColors(const ScalarChoice& scalar, LoadedSurface& surface);

/// A surface from polygons, to be finished. Cells with points that are not finite are dropped and counted; points left
/// without triangles are dropped as well. A surface that was `cutOut` of a grid has triangles without an area by design
/// (at masked values, where the grid's points lie on it) and does not count them. Messages begin with `path`, errors
/// with `path` and `pieces`: which pieces of the file these are. The polydata's arrays may change: masked values become
/// NaN. Throws InputError if there is no triangle, or indices point nowhere.
LoadedSurface meshFromPolyData(vtkPolyData& polyData, const std::string& path, const SurfaceArrays& arrays,
                               bool cutOut = false, const std::string& pieces = "");

}  // namespace aeolic
