#pragma once

#include <optional>
#include <string>

#include "data/vector_field.h"
#include "data/vtk/grid/grid_request.h"

namespace aeolic {

/// A field's grid before it is read: everything but samples, their longest, and their precision in memory.
struct GridOutline {
    std::optional<GridField> vectors;
    std::optional<GridField> scalar;  ///< To colour by, unless there is none or it is the vectors' own length.
};

/// Of a file of image data that can be sampled as it is, by its header; nothing of other files. Throws InputError.
GridOutline outlineOfGridFile(const std::string& path, const GridRequest& request);

}  // namespace aeolic
