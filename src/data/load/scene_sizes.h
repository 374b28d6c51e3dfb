#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "data/scene.h"

namespace aeolic {

/// How large a scene's data are: what a device must have room for. Of data that are not read yet what their headers
/// tell.
struct SceneSizes {
    struct Surface {
        std::string name;
        std::uint64_t points = 0, triangles = 0;         ///< points: 0 where it is not told.
        std::uint64_t cellVectors = 0, cellScalars = 0;  ///< As many as triangles, or none.
    };
    std::optional<Surface> surface;
    bool inPieces = false;                        ///< Only a piece of the surface is here.
    std::optional<GridField> field, scalarField;  ///< Without samples; of a field that is split, this part's brick.
};

/// Of a scene in memory.
SceneSizes sizesOf(const Scene& scene);

/// Of a scene before it is read, at the moment it begins with; `part`: of the field. Reads headers alone, and what they
/// cannot tell is missing: surfaces that are cut out, files of other kinds than image data, .vtp, .ply and .stl, and a
/// scalar of the field where the surface may have one of its own, and whether it is in pieces. Where the box of a
/// built-in flow follows from the surface its bricks are as if its spacing were the same along all axes: no others are
/// shorter. Throws InputError like loadScene().
SceneSizes sizesOf(const SceneDescription& description, const FieldPart& part);

/// The same of all steps that the description's frames show, one after the other, each to `take`: which may have some
/// already when a header is found to be wrong. Cost: a header a step and source.
void forEachStepShown(const SceneDescription& description, const FieldPart& part,
                      const std::function<void(const SceneSizes&)>& take);

}  // namespace aeolic
