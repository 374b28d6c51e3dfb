#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "data/vtk/arrays.h"
#include "data/vtk/grid/grid_outline.h"

namespace aeolic {

/// Which of a grid file's arrays are needed, and for what.
struct GridArrays {
    ArrayInfo vectors;
    std::optional<ScalarChoice> scalar;            ///< What is coloured by.
    std::map<std::string, ScalarChoice> contours;  ///< What isosurfaces are cut by, as the request names it.

    std::vector<ArrayInfo> all() const;  ///< Each array once.
    /// What of the vectors the scalar is, where it is computed from the sampled vector. The whole: it is not.
    ArrayPart partOfVectors() const;
};

/// Throws InputError that begins with `path` where there are no such vectors, or no such array for the isosurface. A
/// missing scalar is not an error: the surface may have it.
GridArrays chooseArrays(const std::vector<ArrayInfo>& available, const GridRequest& request, const std::string& path);

/// Throws InputError where one is on the cells: in a brick, cells of others would be needed to bring it to the points.
void requirePoints(const std::vector<ArrayInfo>& arrays, const std::string& path);

}  // namespace aeolic
