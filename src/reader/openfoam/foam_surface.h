#pragma once

#include <string>
#include <vector>

#include "data/piece_run.h"
#include "reader/openfoam/foam_case.h"
#include "reader/parts/part_source.h"

namespace aeolic {

/// A patch of the whole case, whatever folders its faces lie in.
struct FoamPart {
    std::string region, patch, type;
    std::vector<std::string> groups;
    std::uint64_t faces = 0;
    std::string name() const { return region.empty() ? patch : region + "/" + patch; }
};

/// All patches but those between processors, in the order of the files. `time`: that of the mesh, where it changes.
std::vector<FoamPart> foamPatches(const FoamCase& foam, double time);

/// Reads the patches as polygons with values on them, in the order of the mesh's faces, whatever order the parts are
/// in. The faces of a decomposed case come in the order that they have in the whole mesh, where each processor says it
/// (faceProcAddressing), else one processor after the other, and points that lie at the same place are one: the surface
/// is that of the case put together again. `run`: only the faces of these folders, perhaps none; joined by their places
/// they are those of all. Throws InputError.
PartMesh readFoamPatches(const FoamCase& foam, const std::vector<FoamPart>& parts, double time,
                         const std::vector<FoamField>& fields, const PieceRun& run);

}  // namespace aeolic
