#pragma once

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "aeolic/surface_spec.h"
#include "data/vtk/surface/cut_outline.h"

namespace aeolic {

/// `contourArray`: the point array of one component that an isosurface is cut by. Cost of an isosurface's: a pass over
/// the cells.
CutOutline outlineOfCut(vtkDataSet& data, const SurfaceSpec& spec, const std::string& contourArray);

/// Cuts a surface out of a data set, or of a piece of one. Image data (a uniform grid) gives the geometry alone,
/// because the field is sampled on it in 3D later. Slice and boundary are then coarse, of at most 32 cells in each
/// direction. They lie 1/1000 of a cell inside the bounds, where no rounding can put a pixel outside the field. Any
/// other data set gives its cells' own cut with interpolated point arrays, and perhaps no polygon. (Isosurfaces of a
/// uniform grid: data/vtk/surface/isosurface.h.) Throws InputError for cells that are not sound.
vtkSmartPointer<vtkPolyData> cutSurface(vtkDataSet& data, const SurfaceSpec& spec, const std::string& contourArray,
                                        const std::string& where, const CutOutline& all);

}  // namespace aeolic
