#pragma once

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "data/loaded_surface.h"
#include "data/vtk/arrays.h"

namespace aeolic {

/// The arrays, and vectors that can be put together of three of them with one component each, "u v w", "X Velocity …",
/// "vel_0 …" (data/vector_names.h), which stay what they are. Where no array has three components, two will do, which
/// is enough in flat data.
std::vector<ArrayInfo> withJoined(std::vector<ArrayInfo> arrays);

/// The arrays that a file has to give for these.
std::vector<ArrayInfo> arraysToRead(const std::vector<ArrayInfo>& arrays);

/// Makes arrays of the data of those that are put together of others, and of `vectors` with two components such with
/// three: flat data have none across. Throws InputError that begins with `path` where the data are not flat then. What
/// is not there is left out.
void makeVectors(vtkDataSet& data, const std::vector<ArrayInfo>& arrays, const ArrayInfo* vectors,
                 const std::string& path);

/// The polydata with vectors of three components where its own are to be put together of scalars, or have two in flat
/// data; else itself. `wanted` has their name then. Throws InputError that begins with `where`.
vtkSmartPointer<vtkPolyData> withVectors(vtkPolyData& input, SurfaceArrays& wanted, const std::string& where);

/// The axis that the data lie across; nothing where they are not flat in one.
std::optional<int> flatAxisOf(vtkDataSet& data);

}  // namespace aeolic
