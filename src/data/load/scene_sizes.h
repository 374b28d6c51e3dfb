#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "aeolic/scene_description.h"
#include "data/scene.h"

namespace aeolic {

/// How large a scene's data are: what a device must have room for. Before data are read, this is what headers tell.
struct SceneSizes {
    struct Surface {
        std::string name;
        std::uint64_t points = 0, triangles = 0;         ///< points: 0 where it is not told.
        std::uint64_t cellVectors = 0, cellScalars = 0;  ///< As many as triangles, or none.
    };
    std::optional<Surface> surface;               ///< Several surfaces as one, as far as they are told.
    bool inPieces = false;                        ///< Only a piece of the surface is here.
    std::optional<GridField> field, scalarField;  ///< Without samples; where the field is split, this part's brick.
};

/// The sizes of a scene in memory.
SceneSizes sizesOf(const Scene& scene);

/// The sizes of a scene before it is read, at the moment it begins with; `part`: which of the field. Reads headers
/// alone. What they cannot tell is missing: surfaces that are cut out, files of other kinds than image data, .vtp, .ply
/// and .stl, a scalar of the field where the surface may have one of its own, and whether the surface is in pieces. The
/// box of a built-in flow follows from the surface. Its bricks are those of a cube then: no others are shorter. Throws
/// InputError.
SceneSizes sizesOf(const SceneDescription& description, const FieldPart& part);

/// Hands `take` the sizes of every step that the description's frames show, one after the other. When a header is found
/// to be wrong, `take` may have had some already. Throws InputError. Cost: a header a step and source.
void forEachStepShown(const SceneDescription& description, const FieldPart& part,
                      const std::function<void(const SceneSizes&)>& take);

/// Bytes that the whole field takes in memory, by its file's header. 0 where the surface carries its own
/// vectors, and where it cannot be told before reading. Throws InputError.
std::uint64_t fieldBytesOf(const SceneDescription& description);

/// Bytes of the files of a surface that can be split into pieces: those of a .pvtp of several pieces, or of the
/// steps of such files that are in memory together. 0 for any other surface. Throws InputError.
std::uint64_t pieceFileBytesOf(const SceneDescription& description);

/// Throws InputError where pieceFileBytesOf() would not find the file that lists the pieces. Starts no reader, and so
/// passes over series. Each rank reads pieces of its own, and may have been started where the file is not.
void requireListOfPieces(const SceneDescription& description);

}  // namespace aeolic
