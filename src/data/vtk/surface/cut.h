#pragma once

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "description/surface_spec.h"

namespace aeolic {

/// Cuts a surface out of a data set. Image data (a uniform grid) gives the geometry alone, because the field is sampled
/// on it in 3D later. Slice and boundary are then coarse, of at most 32 cells in each direction. They lie 1/1000 of a
/// cell inside the bounds, where no rounding can put a pixel outside the field. Any other data set gives its cells' own
/// cut with interpolated point arrays. `contourArray` is the name of a point array of one component. (Isosurfaces of a
/// uniform grid: data/vtk/surface/isosurface.h.)
/// Throws InputError where nothing is cut. It begins with `where`, the file's name, and names the range or the bounds.
vtkSmartPointer<vtkPolyData> cutSurface(vtkDataSet& data, const SurfaceSpec& spec, const std::string& contourArray,
                                        const std::string& where, int ranksOnHost);

}  // namespace aeolic
