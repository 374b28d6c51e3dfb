#pragma once

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "description/surface_spec.h"

namespace aeolic {

/// Cuts surfaces out of a data set. Of image data (a uniform grid) the geometry only: the field is sampled on it in 3D
/// later, so slice and boundary are coarse, of at most 32 cells in each direction, and lie 1/1000 of a cell inside the
/// bounds, where no rounding can put a pixel outside the field. Of anything else the cells' own cut with interpolated
/// point arrays. `contourArray` is the name of a point array of one component. (Isosurfaces of a uniform grid:
/// data/vtk/isosurface.h.) Throws InputError where there is nothing: `where` (the file's name) stands in front, the
/// range or bounds are named.
vtkSmartPointer<vtkPolyData> cutSurface(vtkDataSet& data, const SurfaceSpec& spec, const std::string& contourArray,
                                        const std::string& where);

}  // namespace aeolic
