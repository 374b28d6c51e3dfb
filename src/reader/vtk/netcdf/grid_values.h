#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reader/netcdf/netcdf_file.h"
#include "reader/vtk/netcdf/grid_places.h"
#include "reader/vtk/netcdf/grid_variables.h"

namespace aeolic {

/// A slab of a variable's values as floats: unpacked (scale_factor, add_offset), NaN where they are missing
/// (_FillValue, missing_value, valid_range, valid_min, valid_max). CF conventions 1.11, sections 2.5.1 and 8.1.
std::vector<float> unpackedValues(const NetcdfFile& file, const std::string& variable, const Slab& slab);

/// The values of a variable on a grid's points, x fastest, in the order of the places. `step`: of its time. What stands
/// half a cell beside them is the mean of two neighbours, and what has no z is the same in each layer. Throws
/// InputError.
std::vector<float> valuesOnGrid(const NetcdfFile& file, const GridVariable& variable, const GridAxes& axes,
                                const GridPlaces& places, std::size_t step);

/// Whether the values of a variable on `from` can be had on `to`.
bool canStandOn(const NetcdfFile& file, const GridAxes& from, const GridAxes& to);

/// Three components for each point. Of places in degrees the direction is that on the map, on which the parallels are
/// as long as the equator; the length stays.
std::vector<float> vectorsOnGrid(const NetcdfFile& file, const GridVariables& all, const GridVector& vector,
                                 const GridAxes& axes, const GridPlaces& places, const std::vector<std::size_t>& steps);

}  // namespace aeolic
