#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "data/loaded_surface.h"

namespace aeolic {

/// The polydata with vectors of three components where its own are to be put together of scalars, or have two in flat
/// data; else itself. `wanted` has their name then. Throws InputError that begins with `where`.
vtkSmartPointer<vtkPolyData> withVectors(vtkPolyData& input, SurfaceArrays& wanted, const std::string& where);

}  // namespace aeolic
